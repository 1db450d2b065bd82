// How a model trains for an open number of steps: in rounds. Learning rates fall in each, and a round ends
// early when it is of no more use.
#pragma once

#include <cstdint>

#include "pipeline/splat/train/trainer_options.h"

namespace macula::hybrid {

// The learning rates from which a training goes on: they hold until step `holdUntil`, and have fallen to
// their last at step `fallUntil`.
struct RateSchedule {
    double position = 0.0;  // learning rate of positions, to begin with
    double others = 1.0;    // all other rates times this, to begin with; their last stay what they are
    std::uint64_t holdUntil = 0;
    std::uint64_t fallUntil = 0;
};
splat::OptimizerOptions following(splat::OptimizerOptions rates, const RateSchedule& schedule);

// Options that compare whole pictures by absolute differences from the first step to the last, never by
// squares. What is shown is chosen by absolute differences (Trainer::differenceTo); squares give the model
// the light that these leave out, 2 to 5 % where pictures are noisy, but may raise that error, and then the
// older copy stays shown.
splat::TrainerOptions comparedAsJudged(splat::TrainerOptions options);

// Whether all learning rates have come to their last values.
bool isSettled(const splat::TrainerOptions& options, std::uint64_t stepsDone);

// Options in which learning rates go on from where they are after `stepsDone`, without a jump, and come to
// the same last values within `steps` steps; splats are neither split nor removed any more, and pictures are
// as comparedAsJudged has them.
splat::TrainerOptions settling(splat::TrainerOptions options, std::uint64_t stepsDone, std::uint64_t steps);

}  // namespace macula::hybrid
