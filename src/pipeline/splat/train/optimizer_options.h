// How fast each kind of parameter is learnt: the same for the device (optimizer.h) and the reference
// (reference_optimizer.h).
#pragma once

#include <cstdint>
#include <vector>

namespace macula::splat {

// Step sizes of Adam (Kingma and Ba 2015): how far a parameter moves in a step while its gradients agree. A
// position moves along the axes of its splat, in parts of the standard deviation that it has there: what is
// thin is placed with care, what is large moves far, and nothing depends on the unit of length. The moments
// of positions are along these axes, and turn with them. Rates of all else are, unless given, those of the
// hybrid system that the peripheral model follows (700 steps from 12 to 16 views).
struct OptimizerOptions {
    double position = 0.05;         // of the deviation, up to step decayFrom
    double positionAtLast = 0.005;  // from step positionSteps on; the logarithm is linear between
    std::uint64_t decayFrom = 0;
    std::uint64_t positionSteps = 700;
    double othersAtLast = 1.0;  // all other rates become that part of themselves, over the same steps
    double logScale = 0.007;
    double rotation = 0.002;
    double opacityLogit = 0.05;
    double dc = 0.0025;
    double sh = 0.0025 / 20.0;
    double beta1 = 0.9;      // 0 to below 1
    double beta2 = 0.999;    // 0 to below 1
    double epsilon = 1e-15;  // 1e-30 to 1
};

// The learning rates by component (shared/splat_layout.h), of positions in deviations; for the step after
// `stepsDone` of the whole model.
std::vector<float> learningRates(const OptimizerOptions& options, int shDegree, std::uint64_t stepsDone);

}  // namespace macula::splat
