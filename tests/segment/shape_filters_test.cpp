// Filters of shapes against their definitions, and surfaces against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>

#include "base/atomic_file.h"
#include "naive_filters.h"
#include "segment/shape_filters.h"
#include "segment/surface.h"
#include "segment/surface_file.h"
#include "segment/voxel_sets.h"

namespace macula::segment {
namespace {

using test::setWhere;
using test::someVoxels;

const SegmentGrid kGrids[] = {{{9, 8, 7}, {1.0, 1.0, 1.0}},
                              {{12, 6, 5}, {0.5, 0.5, 5.0}},  // 10 to 1
                              {{5, 5, 1}, {0.7, 0.9, 3.0}}};

class ShapeFilters : public testing::Test {
  protected:
    // Empty, one voxel, all, and some by chance.
    static std::vector<VoxelSet> setsOf(const glm::ivec3& size) {
        std::vector<VoxelSet> sets{
            VoxelSet(), setWhere(size, [](const glm::ivec3& v) { return v == glm::ivec3(1, 1, 0); }),
            setWhere(size, [](const glm::ivec3&) { return true; })};
        for (unsigned seed = 1; seed <= 4; ++seed) sets.push_back(someVoxels(size, 0.2 * seed, seed));
        return sets;
    }
    // Each edge in both directions, once each; around each vertex one fan.
    static void expectClosed(const TriangleMesh& mesh) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> third;
        for (const auto& t : mesh.triangles)
            for (std::size_t n = 0; n < 3; ++n) {
                const auto edge = std::pair(t[n], t[(n + 1) % 3]);
                EXPECT_TRUE(third.emplace(edge, t[(n + 2) % 3]).second) << "an edge with more triangles";
            }
        std::vector<int> fans(mesh.verticesMm.size());
        for (const auto& [edge, other] : third) {
            ASSERT_TRUE(third.contains({edge.second, edge.first})) << "an open edge";
            ++fans[edge.first];
        }
        std::vector<bool> isSeen(mesh.verticesMm.size());
        for (const auto& [edge, other] : third) {
            const std::uint32_t middle = edge.first;
            if (isSeen[middle]) continue;
            isSeen[middle] = true;
            int steps = 0;
            std::uint32_t rim = edge.second;
            do {
                rim = third.at({middle, rim});
                ++steps;
            } while (rim != edge.second && steps <= fans[middle]);
            EXPECT_EQ(steps, fans[middle]) << "two fans meet in a vertex";
        }
    }

