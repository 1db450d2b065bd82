// Distances against those to every block of the mask, and what is made of them.
#include "segment/distance.h"

#include <gtest/gtest.h>
#include <itkObject.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "segment/itk_filters.h"

namespace macula::segment {
namespace {

TEST(Distance, IsThatToTheNearestBlock) {
    const Grid grid{.size = {41, 37, 29}, .spacingMm = {2.1, 1.7, 3.3}};
    std::mt19937 random(7);
    Mask mask(grid.count());
    for (int n = 0; n < 25; ++n) mask[random() % mask.size()] = 1;
    for (int b = 5; b < 15; ++b) std::fill_n(mask.begin() + std::ptrdiff_t(grid.index(8, b, 12)), 9, 1);
    std::vector<glm::dvec3> inMask;
    const auto forEachBlock = [&](const auto& use) {
        std::size_t n = 0;
        for (int c = 0; c < grid.size.z; ++c) {
            for (int b = 0; b < grid.size.y; ++b) {
                for (int a = 0; a < grid.size.x; ++a) use(n++, glm::dvec3(a, b, c) * grid.spacingMm);
            }
        }
    };
    forEachBlock([&](std::size_t n, const glm::dvec3& at) {
        if (mask[n] != 0) inMask.push_back(at);
    });
    const std::vector<float> actual = distanceTo(grid, mask);
    forEachBlock([&](std::size_t n, const glm::dvec3& at) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& other : inMask) nearest = std::min(nearest, glm::distance(at, other));
        ASSERT_NEAR(actual[n], nearest, 1e-4) << n;
    });
}

// They are of the whole process, in which Macula may be a guest.
TEST(Itk, KeepsTheWarningsOfItsOtherUsers) {
    const Grid grid{.size = {3, 3, 3}};
    EXPECT_TRUE(connectedParts(grid, Mask(grid.count(), 1), true).ok());
    EXPECT_TRUE(itk::Object::GetGlobalWarningDisplay());
}

// One block, a line, the whole grid, and spacings a million to one apart.
TEST(Distance, HoldsAtTheExtremes) {
    EXPECT_EQ(distanceTo({.size = {1, 1, 1}}, {1}), std::vector<float>{0.0f});
    EXPECT_EQ(distanceTo({.size = {0, 0, 0}}, {}), std::vector<float>{});
    const Grid line{.size = {1, 4, 1}, .spacingMm = {1.0, 0.5, 1.0}};
    EXPECT_EQ(distanceTo(line, {0, 1, 0, 0}), (std::vector<float>{0.5f, 0.0f, 0.5f, 1.0f}));
    EXPECT_EQ(distanceTo(line, {1, 1, 1, 1}), std::vector<float>(4));
    const Grid flat{.size = {2, 2, 2}, .spacingMm = {1e3, 1e-3, 1.0}};
    const std::vector<float> far = distanceTo(flat, {1, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_FLOAT_EQ(far[flat.index(0, 1, 0)], 1e-3f);
    EXPECT_FLOAT_EQ(far[flat.index(0, 0, 1)], 1.0f);
    EXPECT_FLOAT_EQ(far[flat.index(1, 1, 1)], float(std::hypot(1e3, 1e-3, 1.0)));
}

TEST(Distance, OfNothingIsInfinite) {
    const Grid grid{.size = {3, 1, 2}};
    const std::vector<float> distance = distanceTo(grid, Mask(6));
    ASSERT_EQ(distance.size(), 6u);
    for (const float mm : distance) EXPECT_TRUE(std::isinf(mm));
}

// A plate 3 blocks thick beside a cube of 9, and a plate that the edge of the grid cuts.
TEST(Distance, OpeningKeepsWhatIsThick) {
    const Grid grid{.size = {40, 20, 20}, .spacingMm = {1.0, 1.0, 1.0}};
    Mask mask(grid.count());
    for (int c = 4; c < 13; ++c) {
        for (int b = 4; b < 13; ++b) {
            for (int a = 4; a < 13; ++a) mask[grid.index(a, b, c)] = 1;
            for (int a = 20; a < 23; ++a) mask[grid.index(a, b, c)] = 1;
        }
    }
    const auto [open, depthMm] = opened(grid, mask, 2.5);
    EXPECT_EQ(open[grid.index(8, 8, 8)], 1);
    EXPECT_EQ(open[grid.index(4, 8, 8)], 1);
    EXPECT_EQ(open[grid.index(21, 8, 8)], 0);
    EXPECT_EQ(depthMm[grid.index(8, 8, 8)], 5.0f);
    EXPECT_EQ(depthMm[grid.index(21, 8, 8)], 2.0f);
    EXPECT_EQ(depthMm[grid.index(30, 8, 8)], 0.0f);
}

}  // namespace
}  // namespace macula::segment
