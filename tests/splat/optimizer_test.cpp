// The optimiser in double, and what both share: against closed forms of Adam.
#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/splat/reference_optimizer.h"
#include "shared/splat_layout.h"

namespace macula::splat {
namespace {

TEST(LearningRates, AreByKindAndThatOfPositionsDecays) {
    const OptimizerOptions options{
        .extentMm = 250.0, .logScale = 1, .rotation = 2, .opacityLogit = 3, .dc = 4, .sh = 5};
    const std::vector<float> rates = learningRates(options, 1, 0);
    ASSERT_EQ(rates.size(), 23u);
    const std::vector<float> rest{1, 1, 1, 2, 2, 2, 2, 3, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5};
    EXPECT_EQ(std::vector<float>(rates.begin() + 3, rates.end()), rest);
    for (const std::size_t axis : {0u, 1u, 2u}) {
        EXPECT_NEAR(rates[axis], 250 * 1.6e-4, 1e-7);
        EXPECT_NEAR(learningRates(options, 0, 350)[axis], 250 * 1.6e-5,
                    1e-8);  // half-way: the geometric mean
        EXPECT_NEAR(learningRates(options, 0, 700)[axis], 250 * 1.6e-6, 1e-9);
        EXPECT_NEAR(learningRates(options, 0, 1000000)[axis], 250 * 1.6e-6, 1e-9);
    }
    EXPECT_EQ(learningRates(options, 0, 0).size(), 14u);
}

TEST(LearningRates, StayUntilTheyDecayAndOthersFallWithThem) {
    const OptimizerOptions options{.extentMm = 2.0,
                                   .position = 0.1,
                                   .positionAtLast = 0.001,
                                   .decayFrom = 100,
                                   .positionSteps = 300,
                                   .othersAtLast = 0.25,
                                   .logScale = 1,
                                   .rotation = 2,
                                   .opacityLogit = 3,
                                   .dc = 4,
                                   .sh = 5};
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
// the rate.
TEST(ReferenceOptimizer, MovesByTheRateWhileTheGradientStays) {
    const OptimizerOptions options{.extentMm = 100.0, .positionAtLast = 1.6e-4};
    ReferenceOptimizer optimizer(2, 0, options);
    std::vector<double> parameters(28, 0.0);
    std::vector<double> gradients(28);
    for (std::size_t i = 0; i < 28; ++i)
        gradients[i] = (i % 3 == 0 ? -1.0 : 1.0) * std::pow(10.0, double(i) / 3.0 - 7.0);
    for (int step = 1; step <= 20; ++step) {
        // The second one is born at step 11.
        optimizer.step(parameters, gradients, std::vector<std::uint32_t>{7, step > 10 ? 1u : 0u});
        const std::vector<float> rates = learningRates(options, 0, 0);
        for (std::size_t i = 0; i < 28; ++i) {
            const double steps = i % 2 == 0 ? step : std::max(0, step - 10);
            EXPECT_NEAR(parameters[i], -steps * double(rates[i / 2]) * (gradients[i] > 0 ? 1 : -1),
                        1e-6 * steps * double(rates[i / 2]));
        }
    }
    EXPECT_EQ(optimizer.steps(), (std::vector<std::uint32_t>{20, 10}));
}

// Two steps by hand: g = 1, then -1, with beta1 0.5 and beta2 0.75.
TEST(ReferenceOptimizer, IsAdam) {
    const OptimizerOptions options{
        .extentMm = 1.0, .opacityLogit = 0.1, .beta1 = 0.5, .beta2 = 0.75, .epsilon = 0.01};
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

}  // namespace
}  // namespace macula::splat
