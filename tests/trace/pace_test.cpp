// How large dispatches become.
#include "pipeline/trace/pace.h"

#include <gtest/gtest.h>

#include "pipeline/trace/portions.h"

namespace macula::trace {
namespace {

const Work kWork{.variant = {}, .bounces = 4};

TEST(Pace, SlowerIsBelievedAtOnceAndFasterByAndBy) {
    Pace pace;
    pace.learn(kWork, 1.0, 1000.0);
    EXPECT_DOUBLE_EQ(pace.perMs(kWork), 0.001);
    pace.learn(kWork, 1000.0, 1.0);  // a million times faster: all of these blocks were empty
    EXPECT_DOUBLE_EQ(pace.perMs(kWork), 0.002);
    for (int i = 0; i < 60; ++i) pace.learn(kWork, 40.0, 10.0);
    EXPECT_NEAR(pace.perMs(kWork), 4.0, 1e-6);
    pace.learn(kWork, 40.0, 20.0);
    EXPECT_DOUBLE_EQ(pace.perMs(kWork), 2.0);
}

TEST(Pace, BeginsWithLittleAndWithNoisyBlocksMoreCarefullyStill) {
    Pace pace;
    Work adaptive = kWork;
    adaptive.isAdaptive = true;
    EXPECT_GT(pace.perMs(kWork), 0.0);
    EXPECT_LT(pace.perMs(adaptive), pace.perMs(kWork));
    for (int i = 0; i < 60; ++i) pace.learn(kWork, 8.0, 1.0);
    EXPECT_NEAR(pace.perMs(adaptive), 4.0, 1e-6);  // half of the even one, until it was tried
    pace.learn(adaptive, 3.0, 1.0);
    EXPECT_DOUBLE_EQ(pace.perMs(adaptive), 3.0);
    EXPECT_NEAR(pace.perMs(kWork), 8.0, 1e-6);
}

TEST(Pace, OtherWorkIsAnother) {
    Pace pace;
    for (int i = 0; i < 60; ++i) pace.learn(kWork, 8.0, 1.0);
    Work longer = kWork;
    longer.bounces = 8;
    Work clipped = kWork;
    clipped.variant.scene.clip = true;
    const double first = Pace().perMs(kWork);
    EXPECT_DOUBLE_EQ(pace.perMs(longer), first);
    EXPECT_DOUBLE_EQ(pace.perMs(clipped), first);
}

// A graphics card is busy after a few dispatches, and one that is slow is believed at once too.
TEST(Pace, OfAGraphicsCardIsFoundSoon) {
    const auto dispatchesUntilBusy = [](Pace pace, double perMs) {
        int dispatches = 0;
        // A dispatch takes 1.5 ms at least, however small it is.
        for (; pace.perMs(kWork) < 0.4 * perMs; ++dispatches) {
            const double samples = 40.0 * pace.perMs(kWork);
            pace.learn(kWork, samples, 1.5 + samples / perMs);
        }
        return dispatches;
    };
    EXPECT_GT(dispatchesUntilBusy(Pace(), 1600.0), 10);
    EXPECT_LE(dispatchesUntilBusy(Pace(Pace::graphicsCard()), 1600.0), 4);
    Pace slow(Pace::graphicsCard());
    slow.learn(kWork, 800.0, 800.0);
    EXPECT_DOUBLE_EQ(slow.perMs(kWork), 1.0);
}

// What leaves most of a card idle says nothing about how fast one is that is busy, nor the other way round.
TEST(Pace, OfWhatLeavesTheDeviceIdleIsAnother) {
    Pace pace(Pace::graphicsCard());
    Work idle = kWork;
    idle.leavesIdle = true;
    for (int i = 0; i < 60; ++i) pace.learn(kWork, 16000.0, 10.0);
    EXPECT_DOUBLE_EQ(pace.perMs(idle), Pace::graphicsCard().perMs);
    pace.learn(idle, 80.0, 5.0);
    EXPECT_NEAR(pace.perMs(kWork), 1600.0, 1e-6);
    EXPECT_DOUBLE_EQ(pace.perMs(idle), 16.0);
    Work adaptive = idle;
    adaptive.isAdaptive = true;
    EXPECT_DOUBLE_EQ(pace.perMs(adaptive), 8.0);
}

// A dispatch without blocks, and one that took no time at all.
TEST(Pace, StaysANumberAtTheExtremes) {
    Pace pace;
    pace.learn(kWork, 1.0, 0.0);
    const double known = pace.perMs(kWork);
    EXPECT_GT(known, 0.0);
    EXPECT_LT(known, 1.0);
    pace.learn(kWork, 0.0, 1.0);
    EXPECT_EQ(pace.perMs(kWork), known);
}

// However large a picture is: at a hundred and fiftieth of an H100's speed some 80 ns for a pixel that is
// marched, and 12 ns for one of a stage of the filter, no submission comes near the 2 s after which Windows
// resets a card.
TEST(Portions, AreFarBelowWhatDriversAllow) {
    constexpr double kMostMs = 200.0;
    for (const int width : {1, 8, 640, 1920, 3840, 7680, 16384}) {
        for (const int height : {1, 7, 480, 2160, 16384}) {
            const int marched = rowsToMarchAtOnce(false, width, height);
            EXPECT_GE(marched, 8);
            EXPECT_LT(double(width) * marched * 80e-6, kMostMs) << width << " " << height;
            for (const bool isInterruptible : {false, true}) {
                const FilterPortion portion = filterPortion(false, isInterruptible, width, height);
                EXPECT_GE(portion.rowsAtOnce, std::min(height, 8));
                EXPECT_LT((double(width) * portion.rowsAtOnce + double(portion.enoughPixels)) * 12e-6,
                          kMostMs);
            }
        }
    }
}

}  // namespace
}  // namespace macula::trace
