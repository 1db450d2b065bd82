// What is left out so that each frame is in time, and when it comes back.
#include "xr/governor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace macula::xr {
namespace {

constexpr double kPeriodMs = 1000.0 / 30.0;

void note(Governor& governor, double periodMs, double drawnMs) {
    governor.notePeriod(periodMs);
    governor.noteFrame(drawnMs);
}

// A device that takes so long for pictures of full size, and always a little.
struct Device {
    double fullMs = 0.0;
    double alwaysMs = 2.0;
    double drawMs(const Governor& governor) const {
        return alwaysMs + fullMs * governor.quality().scale * governor.quality().scale;
    }
};

void run(Governor& governor, const Device& device, int frames) {
    for (int i = 0; i < frames; ++i) note(governor, kPeriodMs, device.drawMs(governor));
}

TEST(Governor, LowersTheFoveaBeforeThePictures) {
    for (std::size_t level = 1; level < Governor::kLevels.size(); ++level) {
        const FrameQuality& better = Governor::kLevels[level - 1];
        const FrameQuality& worse = Governor::kLevels[level];
        EXPECT_LE(worse.mostSamples, better.mostSamples);
        EXPECT_GE(worse.framesPerFovea, better.framesPerFovea);
        EXPECT_LE(worse.scale, better.scale);
        EXPECT_NE(worse, better);
        if (worse.scale < better.scale) {
            EXPECT_EQ(worse.mostSamples, 1u) << "the fovea goes first";
        }
    }
    Governor governor;
    EXPECT_EQ(governor.quality(), Governor::kLevels[0]);
    // A little too slow: one level after two late frames, and the picture keeps its size.
    note(governor, kPeriodMs, 0.8 * kPeriodMs);
    EXPECT_EQ(governor.level(), 0u) << "one late frame says little";
    note(governor, kPeriodMs, 0.8 * kPeriodMs);
    EXPECT_EQ(governor.level(), 1u);
    EXPECT_EQ(governor.quality().scale, 1.0);
    EXPECT_EQ(governor.stepsDown(), 1u);
}

TEST(Governor, ASlowDeviceIsInTimeAfterAFewFrames) {
    for (const double fullMs : {30.0, 60.0, 120.0, 200.0}) {
        Governor governor;
        const Device device{.fullMs = fullMs};
        run(governor, device, 20);
        EXPECT_LT(device.drawMs(governor), kPeriodMs) << fullMs;
        int late = 0;
        for (int i = 0; i < 2000; ++i) {
            late += device.drawMs(governor) > kPeriodMs ? 1 : 0;
            note(governor, kPeriodMs, device.drawMs(governor));
        }
        EXPECT_LE(late, 20) << fullMs;
    }
}

TEST(Governor, WhatCannotBeInTimeIsDrawnAsSmallAsItMayBe) {
    Governor governor;
    run(governor, {.fullMs = 1e5}, 100);
    EXPECT_EQ(governor.level() + 1, Governor::kLevels.size());
    const std::uint64_t steps = governor.stepsDown();
    run(governor, {.fullMs = 1e5}, 100);
    EXPECT_EQ(governor.stepsDown(), steps);
}

TEST(Governor, ComesBackWhenThereIsRoomAndDoesNotSway) {
    Governor governor;
    run(governor, {.fullMs = 120.0}, 20);
    const std::size_t slow = governor.level();
    ASSERT_GT(slow, 3u);
    run(governor, {.fullMs = 1.0}, Governor::kFramesWithRoom - 1);
    EXPECT_EQ(governor.level(), slow) << "not at once";
    run(governor, {.fullMs = 1.0}, int(slow + 1) * Governor::kFramesWithRoom);
    EXPECT_EQ(governor.level(), 0u);
    EXPECT_EQ(governor.stepsUp(), slow);

    // Between two levels it settles: it does not go to and fro.
    Governor between;
    const Device device{.fullMs = 44.0, .alwaysMs = 0.0};
    run(between, device, 200);
    const std::uint64_t steps = between.stepsDown() + between.stepsUp();
    run(between, device, 3000);
    EXPECT_LE(between.stepsDown() + between.stepsUp(), steps + 2);
}

// The better level is always too slow, which cannot be foreseen: it is tried ever more seldom.
TEST(Governor, ABetterLevelThatDoesNotLastIsTriedMoreSeldom) {
    Governor governor;
    const auto play = [&](int frames) {
        const std::uint64_t before = governor.stepsUp();
        for (int i = 0; i < frames; ++i)
            note(governor, kPeriodMs, governor.level() < 2 ? 0.9 * kPeriodMs : 0.2 * kPeriodMs);
        return governor.stepsUp() - before;
    };
    play(20);
    const std::uint64_t first = play(400);
    play(3000);
    const std::uint64_t later = play(400);
    EXPECT_GE(first, 2u);
    EXPECT_LE(later, 1u);
}

TEST(Governor, ALateFrameNowAndThenChangesNothing) {
    Governor governor;
    for (int i = 0; i < 1000; ++i) note(governor, kPeriodMs, i % 20 == 0 ? 3.0 * kPeriodMs : 5.0);
    EXPECT_EQ(governor.level(), 0u);
}

TEST(Governor, TimesThatAreNoneArePassedOver) {
    const double nan = std::nan("");
    const double infinite = std::numeric_limits<double>::infinity();
    Governor governor;
    EXPECT_EQ(governor.timeFor(Work::model, 0.0), std::nullopt) << "nobody knows the pace yet";
    for (const double wrong : {nan, infinite, -infinite, -1.0}) {
        for (int i = 0; i < 20; ++i) {
            note(governor, wrong, wrong);
            note(governor, kPeriodMs, wrong);
            note(governor, wrong, 5.0);
            note(governor, 0.0, 5.0);
            governor.noteWork(Work::fovea, wrong, 5.0);
            governor.noteWork(Work::fovea, 5.0, wrong);
        }
        EXPECT_EQ(governor.timeFor(Work::model, wrong), std::nullopt);
    }
    EXPECT_EQ(governor.level(), 0u);
    const auto left = governor.timeFor(Work::model, 5.0);
    ASSERT_TRUE(left);
    EXPECT_NEAR(*left, Governor::kOurShare * kPeriodMs - 5.0, 1e-9);
    // Hours are a late frame, and no more: it goes down by no more than four periods want.
    note(governor, kPeriodMs, 1e9);
    EXPECT_EQ(governor.level(), 0u);
    note(governor, 1e12, 5.0);  // and a period of years is a second
    ASSERT_TRUE(governor.timeFor(Work::model, 0.0));
    EXPECT_LE(*governor.timeFor(Work::model, 0.0), 1000.0);
}

TEST(Governor, AnyTimesLeaveItWithinItsLevels) {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> exponent(-8.0, 12.0);
    Governor governor;
    for (int i = 0; i < 20000; ++i) {
        note(governor, std::pow(10.0, exponent(random)), std::pow(10.0, exponent(random)));
        ASSERT_LT(governor.level(), Governor::kLevels.size());
        const auto told =
            governor.timeFor(i % 2 == 0 ? Work::model : Work::fovea, std::pow(10.0, exponent(random)));
        if (!told) continue;
        ASSERT_GE(*told, Governor::kLeastWorkMs);
        ASSERT_LE(*told, 1000.0);
        governor.noteWork(i % 2 == 0 ? Work::model : Work::fovea, *told, std::pow(10.0, exponent(random)));
    }
}

// Work whose smallest piece takes longer than there is time for.
TEST(Governor, WorkThatDoesNotFitIsDoneSeldomAndNotNever) {
    constexpr double kPieceMs = 70.0;
    constexpr double kDrawMs = 10.0;
    Governor governor;
    int pieces = 0;
    double latePeriods = 0.0;
    constexpr int kFrames = 2000;
    for (int i = 0; i < kFrames; ++i) {
        note(governor, kPeriodMs, kDrawMs);
        const auto told = governor.timeFor(Work::model, kDrawMs);
        if (!told) continue;
        ++pieces;
        governor.noteWork(Work::model, *told, kPieceMs);
        latePeriods += std::ceil((kDrawMs + kPieceMs) / kPeriodMs) - 1.0;
    }
    EXPECT_GE(pieces, 20);
    EXPECT_LE(latePeriods, (Governor::kLateShare + 0.005) * kFrames);
    EXPECT_EQ(governor.level(), 0u) << "drawing is fast";
}

// As that of a fovea, whose last slice also filters the picture.
TEST(Governor, WorkThatIsLongNowAndThenIsSoonDoneAgain) {
    Governor governor;
    double latePeriods = 0.0;
    int pieces = 0;
    constexpr int kFrames = 3000;
    for (int i = 0; i < kFrames; ++i) {
        note(governor, kPeriodMs, 8.0);
        const auto told = governor.timeFor(Work::fovea, 8.0);
        if (!told) continue;
        const double tookMs = ++pieces % 12 == 0 ? 60.0 : *told + 1.0;
        governor.noteWork(Work::fovea, *told, tookMs);
        latePeriods += std::max(std::ceil((8.0 + tookMs) / kPeriodMs) - 1.0, 0.0);
    }
    EXPECT_GT(pieces, kFrames / 10);
    EXPECT_LE(latePeriods, 0.045 * kFrames);
}

TEST(Governor, WorkThatFitsIsDoneInEveryFrame) {
    Governor governor;
    for (int i = 0; i < 200; ++i) {
        note(governor, kPeriodMs, 8.0);
        const auto told = governor.timeFor(Work::model, 8.0);
        ASSERT_TRUE(told) << i;
        const double tookMs = std::ceil(*told / 3.0) * 3.0;  // in pieces of 3 ms
        governor.noteWork(Work::model, *told, tookMs);
        ASSERT_LE(8.0 + tookMs, kPeriodMs);
    }
}

TEST(Governor, TheFoveaIsTracedInEverySoManiethFrame) {
    Governor governor;
    run(governor, {.fullMs = 120.0}, 20);
    ASSERT_EQ(governor.quality().framesPerFovea, 4);
    int traced = 0;
    for (int i = 0; i < 40; ++i) {
        note(governor, kPeriodMs, 12.0);
        traced += governor.timeFor(Work::fovea, 1.0) ? 1 : 0;
    }
    EXPECT_EQ(traced, 10);
}

}  // namespace
}  // namespace macula::xr
