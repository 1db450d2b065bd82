// A volume with fewer voxels is the same volume.
#include "registration/scalar_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "registration/comparison.h"
#include "registration/intensity_bins.h"

namespace macula::registration {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Volume made(VolumeOptions options, const std::function<float(const glm::ivec3&)>& value) {
    std::vector<float> voxels;
    for (int k = 0; k < options.size.z; ++k)
        for (int j = 0; j < options.size.y; ++j)
            for (int i = 0; i < options.size.x; ++i) voxels.push_back(value({i, j, k}));
    return *Volume::createFloat(std::move(options), std::move(voxels));
}

TEST(ScalarGrid, WhatIsLinearStaysWhereItIs) {
    const glm::dmat4 sheared = affine({0.5, 0.1, 0}, {0, 0.7, 0}, {0.1, 0.3, 1.1}, {-7, 3, 20});
    const auto of = [](const glm::dvec3& mm) { return float(2.0 * mm.x - 3.0 * mm.y + 0.5 * mm.z); };
    const Volume volume = made({.size = {64, 48, 40}, .worldFromVoxel = sheared}, [&](const glm::ivec3& v) {
        return of(transformPoint(sheared, glm::dvec3(v)));
    });
    const ScalarGrid fine = gridOf(volume, 2.0, {});
    EXPECT_EQ(fine.size, glm::ivec3(16, 16, 20));
    const ScalarGrid coarse = coarser(fine, 4.0);
    for (const ScalarGrid* grid : {&fine, &coarse}) {
        const glm::dvec3 mm = transformPoint(sheared, glm::dvec3(30.3, 22.1, 17.7));
        EXPECT_NEAR(grid->at(transformPoint(grid->gridFromWorld, mm)), of(mm), 1e-3);
    }
}

TEST(ScalarGrid, OutsideAndPaddingHaveNoValue) {
    const Volume volume = made({.size = glm::ivec3(16), .floatPadding = 7.0F},
                               [](const glm::ivec3& v) { return v.x < 8 ? 7.0F : float(v.y); });
    const ScalarGrid grid = gridOf(volume, 1.0, {});
    EXPECT_TRUE(std::isnan(grid.at({3.0, 4.0, 4.0})));
    EXPECT_TRUE(std::isnan(grid.at({7.5, 4.0, 4.0}))) << "half of it is padding";
    EXPECT_FLOAT_EQ(grid.at({9.5, 4.5, 4.0}), 4.5F);
    for (const glm::dvec3& outside : {glm::dvec3(-0.1, 4, 4), glm::dvec3(15.0, 4, 4), glm::dvec3(9, 4, 99),
                                      glm::dvec3(std::nan(""), 4, 4)})
        EXPECT_TRUE(std::isnan(grid.at(outside)));
}

TEST(ScalarGrid, OfHounsfieldUnitsNothingIsThinnerThanVacuum) {
    const Volume volume = made({.size = glm::ivec3(8), .unit = Unit::hounsfield},
                               [](const glm::ivec3& v) { return v.x < 4 ? -3024.0F : -1000.0F; });
    const ScalarGrid grid = gridOf(volume, 1.0, {});
    EXPECT_TRUE(std::isnan(grid.values[grid.index(0, 3, 3)]));
    EXPECT_FLOAT_EQ(grid.values[grid.index(6, 3, 3)], -1000.0F);
}

TEST(IntensityBins, OneHotVoxelLeavesTheRestApart) {
    const Volume volume = made({.size = glm::ivec3(16)},
                               [](const glm::ivec3& v) { return v == glm::ivec3(3) ? 1e6F : float(v.x); });
    const IntensityBins bins(gridOf(volume, 1.0, {}), Unit::raw);
    ASSERT_TRUE(bins.areUsable());
    EXPECT_DOUBLE_EQ(bins.of(0.0F), kMargin);
    EXPECT_DOUBLE_EQ(bins.of(15.0F), kBins - 1 - kMargin);
    EXPECT_DOUBLE_EQ(bins.of(1e6F), kBins - 1 - kMargin);
    EXPECT_DOUBLE_EQ(bins.of(-50.0F), kMargin);
}

TEST(SamplePoints, AreWhereValuesAreAndAlwaysTheSame) {
    const Volume volume = made({.size = glm::ivec3(32)},
                               [](const glm::ivec3& v) { return v.z < 16 ? kNaN : float(v.x + v.y); });
    const ScalarGrid grid = gridOf(volume, 1.0, {});
    const IntensityBins bins(grid, Unit::raw);
    const auto points = samplePoints(grid, bins, 2000, 5);
    EXPECT_GT(points.size(), 1500U);
    EXPECT_LE(points.size(), 2100U);
    for (const SamplePoint& point : points) EXPECT_GE(point.mm.z, 16.0);
    const auto again = samplePoints(grid, bins, 2000, 5);
    ASSERT_EQ(again.size(), points.size());
    for (std::size_t n = 0; n < points.size(); ++n) EXPECT_EQ(again[n].mm, points[n].mm);
    EXPECT_NE(samplePoints(grid, bins, 2000, 6).front().mm, points.front().mm);
    EXPECT_TRUE(samplePoints(grid, bins, 0, 5).empty());
}

}  // namespace
}  // namespace macula::registration
