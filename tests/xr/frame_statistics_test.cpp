// Whether frames were in time, from what the headset and the clock said.
#include "xr/frame_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace macula::xr {
namespace {

constexpr double kPeriodMs = 20.0;

FrameTimes at(std::int64_t period, double drawnMs = 5.0) {
    FrameTimes frame;
    frame.displayedNs = period * 20'000'000;
    frame.periodMs = kPeriodMs;
    frame.drawnMs = drawnMs;
    frame.workMs = 2.0;
    return frame;
}

TEST(FrameStatistics, NothingIsInTime) {
    const FrameFigures none = FrameStatistics().figures();
    EXPECT_EQ(none.frames, 0u);
    EXPECT_EQ(none.inTimePercent(), 100.0);
    EXPECT_EQ(none.mean.drawnMs, 0.0);
    EXPECT_FALSE(textOf(none).empty());
}

TEST(FrameStatistics, TimesWithoutAFrameAreCounted) {
    FrameStatistics statistics;
    for (const std::int64_t period : {0, 1, 2, 5, 6, 8, 9, 10, 11, 12}) statistics.note(at(period));
    const FrameFigures figures = statistics.figures();
    EXPECT_EQ(figures.frames, 10u);
    EXPECT_EQ(figures.late, 2u);
    EXPECT_EQ(figures.missed, 3u) << "3 and 4, and 7";
    EXPECT_NEAR(figures.inTimePercent(), 100.0 * 10.0 / 13.0, 1e-9);
    EXPECT_NEAR(figures.periodMs, kPeriodMs, 1e-9);
}

TEST(FrameStatistics, AHeadsetThatSwaysALittleMissesNothing) {
    FrameStatistics statistics;
    for (std::int64_t i = 0; i < 100; ++i) {
        FrameTimes frame = at(i);
        frame.displayedNs += (i % 3 - 1) * 2'000'000;
        statistics.note(frame);
    }
    EXPECT_EQ(statistics.figures().missed, 0u);
}

TEST(FrameStatistics, APauseIsNoLateFrame) {
    FrameStatistics statistics;
    statistics.note(at(0));
    statistics.pause();
    statistics.note(at(500));
    EXPECT_EQ(statistics.figures().missed, 0u);
    statistics.note(at(1'000'000));  // it slept
    statistics.note(at(3));          // and its clock begins anew
    EXPECT_EQ(statistics.figures().missed, 0u);
}

TEST(FrameStatistics, MeansAreOfFramesWithPictures) {
    FrameStatistics statistics;
    statistics.note(at(0, 4.0));
    FrameTimes empty = at(1, 1000.0);
    empty.isEmpty = true;
    statistics.note(empty);
    FrameTimes worst = at(2, 8.0);
    worst.level = 3;
    statistics.note(worst);
    const FrameFigures figures = statistics.figures();
    EXPECT_EQ(figures.empty, 1u);
    EXPECT_NEAR(figures.mean.drawnMs, 6.0, 1e-9);
    EXPECT_NEAR(figures.mean.workMs, 2.0, 1e-9);
    EXPECT_EQ(figures.longestMs, 8.0);
    EXPECT_EQ(figures.worstLevel, 3u);
    EXPECT_EQ(figures.lastLevel, 3u);
}

TEST(FrameStatistics, TimesThatAreNoneSpoilNoMean) {
    FrameStatistics statistics;
    statistics.note(at(0, 6.0));
    statistics.note(at(1, std::nan("")));
    FrameTimes wrong = at(2, -std::numeric_limits<double>::infinity());
    wrong.periodMs = std::nan("");
    statistics.note(wrong);
    const FrameFigures figures = statistics.figures();
    EXPECT_EQ(figures.frames, 3u);
    EXPECT_EQ(figures.missed, 0u);
    EXPECT_NEAR(figures.mean.drawnMs, 2.0, 1e-9);
    EXPECT_TRUE(std::isfinite(figures.periodMs));
}

}  // namespace
}  // namespace macula::xr
