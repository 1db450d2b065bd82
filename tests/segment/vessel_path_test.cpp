// The way along a vessel: a helix of contrast in noise, beside a straight way that is shorter.
#include "segment/vessel_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace macula::segment {
namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr double kRadiusMm = 14.0;
constexpr double kRiseMm = 36.0;
constexpr double kTubeMm = 2.5;
const glm::dvec3 kSpacingMm{0.8, 0.8, 1.2};
const glm::ivec3 kSize{60, 60, 50};

glm::dvec3 onHelix(double turns) {
    const double angle = kTau * turns;
    return {kRadiusMm * std::cos(angle), kRadiusMm * std::sin(angle), kRiseMm * (turns - 0.5)};
}

glm::dmat4 world() {
    glm::dmat4 m(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        m[axis] *= kSpacingMm[axis];
        m[3][axis] = -0.5 * kSpacingMm[axis] * (kSize[axis] - 1);
    }
    m[3].w = 1.0;
    return m;
}

double fromHelixMm(const glm::dvec3& mm) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 200; ++i) least = std::min(least, glm::distance(mm, onHelix(i / 200.0)));
    return least;
}

Volume volumeOf(std::vector<float> values, const glm::ivec3& size, const glm::dmat4& worldFromVoxel) {
    VolumeOptions options;
    options.size = size;
    options.worldFromVoxel = worldFromVoxel;
    return Volume::createFloat(std::move(options), std::move(values)).value();
}

std::vector<float> makeTube() {
    std::mt19937 random(7);
    std::normal_distribution<float> noise(0.0f, 25.0f);
    std::vector<float> values;
    for (int k = 0; k < kSize.z; ++k)
        for (int j = 0; j < kSize.y; ++j)
            for (int i = 0; i < kSize.x; ++i) {
                const glm::dvec3 mm = glm::dvec3(world() * glm::dvec4(i, j, k, 1.0));
                values.push_back((fromHelixMm(mm) < kTubeMm ? 350.0f : 40.0f) + noise(random));
            }
    return values;
}

const std::vector<float>& tube() {
    static const std::vector<float> values = makeTube();
    return values;
}

double lengthMm(const std::vector<glm::dvec3>& way) {
    double length = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) length += glm::distance(way[i - 1], way[i]);
    return length;
}

TEST(VesselPath, FollowsTheVesselAndNotTheShortestWay) {
    const Volume volume = volumeOf(tube(), kSize, world());
    const std::vector<glm::dvec3> ends{onHelix(0.05), onHelix(0.95)};
    ASSERT_LT(glm::distance(ends[0], ends[1]), 0.5 * 0.9 * std::hypot(kTau * kRadiusMm, kRiseMm));
    const auto way = vesselPath(volume, ends, {});
    ASSERT_TRUE(way) << way.error().message.english();
    for (const glm::dvec3& mm : *way) EXPECT_LT(fromHelixMm(mm), 1.0);
    EXPECT_NEAR(lengthMm(*way) / (0.9 * std::hypot(kTau * kRadiusMm, kRiseMm)), 1.0, 0.03);
    EXPECT_LT(glm::distance(way->front(), ends[0]), 1.0);
    EXPECT_LT(glm::distance(way->back(), ends[1]), 1.0);
    EXPECT_LT(way->size(), 60u) << "points that a hand can move";
}

TEST(VesselPath, MeetsThePlacesBetween) {
    const Volume volume = volumeOf(tube(), kSize, world());
    const std::vector<glm::dvec3> places{onHelix(0.1), onHelix(0.4), onHelix(0.9)};
    const auto way = vesselPath(volume, places, {});
    ASSERT_TRUE(way);
    for (const glm::dvec3& place : places) {
        const auto near =
            std::ranges::min(*way, {}, [&](const glm::dvec3& mm) { return glm::distance(mm, place); });
        EXPECT_LT(glm::distance(near, place), 1.0);
    }
}

TEST(VesselPath, NeedsTwoPlacesInTheVolume) {
    const Volume volume = volumeOf(std::vector<float>(8, 1.0f), {2, 2, 2}, glm::dmat4(1.0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto fails = [&](std::vector<glm::dvec3> places) {
        const auto way = vesselPath(volume, places, {});
        return !way && way.error().code == ErrorCode::usage;
    };
    EXPECT_TRUE(fails({}));
    EXPECT_TRUE(fails({glm::dvec3(0.0), glm::dvec3(0.2, 0.0, 0.0)})) << "the same voxel";
    EXPECT_TRUE(fails({glm::dvec3(0.0), glm::dvec3(5.0)}));
    EXPECT_TRUE(fails({glm::dvec3(0.0), glm::dvec3(nan)}));
    const std::vector<glm::dvec3> corners{glm::dvec3(0.0), glm::dvec3(1.0)};
    EXPECT_TRUE(vesselPath(volume, corners, {})) << "a volume of one value";
}

TEST(VesselPath, CrossesWhatHasNoValueAndStopsWhenAsked) {
    std::vector<float> values(20 * 5 * 5, 100.0f);
    for (int at = 0; at < 20 * 5 * 5; ++at)
        if (at % 20 == 10) values[std::size_t(at)] = std::numeric_limits<float>::quiet_NaN();
    const Volume volume = volumeOf(values, {20, 5, 5}, glm::dmat4(1.0));
    const std::vector<glm::dvec3> ends{glm::dvec3(1.0, 2.0, 2.0), glm::dvec3(18.0, 2.0, 2.0)};
    const auto way = vesselPath(volume, ends, {});
    ASSERT_TRUE(way);
    for (const glm::dvec3& mm : *way) EXPECT_TRUE(std::isfinite(mm.x + mm.y + mm.z));
    const CancelToken token;
    token.cancel();
    const auto none = vesselPath(volume, ends, token);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::segment
