#include "scene/transfer/value_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace macula::scene {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void expectSame(const ValueAxis& a, const ValueAxis& b) {
    EXPECT_EQ(a.shown, b.shown);
    EXPECT_EQ(a.lengthPx, b.lengthPx);
}

TEST(ValueAxis, GoesFromLeftToRightAndBack) {
    const ValueAxis axis = ValueAxis::over({-1000.0, 3000.0}, 500.0);
    EXPECT_LT(axis.shown.low, -1000.0);
    EXPECT_GT(axis.shown.high, 3000.0);
    EXPECT_NEAR(axis.pxOf(axis.shown.low), 0.0, 1e-9);
    EXPECT_NEAR(axis.pxOf(axis.shown.high), 500.0, 1e-9);
    EXPECT_NEAR(axis.valueAt(axis.pxOf(123.4)), 123.4, 1e-9);
    EXPECT_TRUE(axis.contains(0.0));
    EXPECT_FALSE(axis.contains(1e5));
}

TEST(ValueAxis, ZoomsAboutAValue) {
    const ValueAxis axis = ValueAxis::over({0.0, 100.0}, 400.0);
    const ValueAxis near = axis.zoomed(0.25, 30.0);
    EXPECT_NEAR(near.pxOf(30.0), axis.pxOf(30.0), 1e-9);
    EXPECT_NEAR(near.unitsPerPx(), 0.25 * axis.unitsPerPx(), 1e-12);
    EXPECT_NEAR(axis.panned(12.0).shown.low, axis.shown.low + 12.0, 1e-9);
}

TEST(ValueAxis, IsNeverEmptyAndNeverEndless) {
    for (const double about : {0.0, -3024.0, 1e9}) {
        ValueAxis near = ValueAxis::over({-1024.0, 3071.0}, 400.0);
        ValueAxis far = near;
        for (int i = 0; i < 500; ++i) {
            near = near.zoomed(0.5, about);
            far = far.zoomed(2.0, about);
        }
        EXPECT_LT(near.shown.low, near.shown.high);
        EXPECT_GT(near.unitsPerPx(), 0.0);
        EXPECT_TRUE(std::isfinite(far.shown.low) && std::isfinite(far.shown.high));
        EXPECT_LE(far.shown.high - far.shown.low, 1e10);
        EXPECT_LE(near.ticks(50.0).size(), 10u);
        EXPECT_LE(far.ticks(50.0).size(), 10u);
    }
    const ValueAxis one = ValueAxis::over({7.0, 7.0}, 0.0);
    EXPECT_TRUE(one.contains(7.0));
    EXPECT_LT(one.shown.low, one.shown.high);
    EXPECT_GT(one.lengthPx, 0.0);
    for (const double odd : {kNaN, std::numeric_limits<double>::infinity()}) {
        expectSame(one.zoomed(odd, 7.0), one);
        expectSame(one.zoomed(0.5, odd), one);
        expectSame(one.panned(odd), one);
    }
    expectSame(one.zoomed(0.0, 7.0), one);
    expectSame(one.zoomed(-1.0, 7.0), one);
}

TEST(ValueAxis, HasRoundTicksThatAreFarEnoughApart) {
    const ValueAxis axis{.shown = {-1100.0, 3100.0}, .lengthPx = 420.0};
    EXPECT_EQ(axis.tickStep(45.0), 500.0);
    EXPECT_EQ(axis.tickStep(60.0), 1000.0);
    EXPECT_EQ(axis.ticks(60.0), (std::vector<double>{-1000.0, 0.0, 1000.0, 2000.0, 3000.0}));
    const ValueAxis suv{.shown = {0.0, 0.75}, .lengthPx = 300.0};
    EXPECT_NEAR(suv.tickStep(60.0), 0.2, 1e-12);
}

TEST(ValueMap, IsThatOfTheFit) {
    const VolumeFit fit{.preset = {0.0, 1000.0}, .volume = {80.0, 330.0}};
    const ValueMap map = ValueMap::of(fit);
    for (const double value : {-50.0, 0.0, 420.0, 1000.0, 2000.0}) {
        EXPECT_NEAR(map.shownFrom(value), fit(value), 1e-9);
        EXPECT_NEAR(map.presetFrom(map.shownFrom(value)), value, 1e-9);
    }
    EXPECT_EQ(ValueMap::of(std::nullopt).shownFrom(123.456), 123.456);
    EXPECT_EQ(ValueMap::of(std::nullopt).presetFrom(123.456), 123.456);
}

}  // namespace
}  // namespace macula::scene
