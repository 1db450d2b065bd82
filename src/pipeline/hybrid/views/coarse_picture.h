// The picture that a person sees while there is no model of what is shown: what a model has to be better
// than.
#pragma once

#include "pipeline/splat/train/loss_options.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::hybrid {

// The view as a person sees it in a picture of `lines` lines that is scaled up: nearest-neighbour decimation,
// which keeps the noise of each pixel, and bilinear magnification to the size of the view. A view of no more
// lines stays as it is. A pixel that is mixed with unknown (not finite) ones is unknown too.
splat::TrainingView coarselyShown(const splat::TrainingView& view, int lines);

// Mean absolute difference between both, as Trainer::differenceTo measures that of a model; where the coarse
// picture is not known there is none.
double coarseDifference(const splat::TrainingView& view, int lines, const splat::LossOptions& loss);

}  // namespace macula::hybrid
