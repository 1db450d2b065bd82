// How long the device is free between two frames, by a made-up clock.
#include "live/frame/hand_rhythm.h"

#include <gtest/gtest.h>

namespace macula::live {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

class HandRhythmTest : public testing::Test {
  protected:
    HandRhythm rhythm_;
    HandRhythm::TimePoint now_{};

    void inputs(int count, microseconds every) {
        for (int i = 0; i < count; ++i) rhythm_.input(now_ += every, true);
    }
    double leftMsAfter(microseconds time) const { return rhythm_.leftMs(now_ + time); }
};

TEST_F(HandRhythmTest, WhatAFrameLeavesOfAPeriodIsFree) {
    inputs(10, milliseconds(16));
    EXPECT_NEAR(leftMsAfter(milliseconds(5)), 10.0, 1e-9);
    EXPECT_NEAR(leftMsAfter(milliseconds(8)), 7.0, 1e-9);
    // On a slow device the frame takes all of it and more.
    EXPECT_EQ(leftMsAfter(milliseconds(15)), 0.0);
    EXPECT_EQ(leftMsAfter(milliseconds(16)), 0.0);
    EXPECT_EQ(leftMsAfter(milliseconds(5000)), 0.0);
}

TEST_F(HandRhythmTest, NobodyKnowsBeforeAFewInputsOrAtRest) {
    EXPECT_EQ(leftMsAfter(milliseconds(0)), 0.0);
    inputs(2, milliseconds(16));
    EXPECT_EQ(leftMsAfter(milliseconds(1)), 0.0);
    inputs(1, milliseconds(16));
    EXPECT_GT(leftMsAfter(milliseconds(1)), 0.0);
    rhythm_.input(now_ += milliseconds(16), false);
    EXPECT_EQ(leftMsAfter(milliseconds(1)), 0.0);
    inputs(2, milliseconds(16));
    EXPECT_EQ(leftMsAfter(milliseconds(1)), 0.0);
}

TEST_F(HandRhythmTest, TheShortestOfTheLastGapsCounts) {
    inputs(4, milliseconds(16));
    inputs(1, milliseconds(7));
    EXPECT_NEAR(leftMsAfter(milliseconds(2)), 4.0, 1e-9);
    inputs(int(HandRhythm::kRemembered), milliseconds(16));
    EXPECT_NEAR(leftMsAfter(milliseconds(2)), 13.0, 1e-9);
}

TEST_F(HandRhythmTest, AHandThatPausedBeginsAnew) {
    inputs(6, milliseconds(16));
    inputs(1, milliseconds(700));
    EXPECT_EQ(leftMsAfter(milliseconds(1)), 0.0);
    inputs(2, milliseconds(8));
    EXPECT_NEAR(leftMsAfter(milliseconds(1)), 6.0, 1e-9);
    rhythm_.input(now_, true);  // the same once more, and one from before
    rhythm_.input(now_ - milliseconds(50), true);
    EXPECT_NEAR(leftMsAfter(milliseconds(1)), 6.0, 1e-9);
}

// A mouse that is heard of a thousand times a second.
TEST_F(HandRhythmTest, WhereInputsAreDenseNothingIsFree) {
    inputs(20, milliseconds(1));
    EXPECT_EQ(leftMsAfter(microseconds(0)), 0.0);
}

}  // namespace
}  // namespace macula::live
