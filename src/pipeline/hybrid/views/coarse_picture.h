// The coarse picture that a person sees in motion while there is no model: a model must be better than this.
#pragma once

#include "pipeline/splat/train/loss_options.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::hybrid {

// The view as a picture of `lines` lines that is scaled up: nearest-neighbour decimation, which keeps the
// noise of each pixel, and bilinear magnification to the size of the view. A view with no more lines stays as
// it is. A pixel interpolated from unknown (not finite) ones is unknown too.
splat::TrainingView coarselyShown(const splat::TrainingView& view, int lines);

// The mean absolute difference between both, as Trainer::differenceTo measures that of a model. Unknown
// pixels count as equal.
double coarseDifference(const splat::TrainingView& view, int lines, const splat::LossOptions& loss);

}  // namespace macula::hybrid
