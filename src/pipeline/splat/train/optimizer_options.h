// The learning rate of each kind of parameter: the same for the device (optimizer.h) and the reference
// (reference_optimizer.h).
#pragma once

#include <cstdint>
#include <vector>

namespace macula::splat {

// Step sizes of Adam (Kingma and Ba 2015): how far a parameter moves in a step while its gradients agree. A
// position moves along the axes of its splat, in fractions of the standard deviation along each: thin splats
// are placed with care, large ones move far, and nothing depends on the unit of length. The moments of
// positions are along these axes, and turn with them. The default rates of the other parameters are those of
// the hybrid system that the peripheral model follows (700 steps from 12 to 16 views).
struct OptimizerOptions {
    double position = 0.05;         // of the standard deviation, up to step decayFrom
    double positionAtLast = 0.005;  // from step positionSteps on; in between the logarithm is linear
    std::uint64_t decayFrom = 0;
    std::uint64_t positionSteps = 700;
    double othersAtLast = 1.0;  // factor that all other rates reach, over the same steps
    double logScale = 0.007;
    double rotation = 0.002;
    double opacityLogit = 0.05;
    double dc = 0.0025;
    double sh = 0.0025 / 20.0;
    double beta1 = 0.9;      // 0 to below 1
    double beta2 = 0.999;    // 0 to below 1
    double epsilon = 1e-15;  // 1e-30 to 1
};

// The learning rates by component (shared/splat_layout.h), those of positions in standard deviations, for the
// step after `stepsDone` steps of the whole model.
std::vector<float> learningRates(const OptimizerOptions& options, int shDegree, std::uint64_t stepsDone);

}  // namespace macula::splat
