// How rates come to rest, whenever that is begun.
#include "pipeline/hybrid/model/training_rounds.h"

#include <gtest/gtest.h>

#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/hybrid/model/refinement.h"

namespace macula::hybrid {
namespace {

TEST(TrainingRounds, SettleWithoutAJump) {
    const splat::TrainerOptions first = trainerOptions({.iterations = 700});
    const splat::TrainerOptions later =
        refinementTraining(first, {.steps = 700, .splats = 10800}, {.iterations = 1000});
    for (const auto& [round, end] : {std::pair(first, 700u), std::pair(later, 1700u)}) {
        const auto last = splat::learningRates(round.optimizer, 1, end);
        for (const std::uint64_t now : {50u, 300u, 600u, 690u, 900u, 1650u, 5000u}) {
            const splat::TrainerOptions settled = settling(round, now, 100);
            EXPECT_FALSE(isSettled(settled, now));
            EXPECT_FALSE(isSettled(settled, now + 99));
            EXPECT_TRUE(isSettled(settled, now + 100));
            const auto before = splat::learningRates(round.optimizer, 1, now);
            const auto after = splat::learningRates(settled.optimizer, 1, now);
            const auto atLast = splat::learningRates(settled.optimizer, 1, now + 100);
            for (std::size_t i = 0; i < last.size(); ++i) {
                EXPECT_NEAR(after[i], before[i], 1e-5f * before[i]) << now;
                EXPECT_NEAR(atLast[i], last[i], 1e-5f * last[i]) << now;
            }
            ASSERT_EQ(settled.stages.size(), 1u);
            EXPECT_EQ(settled.stages[0].measure, splat::LossMeasure::similar);
            EXPECT_LE(settled.density.lastStep, now) << "splits end";
        }
    }
    EXPECT_FALSE(isSettled(first, 699));
    EXPECT_TRUE(isSettled(first, 700));
}

}  // namespace
}  // namespace macula::hybrid
