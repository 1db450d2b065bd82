// How a model goes on: without a jump.
#include "pipeline/hybrid/model/refinement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/hybrid/model/first_model.h"

namespace macula::hybrid {
namespace {

const splat::TrainingReport kNow{.steps = 700, .splats = 10800};

TEST(Refinement, NoRateIsFarFromTheLastOneAndAllFallBackToIt) {
    const splat::TrainerOptions before = trainerOptions({.iterations = 700});
    const splat::TrainerOptions after = refinementTraining(before, kNow, {.iterations = 2000});
    const auto last = splat::learningRates(before.optimizer, 1, 700);
    const auto first = splat::learningRates(after.optimizer, 1, 700);
    const auto middle = splat::learningRates(after.optimizer, 1, 1700);
    const auto end = splat::learningRates(after.optimizer, 1, 2700);
    for (std::size_t i = 0; i < last.size(); ++i) {
        EXPECT_GE(first[i], last[i]);
        EXPECT_LE(first[i], 7.001f * last[i]);
        EXPECT_LE(first[i], 1.0001f * splat::learningRates(before.optimizer, 1, 0)[i]);
        EXPECT_LT(middle[i], first[i]);
        EXPECT_LT(end[i], middle[i]);
        EXPECT_NEAR(end[i], last[i], 1e-5f * last[i]);
    }
    const splat::TrainerOptions again =
        refinementTraining(after, {.steps = 2700, .splats = 50000}, {.iterations = 2000});
    for (const std::uint64_t step : {0u, 1000u, 2000u}) {
        const auto once = splat::learningRates(after.optimizer, 1, 700 + step);
        const auto twice = splat::learningRates(again.optimizer, 1, 2700 + step);
        for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(twice[i], once[i], 1e-5f * once[i]) << step;
    }
}

TEST(Refinement, SplitsInShortRoundsToo) {
    for (const std::uint64_t iterations : {10u, 30u, 100u, 130u}) {
        const splat::DensityOptions density =
            refinementTraining(trainerOptions({}), kNow, {.iterations = iterations}).density;
        EXPECT_GE(density.lastStep, density.firstStep) << iterations;
        EXPECT_LE(density.lastStep, 700 + iterations / 2) << iterations;
    }
}

TEST(Refinement, FillsTheRoomThereIsWhileThereIsTime) {
    for (const std::uint64_t iterations : {1000u, 2000u, 4000u}) {
        const splat::TrainerOptions after =
            refinementTraining(trainerOptions({}), kNow, {.iterations = iterations});
        const splat::DensityOptions& density = after.density;
        EXPECT_EQ(after.capacity, 50000u);
        EXPECT_GT(density.firstStep, 700u);
        EXPECT_LT(density.lastStep, 700u + iterations);
        const std::uint64_t splits = (density.lastStep - density.firstStep) / density.every + 1;
        EXPECT_GT(10800.0 * std::pow(1.0 + density.splitShare, double(splits)), 50000.0);
        EXPECT_LE(density.splitShare, 0.22);
        EXPECT_EQ(density.unseenShare, 0.0) << "what is learnt is not given up";
        ASSERT_EQ(after.stages.size(), 2u);
        for (const splat::TrainingStage& stage : after.stages) EXPECT_EQ(stage.halvings, 0);
        EXPECT_EQ(after.stages[1].measure, splat::LossMeasure::squared);
        EXPECT_EQ(after.stages[1].firstStep, kNow.steps + iterations * 9 / 10);
    }
    // No room, no time, no splats: still options that make sense.
    for (const auto& [splats, iterations] : {std::pair{60000u, 2000u}, {10u, 0u}, {0u, 1u}}) {
        const splat::TrainerOptions after = refinementTraining(
            trainerOptions({}), {.steps = 700, .splats = splats}, {.iterations = iterations});
        EXPECT_GT(after.density.splitShare, 0.0);
        EXPECT_LE(after.density.splitShare, 0.22);
    }
}

}  // namespace
}  // namespace macula::hybrid
