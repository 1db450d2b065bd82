#include "evaluate/measurement.h"

#include <gtest/gtest.h>

namespace macula::evaluate {
namespace {

TEST(Median, IsTheMiddleOrTheMeanOfBothInTheMiddle) {
    EXPECT_EQ(median({3.0}), 3.0);
    EXPECT_EQ(median({5.0, 1.0, 2.0}), 2.0);
    EXPECT_EQ(median({8.0, 1.0, 2.0, 4.0}), 3.0);
}

TEST(MedianMs, IsOfAllTurnsButTheFirstAndFailsAsTheWork) {
    int calls = 0;
    const auto ms = medianMs(3, [&]() -> Result<void> {
        ++calls;
        return {};
    });
    ASSERT_TRUE(ms.ok());
    EXPECT_GE(*ms, 0.0);
    EXPECT_EQ(calls, 4);
    const auto failed = medianMs(3, [&]() -> Result<void> {
        if (++calls == 6) return cancelledError();
        return {};
    });
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().code, ErrorCode::cancelled);
    EXPECT_EQ(calls, 6);
}

// A busy neighbour that slows one turn of both changes neither ratio.
TEST(Contender, IsComparedTurnByTurn) {
    const Contender ours{.turns = {{10.0, 20.0}, {100.0, 20.0}, {12.0, 30.0}}};
    const Contender theirs{.turns = {{20.0, 10.0}, {200.0, 10.0}, {24.0, 10.0}}};
    const Ratio ratio = ours.ratioTo(theirs);
    EXPECT_DOUBLE_EQ(ratio.wall, 0.5);
    EXPECT_DOUBLE_EQ(ratio.cpu, 2.0);
    EXPECT_EQ(ours.medians().wallMs, 12.0);
    EXPECT_EQ(ours.medians().cpuMs, 20.0);
    EXPECT_DOUBLE_EQ(ours.ratioTo(ours).wall, 1.0);
}

TEST(Contender, ThatTookNoTimeTookATick) {
    const Contender ours{.turns = {{1.0, 1.0}}};
    const Contender none{.turns = {{0.0, 0.0}}};
    EXPECT_DOUBLE_EQ(ours.ratioTo(none).wall, 1000.0);
    EXPECT_DOUBLE_EQ(none.ratioTo(ours).cpu, 0.0);
}

TEST(Spent, IsNeverLessThanNothing) {
    const Spent left = Spent{3.0, 1.0} - Spent{1.0, 2.0};
    EXPECT_EQ(left.wallMs, 2.0);
    EXPECT_EQ(left.cpuMs, 0.0);
    EXPECT_EQ((Spent{3.0, 1.0} / 2.0).wallMs, 1.5);
}

TEST(Timed, FailsAsTheWork) {
    const auto failed = timed([]() -> Result<void> {
        return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
    });
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().code, ErrorCode::cancelled);
    int runs = 0;
    const auto spent = timed([&]() -> Result<void> {
        ++runs;
        return {};
    });
    ASSERT_TRUE(spent);
    EXPECT_EQ(runs, 1);
    EXPECT_GE(spent->wallMs, 0.0);
}

}  // namespace
}  // namespace macula::evaluate
