// Threshold, growing, islands, holes, brush and statistics, against slow filters and closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "naive_filters.h"
#include "segment/brush.h"
#include "segment/islands.h"
#include "segment/statistics.h"
#include "segment/threshold.h"
#include "segment/voxel_sets.h"

namespace macula::segment {
namespace {

using test::setWhere;
using test::someVoxels;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Values by place; NaN is padding.
Volume volumeOf(const glm::ivec3& size, const std::function<float(const glm::ivec3&)>& value,
                const glm::dvec3& spacingMm = glm::dvec3(1.0)) {
    std::vector<float> values;
    test::forEachVoxel(size, [&](const glm::ivec3& v) { values.push_back(value(v)); });
    auto volume = Volume::createFloat({.size = size,
                                       .worldFromVoxel = affine({spacingMm.x, 0, 0}, {0, spacingMm.y, 0},
                                                                {0, 0, spacingMm.z}, glm::dvec3(0.0))},
                                      std::move(values));
    EXPECT_TRUE(volume) << volume.error().message;
    return *std::move(volume);
}

class Segmenting : public testing::Test {
  protected:
    Progress progress_;
};

TEST_F(Segmenting, AThresholdTakesBothEndsAndNeverPaddingOrNan) {
    const glm::ivec3 size(70, 5, 4);
    const Volume volume =
        volumeOf(size, [](const glm::ivec3& v) { return (v.x + v.y + v.z) % 7 == 3 ? kNan : float(v.x); });
    const auto found = voxelsBetween(volume, {10.0, 65.0}, nullptr, progress_);
    ASSERT_TRUE(found);
    EXPECT_TRUE(*found == setWhere(size, [](const glm::ivec3& v) {
        return v.x >= 10 && v.x <= 65 && (v.x + v.y + v.z) % 7 != 3;
    }));
    const VoxelSet region = someVoxels(size, 0.4, 7);
    const auto within = voxelsBetween(volume, {10.0, 65.0}, &region, progress_);
    ASSERT_TRUE(within);
    EXPECT_TRUE(*within == intersected(*found, region));
}

TEST_F(Segmenting, AThresholdOfNothingOfAllAndOfNonsense) {
    const Volume volume = volumeOf({3, 3, 3}, [](const glm::ivec3&) { return 5.0f; });
    EXPECT_TRUE(voxelsBetween(volume, {6.0, 7.0}, nullptr, progress_)->isEmpty());
    EXPECT_EQ(voxelsBetween(volume, {5.0, 5.0}, nullptr, progress_)->count(), 27u);
    const VoxelSet none;
    EXPECT_TRUE(voxelsBetween(volume, {5.0, 5.0}, &none, progress_)->isEmpty());
    EXPECT_FALSE(voxelsBetween(volume, {7.0, 6.0}, nullptr, progress_));
    EXPECT_FALSE(voxelsBetween(volume, {double(kNan), 6.0}, nullptr, progress_));
    const Volume blank = volumeOf({2, 2, 2}, [](const glm::ivec3&) { return kNan; });
    EXPECT_TRUE(voxelsBetween(blank, {-1e30, 1e30}, nullptr, progress_)->isEmpty());
    Progress cancelled;
    cancelled.token().cancel();
    EXPECT_EQ(voxelsBetween(volume, {5.0, 5.0}, nullptr, cancelled).error().code, ErrorCode::cancelled);
}

TEST_F(Segmenting, GrowingIsThePartOfTheSeedAmongItsValues) {
    const glm::ivec3 size(14, 12, 9);
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const VoxelSet bright = united(someVoxels(size, 0.35, seed), setWhere(size, [](const glm::ivec3& v) {
                                           return glm::distance(glm::dvec3(v), glm::dvec3(6, 5, 4)) < 2.0;
                                       }));
        const Volume volume =
            volumeOf(size, [&](const glm::ivec3& v) { return bright.contains(v) ? 100.0f : 0.0f; });
        for (const bool corners : {false, true}) {
            const auto grown =
                grownFrom(volume, {.seed = {6, 5, 4}, .tolerance = 20.0, .corners = corners}, progress_);
            ASSERT_TRUE(grown) << grown.error().message;
            EXPECT_DOUBLE_EQ(grown->range.low, 80.0);
            EXPECT_FALSE(grown->isCutShort);
            EXPECT_TRUE(grown->voxels == test::partOf(bright, size, {6, 5, 4}, corners));
        }
    }
}

TEST_F(Segmenting, GrowingStopsAtItsLimitAndStaysInItsRegion) {
    const glm::ivec3 size(9, 9, 9);
    const Volume volume = volumeOf(size, [](const glm::ivec3&) { return 1.0f; });
    const auto some = grownFrom(volume, {.seed = {4, 4, 4}, .mostVoxels = 7}, progress_);
    ASSERT_TRUE(some);
    EXPECT_TRUE(some->isCutShort);
    EXPECT_TRUE(some->voxels ==
                setWhere(size,
                         [](const glm::ivec3& v) {
                             return std::abs(v.x - 4) + std::abs(v.y - 4) + std::abs(v.z - 4) <= 1;
                         }))
        << "the nearest first";
    const VoxelSet half = setWhere(size, [](const glm::ivec3& v) { return v.x < 5; });
    EXPECT_TRUE(grownFrom(volume, {.seed = {4, 4, 4}, .within = &half}, progress_)->voxels == half);
    EXPECT_FALSE(grownFrom(volume, {.seed = {6, 4, 4}, .within = &half}, progress_));
    EXPECT_EQ(grownFrom(volume, {.seed = {4, 4, 4}}, progress_)->voxels.count(), 729u);
}

TEST_F(Segmenting, GrowingRefusesSeedsThatSayNothing) {
    const Volume volume = volumeOf({5, 5, 5}, [](const glm::ivec3& v) {
        return v == glm::ivec3(2) ? 90.0f : v.x == 0 ? kNan : 0.0f;
    });
    EXPECT_EQ(grownFrom(volume, {.seed = {2, 2, 2}, .tolerance = 5.0}, progress_).error().code,
              ErrorCode::usage)
        << "it differs from its surroundings";
    EXPECT_FALSE(grownFrom(volume, {.seed = {0, 2, 2}, .tolerance = 5.0}, progress_)) << "padding";
    EXPECT_FALSE(grownFrom(volume, {.seed = {5, 0, 0}}, progress_));
    EXPECT_FALSE(grownFrom(volume, {.seed = {3, 0, 0}, .tolerance = double(kNan)}, progress_));
    const Volume one = volumeOf({1, 1, 1}, [](const glm::ivec3&) { return 3.0f; });
    EXPECT_EQ(grownFrom(one, {}, progress_)->voxels.count(), 1u);
}

TEST_F(Segmenting, IslandsAreThoseOfAFlood) {
    const glm::ivec3 size(66, 7, 6);
    for (const double share : {0.1, 0.25, 0.4}) {
        const VoxelSet set = someVoxels(size, share, unsigned(100.0 * share));
        for (const bool corners : {false, true}) {
            VoxelSet rest = set;
            VoxelSet largest;
            VoxelSet large;
            std::size_t parts = 0;
            test::forEachVoxel(size, [&](const glm::ivec3& v) {
                if (!rest.contains(v)) return;
                const VoxelSet part = test::partOf(set, size, v, corners);
                rest = without(rest, part);
                ++parts;
                if (part.count() > largest.count()) largest = part;
                if (part.count() >= 4) large = united(large, part);
                EXPECT_TRUE(*islandOf(set, v, corners, progress_) == part);
            });
            EXPECT_EQ(*islandCount(set, corners, progress_), parts);
            EXPECT_TRUE(*largestIsland(set, corners, progress_) == largest);
            EXPECT_TRUE(*withoutSmallIslands(set, 4, corners, progress_) == large);
        }
    }
    EXPECT_TRUE(largestIsland({}, true, progress_)->isEmpty());
    EXPECT_EQ(*islandCount({}, true, progress_), 0u);
    EXPECT_TRUE(islandOf({}, glm::ivec3(0), true, progress_)->isEmpty());
    const VoxelSet all = setWhere(size, [](const glm::ivec3&) { return true; });
    EXPECT_TRUE(*largestIsland(all, false, progress_) == all);
}

TEST_F(Segmenting, HolesAreWhatNoWayLeadsOutOf) {
    const glm::ivec3 size(9, 9, 9);
    const auto shell = [](const glm::ivec3& v) {
        const int far = std::max({std::abs(v.x - 4), std::abs(v.y - 4), std::abs(v.z - 4)});
        return far == 3 || v == glm::ivec3(4);
    };
    const VoxelSet closed = setWhere(size, shell);
    const VoxelSet cube = setWhere(size, [](const glm::ivec3& v) {
        return std::max({std::abs(v.x - 4), std::abs(v.y - 4), std::abs(v.z - 4)}) <= 3;
    });
    EXPECT_TRUE(*withoutHoles(closed, progress_) == cube);
    const VoxelSet open =
        setWhere(size, [&](const glm::ivec3& v) { return shell(v) && v != glm::ivec3(1, 4, 4); });
    EXPECT_TRUE(*withoutHoles(open, progress_) == open) << "one voxel is a way out";
    const VoxelSet leaky =
        setWhere(size, [&](const glm::ivec3& v) { return shell(v) && v != glm::ivec3(1, 1, 1); });
    EXPECT_TRUE(*withoutHoles(leaky, progress_) ==
                without(cube, setWhere(size, [](const glm::ivec3& v) { return v == glm::ivec3(1); })))
        << "no way over a corner";
    EXPECT_TRUE(withoutHoles({}, progress_)->isEmpty());
}

TEST_F(Segmenting, TheBrushIsABallInMmOrADiscOfOneSlice) {
    const glm::ivec3 size(41, 41, 9);
    const glm::dvec3 spacing(0.5, 0.5, 5.0);  // 10 to 1
    const glm::dmat4 world = affine({spacing.x, 0, 0}, {0, spacing.y, 0}, {0, 0, spacing.z}, {-3, 2, 1});
    const glm::dvec3 centre = transformPoint(world, {20, 20, 4});
    const VoxelSet ball = voxelsUnder({centre, centre, 5.5}, world, size);
    EXPECT_TRUE(ball == test::ball(size, spacing, glm::dvec3(20, 20, 4) * spacing, 5.5));
    const VoxelSet disc = voxelsUnder({centre, centre, 5.5, glm::dvec3(0, 0, 1)}, world, size);
    EXPECT_TRUE(disc == intersected(ball, setWhere(size, [](const glm::ivec3& v) { return v.z == 4; })));
    EXPECT_EQ(voxelsUnder({centre, centre, 0.0}, world, size).count(), 1u);
    const glm::dvec3 to = transformPoint(world, {30, 20, 4});
    const VoxelSet stroke = voxelsUnder({centre, to, 1.0, glm::dvec3(0, 0, 1)}, world, size);
    EXPECT_TRUE(stroke == setWhere(size,
                                   [&](const glm::ivec3& v) {
                                       const double x = std::clamp(double(v.x), 20.0, 30.0);
                                       return v.z == 4 &&
                                              glm::length(glm::dvec2(v.x - x, v.y - 20) * 0.5) <= 1.0;
                                   }))
        << "the way of a drag has no gaps";
    EXPECT_TRUE(voxelsUnder({{1e6, 0, 0}, {1e6, 0, 0}, 5.0}, world, size).isEmpty());
    EXPECT_TRUE(voxelsUnder({glm::dvec3(kNan), centre, 5.0}, world, size).isEmpty());
}

TEST_F(Segmenting, StatisticsAreThoseOfTheirFormulas) {
    const glm::ivec3 size(10, 4, 3);
    const Volume volume = volumeOf(
        size, [](const glm::ivec3& v) { return v.y == 3 ? kNan : 1e6f + float(v.x); }, {2.0, 2.0, 5.0});
    const VoxelSet all = setWhere(size, [](const glm::ivec3&) { return true; });
    const auto found = statisticsOf(all, volume, progress_);
    ASSERT_TRUE(found && found->values);
    EXPECT_EQ(found->voxels, 120u);
    EXPECT_EQ(found->unmeasured, 30u);
    EXPECT_NEAR(found->ml, 120 * 20.0 / 1000.0, 1e-12);
    EXPECT_NEAR(found->values->mean, 1e6 + 4.5, 1e-6);
    EXPECT_NEAR(found->values->deviation, std::sqrt(99.0 / 12.0), 1e-6) << "of a uniform distribution";
    EXPECT_EQ(found->values->least, 1e6);
    EXPECT_EQ(found->values->most, 1e6 + 9);
    EXPECT_FALSE(statisticsOf({}, volume, progress_)->values);
}

}  // namespace
}  // namespace macula::segment
