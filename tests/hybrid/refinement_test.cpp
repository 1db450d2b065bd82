// How a model goes on: without a jump.
#include "pipeline/hybrid/refinement.h"

#include <gtest/gtest.h>

#include "pipeline/hybrid/first_model.h"

namespace macula::hybrid {
namespace {

TEST(Refinement, GoesOnWithTheRatesOfTheLastStep) {
    const FirstModelOptions first{.iterations = 700};
    const splat::TrainerOptions before = trainerOptions(first, 2.5);
    const splat::TrainerOptions after = refinementTraining(before, 700, {.iterations = 2000});
    EXPECT_EQ(splat::learningRates(after.optimizer, 1, 700), splat::learningRates(before.optimizer, 1, 700));
    const auto middle = splat::learningRates(after.optimizer, 1, 1700);
    const auto last = splat::learningRates(after.optimizer, 1, 2700);
    for (std::size_t i = 0; i < middle.size(); ++i) {
        EXPECT_LE(middle[i], splat::learningRates(before.optimizer, 1, 700)[i]);
        EXPECT_LE(last[i], middle[i]);
        EXPECT_GT(last[i], 0.0f);
    }
}

TEST(Refinement, HasRoomForMoreAndTimeToUseIt) {
    const splat::TrainerOptions after = refinementTraining(trainerOptions({}, 2.5), 700, {});
    EXPECT_EQ(after.capacity, 50000u);
    EXPECT_GT(after.density.firstStep, 700u);
    EXPECT_LT(after.density.lastStep, 2700u);
    // Room is filled before the last split.
    const double regroups =
        double(after.density.lastStep - after.density.firstStep) / double(after.density.every) + 1;
    EXPECT_GT(11000.0 * std::pow(1.0 + after.density.splitShare, regroups), 50000.0);
    ASSERT_EQ(after.stages.size(), 1u);
    EXPECT_EQ(after.stages[0].halvings, 0);
}

}  // namespace
}  // namespace macula::hybrid
