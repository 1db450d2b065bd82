#include "pipeline/hybrid/model/training_rounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace macula::hybrid {

namespace {

// How far the rates have fallen, as learningRates has it: 0 not at all, 1 all the way.
double fallen(const splat::OptimizerOptions& rates, std::uint64_t stepsDone) {
    if (stepsDone >= rates.positionSteps) return 1.0;
    if (stepsDone <= rates.decayFrom) return 0.0;
    return double(stepsDone - rates.decayFrom) / double(rates.positionSteps - rates.decayFrom);
}

}  // namespace

splat::TrainerOptions comparedAsJudged(splat::TrainerOptions options) {
    options.stages = {{.firstStep = 0, .halvings = 0}};
    return options;
}

bool isSettled(const splat::TrainerOptions& options, std::uint64_t stepsDone) {
    return stepsDone >= options.optimizer.positionSteps;
}

splat::TrainerOptions settling(splat::TrainerOptions options, std::uint64_t stepsDone, std::uint64_t steps) {
    splat::OptimizerOptions& rates = options.optimizer;
    const double share = fallen(rates, stepsDone);
    rates.position *= std::pow(rates.positionAtLast / rates.position, share);
    const double others = std::pow(rates.othersAtLast, share);
    for (double* rate : {&rates.logScale, &rates.rotation, &rates.opacityLogit, &rates.dc, &rates.sh})
        *rate *= others;
    rates.othersAtLast /= others;
    rates.decayFrom = stepsDone;
    rates.positionSteps = stepsDone + std::max<std::uint64_t>(steps, 1);
    options.density.lastStep = std::min(options.density.lastStep, stepsDone);
    return comparedAsJudged(std::move(options));
}

}  // namespace macula::hybrid
