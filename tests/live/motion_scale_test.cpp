#include "live/frame/motion_scale.h"

#include <gtest/gtest.h>

#include <utility>

namespace macula::live {
namespace {

constexpr double kBudgetMs = 110;

// Frames on a device with these costs, until the scale has settled.
int settle(MotionScale& motion, double nsPerPixel, double otherMs, int width = 800, int height = 600) {
    int scale = 0;
    for (int frame = 0; frame < 40; ++frame) {
        scale = motion.choose(width, height);
        const int w = scaledEdge(width, scale);
        const int h = scaledEdge(height, scale);
        motion.observe(w, h, nsPerPixel * 1e-6 * w * h, otherMs);
    }
    return scale;
}

TEST(MotionScale, StaysWithinTheBudgetOnASlowDevice) {
    MotionScale motion(kBudgetMs, 4000);
    const int scale = settle(motion, 3000, 8);
    EXPECT_GT(scale, 1);
    EXPECT_LE(3000e-6 * scaledEdge(800, scale) * scaledEdge(600, scale) + 8, kBudgetMs);
    // One step finer would not fit.
    EXPECT_GT(3000e-6 * scaledEdge(800, scale - 1) * scaledEdge(600, scale - 1) + 8, 0.75 * kBudgetMs);
}

TEST(MotionScale, GivesAFastDeviceAllPixels) {
    MotionScale motion(kBudgetMs, 4000);
    EXPECT_EQ(settle(motion, 10, 1), 1);
}

TEST(MotionScale, ALargeFixedCostDoesNotEndInTheSmallestPicture) {
    MotionScale motion(kBudgetMs, 4000);
    EXPECT_LE(settle(motion, 1000, 60), 5);
}

TEST(MotionScale, DoesNotFlickerBetweenTwoScales) {
    MotionScale motion(kBudgetMs, 4000);
    const int settled = settle(motion, 3000, 8);
    int changes = 0;
    for (int frame = 0; frame < 100; ++frame) {
        const int scale = motion.choose(800, 600);
        changes += scale != settled ? 1 : 0;
        const double noise = frame % 2 == 0 ? 1.05 : 0.95;
        const int w = scaledEdge(800, scale);
        const int h = scaledEdge(600, scale);
        motion.observe(w, h, noise * 3000e-6 * w * h, 8);
    }
    EXPECT_EQ(changes, 0);
}

// A finer scale has to fit with a quarter of the budget to spare; else one quicker frame would change it, and
// the next one back.
TEST(MotionScale, GetsFinerOnlyWithRoomToSpare) {
    for (const auto& [finerMs, finer] : {std::pair(0.9, false), std::pair(0.7, true)}) {
        MotionScale motion(kBudgetMs, 4000);
        const int settled = settle(motion, 3000, 0);
        const int pixels = scaledEdge(800, settled - 1) * scaledEdge(600, settled - 1);
        EXPECT_EQ(settle(motion, finerMs * kBudgetMs * 1e6 / pixels, 0) < settled, finer) << finerMs;
    }
}

TEST(MotionScale, ScaledEdgesAreNeverEmpty) {
    EXPECT_EQ(scaledEdge(801, 4), 201);
    EXPECT_EQ(scaledEdge(3, 16), 1);
    EXPECT_EQ(scaledEdge(0, 2), 1);
}

TEST(MotionScales, WhatOneLookCostsLeavesAnotherAsSharpAsItWas) {
    MotionScales scales(100.0, 4000.0);
    const int before = scales.of(trace::Look::mip).choose(900, 720);
    for (int i = 0; i < 10; ++i) scales.of(trace::Look::cinematic).observe(90, 72, 500.0, 0.0);
    EXPECT_EQ(scales.of(trace::Look::cinematic).choose(900, 720), 16);
    EXPECT_EQ(scales.of(trace::Look::mip).choose(900, 720), before);
}

}  // namespace
}  // namespace macula::live
