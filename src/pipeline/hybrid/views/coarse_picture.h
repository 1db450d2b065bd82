// The picture that a person sees while there is no model of what is shown: what a model has to be better
// than.
#pragma once

#include "pipeline/splat/train/loss_options.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::hybrid {

// The view as a picture of so many lines shows it that is scaled to the size of the view, linearly: of
// every few pixels one, with the noise that it has. The view itself, where that has no more lines. What is
// mixed with pixels that are not known is not known.
splat::TrainingView coarselyShown(const splat::TrainingView& view, int lines);

// Mean absolute difference between both, as Trainer::differenceTo measures that of a model; where the coarse
// picture is not known there is none.
double coarseDifference(const splat::TrainingView& view, int lines, const splat::LossOptions& loss);

}  // namespace macula::hybrid
