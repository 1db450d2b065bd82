#include "pipeline/hybrid/model/training_rounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace macula::hybrid {

namespace {

// How far the rates have fallen, as in learningRates: from 0, not at all, to 1, all the way.
double fallen(const splat::OptimizerOptions& rates, std::uint64_t stepsDone) {
    if (stepsDone >= rates.positionSteps) return 1.0;
    if (stepsDone <= rates.decayFrom) return 0.0;
    return double(stepsDone - rates.decayFrom) / double(rates.positionSteps - rates.decayFrom);
}

}  // namespace

splat::OptimizerOptions following(splat::OptimizerOptions rates, const RateSchedule& schedule) {
    rates.position = schedule.position;
    for (double* rate : {&rates.logScale, &rates.rotation, &rates.opacityLogit, &rates.dc, &rates.sh})
        *rate *= schedule.others;
    rates.othersAtLast /= schedule.others;  // relative to the first rate
    rates.decayFrom = schedule.holdUntil;
    rates.positionSteps = schedule.fallUntil;
    return rates;
}

splat::TrainerOptions comparedAsJudged(splat::TrainerOptions options) {
    options.stages = {{.firstStep = 0, .halvings = 0}};
    return options;
}

bool isSettled(const splat::TrainerOptions& options, std::uint64_t stepsDone) {
    return stepsDone >= options.optimizer.positionSteps;
}

splat::TrainerOptions settling(splat::TrainerOptions options, std::uint64_t stepsDone, std::uint64_t steps) {
    const splat::OptimizerOptions& rates = options.optimizer;
    // The learning rates continue from where they are now, and fall at once.
    const double share = fallen(rates, stepsDone);
    options.optimizer =
        following(rates, {.position = rates.position * std::pow(rates.positionAtLast / rates.position, share),
                          .others = std::pow(rates.othersAtLast, share),
                          .holdUntil = stepsDone,
                          .fallUntil = stepsDone + std::max<std::uint64_t>(steps, 1)});
    options.density.lastStep = std::min(options.density.lastStep, stepsDone);
    return comparedAsJudged(std::move(options));
}

}  // namespace macula::hybrid
