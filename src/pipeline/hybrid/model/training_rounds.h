// How a model trains for an open number of steps: in rounds. Learning rates fall in each, and a round ends
// early when the error no longer falls.
#pragma once

#include <cstdint>

#include "pipeline/splat/train/trainer_options.h"

namespace macula::hybrid {

// The learning rates with which a training continues: constant until step `holdUntil`, then falling to their
// last values at step `fallUntil`.
struct RateSchedule {
    double position = 0.0;  // first learning rate of positions
    double others = 1.0;    // factor of all other rates at first; last values stay
    std::uint64_t holdUntil = 0;
    std::uint64_t fallUntil = 0;
};
splat::OptimizerOptions following(splat::OptimizerOptions rates, const RateSchedule& schedule);

// Options that compare full-size pictures by absolute differences in all steps, never by squared ones. Splats
// are chosen for display by absolute differences (Trainer::differenceTo). Squared ones would add the 2 to 5 %
// of light that a model of noisy pictures lacks, but may raise that error, and then the older splats would
// stay on screen.
splat::TrainerOptions comparedAsJudged(splat::TrainerOptions options);

// Whether all learning rates have reached their last values.
bool isSettled(const splat::TrainerOptions& options, std::uint64_t stepsDone);

// Options in which learning rates continue from their values after `stepsDone`, without a jump, and reach the
// same last values within `steps` steps. Splats are neither split nor removed any more, and pictures are
// compared as in comparedAsJudged.
splat::TrainerOptions settling(splat::TrainerOptions options, std::uint64_t stepsDone, std::uint64_t steps);

}  // namespace macula::hybrid
