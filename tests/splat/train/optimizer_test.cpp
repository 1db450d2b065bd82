// The optimiser in double, and what both share: against closed forms of Adam.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "pipeline/splat/train/reference_optimizer.h"
#include "shared/splat_layout.h"

namespace macula::splat {
namespace {

// Each kind but positions by its number.
constexpr OptimizerOptions kNumbered{.logScale = 1, .rotation = 2, .opacityLogit = 3, .dc = 4, .sh = 5};

TEST(LearningRates, AreByKindAndThatOfPositionsDecays) {
    OptimizerOptions options = kNumbered;
    options.position = 0.04;
    options.positionAtLast = 0.0004;
    const std::vector<float> rates = learningRates(options, 1, 0);
    ASSERT_EQ(rates.size(), 23u);
    const std::vector<float> rest{1, 1, 1, 2, 2, 2, 2, 3, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5};
    EXPECT_EQ(std::vector<float>(rates.begin() + 3, rates.end()), rest);
    for (const std::size_t axis : {0u, 1u, 2u}) {
        EXPECT_NEAR(rates[axis], 0.04, 1e-8);
        EXPECT_NEAR(learningRates(options, 0, 350)[axis], 0.004, 1e-9);  // half-way: the geometric mean
        EXPECT_NEAR(learningRates(options, 0, 700)[axis], 0.0004, 1e-10);
        EXPECT_NEAR(learningRates(options, 0, 1000000)[axis], 0.0004, 1e-10);
    }
    EXPECT_EQ(learningRates(options, 0, 0).size(), 14u);
}

TEST(LearningRates, StayUntilTheyDecayAndOthersFallWithThem) {
    OptimizerOptions options = kNumbered;
    options.position = 0.2;
    options.positionAtLast = 0.002;
    options.decayFrom = 100;
    options.positionSteps = 300;
    options.othersAtLast = 0.25;
    struct Expected {
        std::uint64_t step;
        double position;
        double others;
    };
    for (const auto& [step, position, others] :
         {Expected{0, 0.2, 1}, {100, 0.2, 1}, {200, 0.02, 0.5}, {300, 0.002, 0.25}, {9999, 0.002, 0.25}}) {
        const std::vector<float> rates = learningRates(options, 1, step);
        EXPECT_NEAR(rates[shared::kSplatPosition], position, 1e-6) << step;
        EXPECT_NEAR(rates[shared::kSplatLogScale], 1 * others, 1e-6) << step;
        EXPECT_NEAR(rates[shared::kSplatRotation], 2 * others, 1e-6) << step;
        EXPECT_NEAR(rates[shared::kSplatOpacity], 3 * others, 1e-6) << step;
        EXPECT_NEAR(rates[shared::kSplatDc], 4 * others, 1e-6) << step;
        EXPECT_NEAR(rates[shared::kSplatSh], 5 * others, 1e-6) << step;
    }
}

// With a gradient that never changes each corrected moment is the gradient (or its square), so every step is
// the rate. That of positions is in deviations: of 1 mm, and of axes that are the world's, while these stay.
TEST(ReferenceOptimizer, MovesByTheRateWhileTheGradientStays) {
    for (const bool axesStay : {false, true}) {
        OptimizerOptions options{.positionAtLast = 0.05};
        if (axesStay) options.logScale = options.rotation = 0.0;
        ReferenceOptimizer optimizer(2, 0, options);
        std::vector<double> parameters(28, 0.0);
        std::vector<double> gradients(28);
        for (std::size_t i = 0; i < 28; ++i)
            gradients[i] = (i % 3 == 0 ? -1.0 : 1.0) * std::pow(10.0, double(i) / 3.0 - 7.0);
        for (int step = 1; step <= 20; ++step) {
            // The second one is born at step 11.
            optimizer.step(parameters, gradients, std::vector<std::uint32_t>{7, step > 10 ? 1u : 0u});
            const std::vector<float> rates = learningRates(options, 0, 0);
            for (std::size_t i = axesStay ? 0 : 2 * shared::kSplatLogScale; i < 28; ++i) {
                const double steps = i % 2 == 0 ? step : std::max(0, step - 10);
                EXPECT_NEAR(parameters[i], -steps * double(rates[i / 2]) * (gradients[i] > 0 ? 1 : -1),
                            1e-6 * steps * double(rates[i / 2]));
            }
        }
        EXPECT_EQ(optimizer.steps(), (std::vector<std::uint32_t>{20, 10}));
    }
}

// Two steps by hand: g = 1, then -1, with beta1 0.5 and beta2 0.75.
TEST(ReferenceOptimizer, IsAdam) {
    const OptimizerOptions options{.opacityLogit = 0.1, .beta1 = 0.5, .beta2 = 0.75, .epsilon = 0.01};
    ReferenceOptimizer optimizer(1, 0, options);
    std::vector<double> parameters(14, 0.0);
    std::vector<double> gradients(14, 0.0);
    gradients[shared::kSplatOpacity] = 1.0;
    optimizer.step(parameters, gradients, std::vector<std::uint32_t>{1});
    EXPECT_NEAR(parameters[shared::kSplatOpacity], -0.1 / 1.01, 1e-8);
    gradients[shared::kSplatOpacity] = -1.0;
    optimizer.step(parameters, gradients, std::vector<std::uint32_t>{1});
    // first 0.25 - 0.5 = -0.25, over 1 - 0.25; second 0.1875 + 0.25 = 0.4375, over 1 - 0.5625.
    EXPECT_NEAR(parameters[shared::kSplatOpacity], -0.1 / 1.01 + 0.1 * (0.25 / 0.75) / (1.0 + 0.01), 1e-8);
    EXPECT_EQ(parameters[shared::kSplatDc], 0.0);
}

// Half a turn about (1, 1, 0) takes x to y and y to x, and z to -z.
TEST(ReferenceOptimizer, MovesPositionsByTheDeviationsOfTheirSplat) {
    ReferenceOptimizer optimizer(1, 0, {.position = 0.1, .positionAtLast = 0.1});
    std::vector<double> parameters(14, 0.0);
    const double deviationsMm[]{2.0, 30.0, 0.005};
    for (std::size_t axis = 0; axis < 3; ++axis)
        parameters[shared::kSplatLogScale + axis] = std::log(deviationsMm[axis]);
    parameters[shared::kSplatRotation + 1] = parameters[shared::kSplatRotation + 2] = 7.0;  // any length
    std::vector<double> gradients(14, 0.0);
    gradients[0] = 1e-6;
    gradients[1] = -1e3;
    gradients[2] = -1.0;
    optimizer.step(parameters, gradients, std::vector<std::uint32_t>{1});
    EXPECT_NEAR(parameters[0], -0.1 * 30.0, 1e-6);
    EXPECT_NEAR(parameters[1], 0.1 * 2.0, 1e-6);
    EXPECT_NEAR(parameters[2], 0.1 * 0.005, 1e-9);
}

// As if all had been turned and made larger: no step knows of the world's axes or of the unit of length.
TEST(ReferenceOptimizer, MovesATurnedAndLargerModelAlike) {
    const glm::dquat turn = glm::normalize(glm::dquat(0.3, -0.7, 0.2, 0.5));
    const double larger = 1000.0;
    ReferenceOptimizer one(1, 0, {});
    ReferenceOptimizer other(1, 0, {});
    std::vector<double> a(14, 0.0);
    a[3] = 0.5;
    a[4] = -1.0;
    a[6] = 0.9;
    a[7] = 0.4;
    std::vector<double> b = a;
    const glm::dquat turned = turn * glm::dquat(a[6], a[7], a[8], a[9]);
    for (int k = 0; k < 3; ++k) b[std::size_t(3 + k)] += std::log(larger);
    b[6] = turned.w, b[7] = turned.x, b[8] = turned.y, b[9] = turned.z;
    for (int step = 0; step < 5; ++step) {
        const glm::dvec3 gradient(1.0 + step, -2.0, 0.3 * step);
        std::vector<double> ofOne(14, 0.0);
        std::vector<double> ofOther(14, 0.0);
        const glm::dvec3 there = turn * gradient / larger;
        for (int k = 0; k < 3; ++k) {
            ofOne[std::size_t(k)] = gradient[k];
            ofOther[std::size_t(k)] = there[k];
        }
        one.step(a, ofOne, std::vector<std::uint32_t>{1});
        other.step(b, ofOther, std::vector<std::uint32_t>{1});
    }
    const glm::dvec3 expected = turn * glm::dvec3(a[0], a[1], a[2]) * larger;
    EXPECT_GT(glm::length(expected), 10.0);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(b[std::size_t(k)], expected[k], 1e-6 * glm::length(expected));
}

}  // namespace
}  // namespace macula::splat
