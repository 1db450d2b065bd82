// What of the search for surface points needs no device.
#include <gtest/gtest.h>

#include <numeric>

#include "pipeline/trace/point_light.h"
#include "pipeline/trace/surface_candidates.h"
#include "pipeline/volume/brick_grid.h"

namespace macula::trace {
namespace {

TEST(MatterCells, AreOneForABlockAndManyForSpecks) {
    const glm::ivec3 voxels{64, 60, 33};
    const glm::ivec3 grid = brickCount(voxels);
    const glm::dmat3 mm(glm::dvec3(2.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, 0.5, 3.0));
    const auto at = [&](int x, int y, int z) {
        return (std::size_t(z) * std::size_t(grid.y) + std::size_t(y)) * std::size_t(grid.x) + std::size_t(x);
    };
    std::vector<float> bounds(at(0, 0, grid.z), -1.0f);
    EXPECT_TRUE(matterCells(bounds, voxels, mm).empty());

    bounds[at(1, 2, 0)] = 0.1f;
    bounds[at(7, 6, 4)] = 3.0f;
    const auto specks = matterCells(bounds, voxels, mm);
    ASSERT_EQ(specks.size(), 2u);
    EXPECT_EQ(specks[0].low, glm::vec3(7.5f, 15.5f, 0.0f));  // bricks begin half a voxel early
    EXPECT_EQ(specks[0].high, glm::vec3(15.5f, 23.5f, 7.5f));
    EXPECT_EQ(specks[1].high, glm::vec3(63.5f, 55.5f, 33.0f));
    // Twice dx dy 2 x 1, twice dy dz |(0,1,0) x (0,.5,3)| = 3, twice dz dx |(0,.5,3) x (2,0,0)| = sqrt(37).
    const double expected = 2.0 * (2.0 * 64.0 + 3.0 * 8.0 * 7.5 + std::sqrt(37.0) * 7.5 * 8.0);
    EXPECT_NEAR(areasOf(specks, mm)[0], expected, 1e-9);

    std::fill(bounds.begin(), bounds.end(), 1.0f);
    const auto whole = matterCells(bounds, voxels, mm);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0].low, glm::vec3(0.0f));
    EXPECT_EQ(whole[0].high, glm::vec3(voxels));
}

SurfacePoint facing(const glm::vec3& at, const glm::vec3& centre) {
    return {.positionMm = at, .radiusMm = 1.0f, .centreMm = centre};
}

TEST(ShareLight, AmongNeighboursThatFaceTheSameWay) {
    std::vector<SurfacePoint> points{facing({0, 0, 0}, {0, 0, -0.4f}),
                                     facing({0.5f, 0, 0}, {0, 0, -0.3f}),  // share
                                     facing({0, 0.1f, 0}, {0, 0, 0.4f}),   // the other side of a sheet
                                     facing({0.1f, 0.1f, 0}, {0, 0, 0}),   // faces nowhere
                                     facing({50, 0, 0}, {0, 0, -0.4f})};   // far away
    const std::vector<GatheredLight> light{{glm::dvec3(1.0), 2.0},
                                           {glm::dvec3(3.0), 2.0},
                                           {glm::dvec3(40.0), 4.0},
                                           {glm::dvec3(12.0), 4.0},
                                           {glm::dvec3(0.0), 0.0}};
    shareLight(points, light);
    EXPECT_GT(points[0].radiance.x, 0.51f);
    EXPECT_LT(points[0].radiance.x, 1.0f);
    EXPECT_GT(points[1].radiance.x, 1.0f);
    EXPECT_LT(points[1].radiance.x, 1.49f);
    EXPECT_FLOAT_EQ(points[2].radiance.x, 10.0f);
    EXPECT_FLOAT_EQ(points[3].radiance.x, 3.0f);
    EXPECT_EQ(points[4].radiance.x, 0.0f);  // not a number is no light
    shareLight({}, {});
}

// By the square of the cosine between the ways that they face.
TEST(ShareLight, TheLessTheMoreTheyAreTurned) {
    for (const double degrees : {0.0, 30.0, 60.0, 89.0}) {
        const double angle = glm::radians(degrees);
        std::vector<SurfacePoint> points{
            facing({0, 0, 0}, {0, 0, -0.4f}),
            facing({0, 0, 0}, 0.3f * glm::vec3(std::sin(angle), 0, -std::cos(angle)))};
        shareLight(points, std::vector<GatheredLight>{{glm::dvec3(1.0), 1.0}, {glm::dvec3(0.0), 1.0}});
        const double share = std::cos(angle) * std::cos(angle);
        EXPECT_NEAR(double(points[0].radiance.x), 1.0 / (1.0 + share), 1e-5) << degrees;
        EXPECT_NEAR(double(points[1].radiance.x), share / (1.0 + share), 1e-5) << degrees;
    }
}

// Light is a weighted mean: no point becomes brighter than the brightest of its neighbours, and equal ones
// stay as they are.
TEST(ShareLight, IsAMean) {
    std::vector<SurfacePoint> points;
    std::vector<GatheredLight> light;
    for (int i = 0; i < 200; ++i) {
        const float t = float(i);
        points.push_back(facing({std::fmod(t * 0.618f, 4.0f), std::fmod(t * 0.755f, 4.0f), 0.0f},
                                {std::sin(t), std::cos(t), 2.0f}));
        light.push_back({glm::dvec3(0.25, 0.5, 0.75) * double(i + 1), double(i + 1)});
    }
    shareLight(points, light);
    for (const SurfacePoint& p : points)
        EXPECT_LT(glm::distance(p.radiance, glm::vec3(0.25f, 0.5f, 0.75f)), 1e-5f);
}

}  // namespace
}  // namespace macula::trace