    Progress progress_;
};

TEST_F(ShapeFilters, TheMedianIsTheMajority) {
    for (const SegmentGrid& grid : kGrids) {
        for (const VoxelSet& set : setsOf(grid.size)) {
            const auto found = medianOf(set, grid, 1.2, progress_);
            ASSERT_TRUE(found) << found.error().message;
            const VoxelSet truth = setWhere(grid.size, [&](const glm::ivec3& v) {
                int in = 0;
                int all = 0;
                test::forEachVoxel(grid.size, [&](const glm::ivec3& u) {
                    const glm::dvec3 mm = glm::abs(glm::dvec3(u - v) * grid.spacingMm);
                    if (std::max({mm.x, mm.y, mm.z}) > 1.2) return;
                    ++all;
                    in += set.contains(u) ? 1 : 0;
                });
                return 2 * in > all;
            });
            EXPECT_TRUE(*found == truth) << grid.size.x << " " << set.count();
        }
    }
}

TEST_F(ShapeFilters, TheGaussianIsAWeightedMajority) {
    for (const SegmentGrid& grid : kGrids) {
        for (const VoxelSet& set : setsOf(grid.size)) {
            const auto found = gaussianOf(set, grid, 0.8, progress_);
            ASSERT_TRUE(found);
            std::size_t wrong = 0;
            test::forEachVoxel(grid.size, [&](const glm::ivec3& v) {
                double in = 0.0;
                double all = 0.0;
                test::forEachVoxel(grid.size, [&](const glm::ivec3& u) {
                    const glm::dvec3 mm = glm::dvec3(u - v) * grid.spacingMm;
                    if (std::max({std::abs(mm.x), std::abs(mm.y), std::abs(mm.z)}) > 2.4 + 1e-9) return;
                    const double weight = std::exp(-0.5 * glm::dot(mm, mm) / 0.64);
                    all += weight;
                    if (set.contains(u)) in += weight;
                });
                if (std::abs(in / all - 0.5) < 1e-5) return;  // float32 may decide either way
                wrong += found->contains(v) != (in / all > 0.5) ? 1u : 0u;
            });
            EXPECT_EQ(wrong, 0u);
        }
    }
}

TEST_F(ShapeFilters, GrowingAndShrinkingAreDistances) {
    for (const SegmentGrid& grid : kGrids) {
        for (const VoxelSet& set : setsOf(grid.size)) {
            for (const double mm : {0.5, 1.0, 1.5, 5.0}) {
                const auto grown = grownBy(set, grid, mm, progress_);
                const auto shrunk = shrunkBy(set, grid, mm, progress_);
                ASSERT_TRUE(grown && shrunk);
                const auto isIn = [&](const glm::ivec3& v) { return set.contains(v); };
                const auto isOut = [&](const glm::ivec3& v) { return !set.contains(v); };
                EXPECT_TRUE(*grown == setWhere(grid.size, [&](const glm::ivec3& v) {
                    return test::isNear(v, grid, mm, isIn);
                })) << mm;
                EXPECT_TRUE(*shrunk == setWhere(grid.size, [&](const glm::ivec3& v) {
                    return set.contains(v) && !test::isNear(v, grid, mm, isOut);
                })) << mm;
            }
        }
    }
}

TEST_F(ShapeFilters, LengthsThatAreNoneAreRefused) {
    const VoxelSet one = setWhere({3, 3, 3}, [](const glm::ivec3& v) { return v == glm::ivec3(1); });
    for (const double mm : {0.0, -1.0, 101.0, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(grownBy(one, kGrids[0], mm, progress_).error().code, ErrorCode::usage);
        EXPECT_FALSE(shrunkBy(one, kGrids[0], mm, progress_));
        EXPECT_FALSE(medianOf(one, kGrids[0], mm, progress_));
        EXPECT_FALSE(gaussianOf(one, kGrids[0], mm, progress_));
    }
    Progress cancelled;
    cancelled.token().cancel();
    EXPECT_EQ(grownBy(one, kGrids[0], 2.0, cancelled).error().code, ErrorCode::cancelled);
}

// Two discs of a cone: what lies between has the radius between.
TEST_F(ShapeFilters, BetweenTwoDiscsLiesACone) {
    const SegmentGrid grid{{61, 61, 11}, {0.5, 0.5, 5.0}};
    const auto radiusMm = [](int k) { return 12.0 - k; };
    const auto disc = [&](const glm::ivec3& v, double radius) {
        return glm::length(glm::dvec2(v.x - 30, v.y - 30) * 0.5) <= radius;
    };
    const VoxelSet painted = setWhere(
        grid.size, [&](const glm::ivec3& v) { return (v.z == 0 || v.z == 10) && disc(v, radiusMm(v.z)); });
    for (const int axis : {-1, 2}) {
        const auto filled = filledBetweenSlices(painted, grid, axis, progress_);
        ASSERT_TRUE(filled) << filled.error().message;
        std::size_t wrong = 0;
        test::forEachVoxel(grid.size, [&](const glm::ivec3& v) {
            const double mm = glm::length(glm::dvec2(v.x - 30, v.y - 30) * 0.5);
            if (std::abs(mm - radiusMm(v.z)) < 0.5) return;  // half a voxel each way
            wrong += filled->contains(v) != (mm < radiusMm(v.z)) ? 1u : 0u;
        });
        EXPECT_EQ(wrong, 0u);
    }
    EXPECT_EQ(filledBetweenSlices(painted, grid, 0, progress_).error().code, ErrorCode::usage) << "no gap";
    EXPECT_TRUE(filledBetweenSlices({}, grid, -1, progress_)->isEmpty());
}

TEST_F(ShapeFilters, ASurfaceIsClosedWhateverTheVoxels) {
    const glm::dmat4 world = affine({0.5, 0, 0}, {0, 0.5, 0.1}, {0, 0, 5.0}, {10, 20, 30});
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const VoxelSet set = someVoxels({5, 5, 5}, 0.05 * seed, seed);
        if (set.isEmpty()) continue;
        const auto mesh = surfaceOf(set, world, int(seed % 3), progress_);
        ASSERT_TRUE(mesh);
        expectClosed(*mesh);
    }
    EXPECT_EQ(surfaceOf({}, world, 0, progress_).error().code, ErrorCode::usage);
}

TEST_F(ShapeFilters, TheSurfaceOfABallHasItsVolume) {
    constexpr double kRadiusMm = 12.0;
    for (const bool isMirrored : {false, true}) {
        const glm::dvec3 spacing(0.7, 0.8, 1.1);
        const glm::ivec3 size(51, 45, 35);
        const glm::dvec3 centre = glm::dvec3(25, 22, 17) * spacing;
        const VoxelSet ball = test::ball(size, spacing, centre, kRadiusMm);
        const glm::dmat4 world =
            affine({isMirrored ? -0.7 : 0.7, 0, 0}, {0, 0.8, 0}, {0, 0, 1.1}, {100, -50, 7});
        for (const int passes : {0, 10}) {
            const auto mesh = surfaceOf(ball, world, passes, progress_);
            ASSERT_TRUE(mesh);
            expectClosed(*mesh);
            const double truth = 4.0 / 3.0 * 3.14159265358979 * std::pow(kRadiusMm, 3);
            EXPECT_NEAR(volumeMm3(*mesh) / truth, 1.0, 0.01) << passes;
            const glm::dvec3 middle = transformPoint(world, {25, 22, 17});
            for (const glm::dvec3& vertex : mesh->verticesMm)
                ASSERT_NEAR(glm::distance(vertex, middle), kRadiusMm, 1.2);
        }
    }
}

TEST_F(ShapeFilters, SurfaceFilesHoldTheMeshInMm) {
    const VoxelSet ball = test::ball({12, 12, 12}, glm::dvec3(1.0), glm::dvec3(5.5), 4.0);
    const auto mesh = surfaceOf(ball, affine({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {-300, 40, 900}), 2, progress_);
    ASSERT_TRUE(mesh);
    const auto folder = std::filesystem::temp_directory_path();
    const auto stl = folder / "macula-surface-test.stl";
    const auto glb = folder / "macula-surface-test.glb";
    ASSERT_TRUE(writeSurface(stl, *mesh, {255, 0, 0}));
    ASSERT_TRUE(writeSurface(glb, *mesh, {255, 0, 0}));
    EXPECT_FALSE(writeSurface(folder / "a.obj", *mesh, {255, 0, 0}));
    const auto bytes = readText(stl);
    ASSERT_TRUE(bytes);
    ASSERT_EQ(bytes->size(), 84 + 50 * mesh->triangles.size());
    EXPECT_FALSE(bytes->starts_with("solid"));
    EXPECT_NE(bytes->substr(0, 80).find("LPS"), std::string::npos);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes->data() + 80, 4);
    EXPECT_EQ(count, mesh->triangles.size());
    for (std::size_t n = 0; n < mesh->triangles.size(); ++n) {
        std::array<float, 12> numbers{};
        std::memcpy(numbers.data(), bytes->data() + 84 + 50 * n, sizeof numbers);
        glm::dvec3 middle(0.0);
        for (std::size_t v = 0; v < 3; ++v) {
            const glm::dvec3 at(numbers[3 + 3 * v], numbers[4 + 3 * v], numbers[5 + 3 * v]);
            ASSERT_LT(glm::distance(at, mesh->verticesMm[mesh->triangles[n][v]]), 1e-3);
            middle += at / 3.0;
        }
        const glm::dvec3 normal(numbers[0], numbers[1], numbers[2]);
        ASSERT_GT(glm::dot(normal, middle - glm::dvec3(-289, 51, 911)), 0.0) << "outwards";
    }
    const auto whole = readText(glb);
    ASSERT_TRUE(whole);
    std::array<std::uint32_t, 5> head{};
    std::memcpy(head.data(), whole->data(), sizeof head);
    EXPECT_TRUE(whole->starts_with("glTF"));
    EXPECT_EQ(head[2], whole->size());
    EXPECT_EQ(head[3] % 4, 0u);
    const std::string json = whole->substr(20, head[3]);
    EXPECT_NE(json.find("\"unit\":\"mm\""), std::string::npos);
    EXPECT_NE(json.find("[1.000000,0.000000,0.000000,1]"), std::string::npos) << "red";
    std::array<float, 3> first{};
    std::memcpy(first.data(), whole->data() + 20 + head[3] + 8, sizeof first);
    EXPECT_LT(glm::distance(glm::dvec3(first[0], first[1], first[2]), mesh->verticesMm[0]), 1e-3);
    std::filesystem::remove(stl);
    std::filesystem::remove(glb);
}

}  // namespace
}  // namespace macula::segment
