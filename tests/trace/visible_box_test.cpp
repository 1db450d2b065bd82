// The box around what can be seen, on grids whose voxels are known.
#include "pipeline/volume/visible_box.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "trace/extreme_scenes.h"

namespace macula {
namespace {

using scenes::grid;
using scenes::homogeneous;

Box boxOf(const Volume& volume, const Clip& clip = {}) {
    const BrickGrid bricks = makeBrickGrid(volume);
    return visibleBoxMm(volume, bricks, makeMedium(volume, bricks, homogeneous(0.1), clip));
}

// One voxel is interpolated into the cells around it, 19 to 21: bricks 2, of cells from voxel 15 to 23, along
// x; 0 and 1, -1 to 7 to 15, along y, where voxel 7 lies on the face of both; along z the volume ends first.
TEST(VisibleBox, IsThatOfTheBricksWithMatter) {
    const glm::ivec3 size(64, 64, 12);
    const auto volume =
        scenes::volumeOf(size, affine({2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {100, 200, 300}),
                         [](int i, int j, int k) { return std::uint16_t(i == 20 && j == 7 && k == 11); });
    const Box box = boxOf(*volume);
    EXPECT_EQ(box.low, glm::dvec3(100 + 2 * 15, 200 - 3 * 0.5, 300 + 4 * 7));
    EXPECT_EQ(box.high, glm::dvec3(100 + 2 * 23, 200 + 3 * 15, 300 + 4 * 11.5));
}

TEST(VisibleBox, OfAllIsTheVolume) {
    const glm::ivec3 size(17, 16, 9);
    const auto full = scenes::volumeOf(size, grid({0.5, 1, 2}, size, {1e5, -1e5, 10}),
                                       [](int, int, int) { return std::uint16_t(1); });
    const Box box = boxOf(*full);
    const Box all = full->worldBox();
    EXPECT_LT(glm::distance(box.low, all.low) + glm::distance(box.high, all.high), 1e-9);
}

TEST(VisibleBox, OfNothingIsEmpty) {
    const glm::ivec3 size(16);
    const auto none =
        scenes::volumeOf(size, grid(glm::dvec3(1.0), size), [](int, int, int) { return std::uint16_t(0); });
    const Box box = boxOf(*none);
    for (int axis = 0; axis < 3; ++axis) EXPECT_GT(box.low[axis], box.high[axis]);
}

// Of a ball on a turned, sheared grid: every voxel with matter is inside, and no side is further away than a
// brick is wide.
TEST(VisibleBox, HoldsAllMatterAndLittleMoreOnAnyGrid) {
    const glm::ivec3 size(60, 50, 40);
    glm::dmat4 toWorld = glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -1))) *
                         affine({0.8, 0, 0}, {0.1, 1.0, 0}, {0, 0.3, 1.4}, {-24, -25, -28});
    const auto inBall = [](int i, int j, int k) {
        return glm::distance(glm::dvec3(i, j, k), glm::dvec3(30, 25, 20)) < 9.0;
    };
    const auto ball = scenes::volumeOf(
        size, toWorld, [&](int i, int j, int k) { return std::uint16_t(inBall(i, j, k) ? 5 : 0); });
    const Box box = boxOf(*ball);
    Box matter{glm::dvec3(1e9), glm::dvec3(-1e9)};
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                if (!inBall(i, j, k)) continue;
                const glm::dvec3 p = transformPoint(toWorld, {i, j, k});
                matter = {glm::min(matter.low, p), glm::max(matter.high, p)};
            }
        }
    }
    const double brickMm = 8.0 * (0.8 + 1.1 + 1.5);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(box.low[axis], matter.low[axis]);
        EXPECT_GE(box.high[axis], matter.high[axis]);
        EXPECT_GT(box.low[axis], matter.low[axis] - brickMm);
        EXPECT_LT(box.high[axis], matter.high[axis] + brickMm);
    }
}

TEST(VisibleBox, EndsNearWhereAClipEnds) {
    const glm::ivec3 size(64, 16, 16);
    const auto full =
        scenes::volumeOf(size, grid(glm::dvec3(1.0), size), [](int, int, int) { return std::uint16_t(1); });
    Clip clip;
    clip.planes = {HalfSpace{.normal = {1, 0, 0}, .offsetMm = 10.0}};
    const Box box = boxOf(*full, clip);
    EXPECT_LE(box.low.x, 10.0);
    EXPECT_GT(box.low.x, 10.0 - 2 * 8.0);
    EXPECT_EQ(box.high.x, 32.0);
}

}  // namespace
}  // namespace macula
