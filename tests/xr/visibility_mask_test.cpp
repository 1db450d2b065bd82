// What is not drawn because no lens shows it.
#include "xr/visibility_mask.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace macula::xr {
namespace {

const Eye kEye{{}, -1.0, 1.0, 1.0, -1.0};

// The upper left corner, from half of each side.
VisibilityMask corner() {
    return {{{-1.0, 1.0}, {0.0, 1.0}, {-1.0, 0.0}}, std::vector<std::uint32_t>{0, 1, 2}};
}
// A strip of that width at the right side, of two triangles.
VisibilityMask strip(double width) {
    return {{{1.0 - width, 2.0}, {2.0, 2.0}, {2.0, -2.0}, {1.0 - width, -2.0}},
            std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}};
}

TEST(VisibilityMask, WithoutOneAllCanBeSeen) {
    const VisibilityMask none;
    EXPECT_TRUE(none.isEmpty());
    for (const VisibilityMask::Run& run : none.rowsOf(kEye, {40, 30}))
        EXPECT_EQ(run, (VisibilityMask::Run{0, 40}));
    EXPECT_EQ(none.visiblePartOf(kEye).left, -1.0);
    const auto bands = bandsOf(none.rowsOf(kEye, {40, 30}));
    ASSERT_EQ(bands.size(), 1u) << "a copy of all is one piece";
    EXPECT_EQ(bands[0], (VisiblePart{{0, 0}, {40, 30}}));
}

TEST(VisibilityMask, ACornerIsLeftOutRowByRow) {
    const auto rows = corner().rowsOf(kEye, {40, 40});
    for (int y = 0; y < 40; ++y) {
        // A pixel is hidden where x + 1 < y in tangents from the middle: 20 - y of them.
        const int hidden = y < 20 ? 20 - y : 0;
        EXPECT_NEAR(rows[std::size_t(y)].first, hidden, 1) << y;
        EXPECT_EQ(rows[std::size_t(y)].end, 40) << y;
    }
    // A corner moves no side.
    const Eye part = corner().visiblePartOf(kEye);
    EXPECT_EQ(part.left, kEye.left);
    EXPECT_EQ(part.up, kEye.up);
    int pixels = 0;
    for (const VisiblePart& band : bandsOf(rows)) {
        for (int y = band.firstPx.y; y < band.firstPx.y + band.sizePx.y; ++y)
            EXPECT_LE(band.firstPx.x, rows[std::size_t(y)].first) << "all that can be seen is in a band";
        pixels += band.sizePx.x * band.sizePx.y;
    }
    EXPECT_LT(pixels, 40 * 40 - 100);
}

TEST(VisibilityMask, AStripMovesTheSide) {
    const Eye part = strip(0.4).visiblePartOf(kEye);
    EXPECT_EQ(part.left, kEye.left);
    EXPECT_GE(part.right, 0.6);
    EXPECT_LE(part.right, 0.6 + 3.0 * 2.0 / 256.0);
    EXPECT_EQ(part.up, kEye.up);
}

// The same as asking of each pixel alone whether a triangle has its middle.
TEST(VisibilityMask, AgreesWithEachPixelAlone) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-1.5, 1.5);
    const Eye eye{{}, -1.2, 0.7, 0.9, -1.1};
    const glm::ivec2 sizePx(61, 47);
    for (int k = 0; k < 40; ++k) {
        std::vector<glm::dvec2> corners;
        for (int i = 0; i < 6; ++i) corners.push_back({place(random), place(random)});
        const std::vector<std::uint32_t> indices{0, 1, 2, 3, 4, 5};
        const auto rows = VisibilityMask(corners, indices).rowsOf(eye, sizePx);
        const auto isIn = [&](const glm::dvec2& p, std::size_t first) {
            const auto side = [&](std::size_t i, std::size_t j) {
                const glm::dvec2 along = corners[j] - corners[i];
                const glm::dvec2 to = p - corners[i];
                return along.x * to.y - along.y * to.x > 0.0;
            };
            const bool a = side(first, first + 1);
            return a == side(first + 1, first + 2) && a == side(first + 2, first);
        };
        for (int y = 0; y < sizePx.y; ++y) {
            VisibilityMask::Run wanted{sizePx.x, 0};
            for (int x = 0; x < sizePx.x; ++x) {
                const glm::dvec2 p(eye.left + (x + 0.5) / sizePx.x * (eye.right - eye.left),
                                   eye.up - (y + 0.5) / sizePx.y * (eye.up - eye.down));
                if (isIn(p, 0) || isIn(p, 3)) continue;
                wanted = {std::min(wanted.first, x), std::max(wanted.end, x + 1)};
            }
            if (wanted.end == 0) wanted = {};
            EXPECT_EQ(rows[std::size_t(y)], wanted) << k << ": " << y;
        }
    }
}

TEST(VisibilityMask, WhatIsNoMaskHidesNothing) {
    const double nan = std::nan("");
    const std::vector<std::uint32_t> three{0, 1, 2};
    const std::vector<std::uint32_t> beyond{0, 1, 7};
    const std::vector<std::uint32_t> two{0, 1};
    EXPECT_TRUE(VisibilityMask({{0, 0}, {1, nan}, {1, 1}}, three).isEmpty());
    EXPECT_TRUE(
        VisibilityMask({{0, 0}, {1, std::numeric_limits<double>::infinity()}, {1, 1}}, three).isEmpty());
    EXPECT_TRUE(VisibilityMask({{0, 0}, {1, 0}, {1, 1}}, beyond).isEmpty());
    EXPECT_TRUE(VisibilityMask({{0, 0}, {1, 0}, {1, 1}}, two).isEmpty());
    // One that hides all moves no side: something is shown nevertheless.
    const VisibilityMask all({{-9, -9}, {9, -9}, {0, 18}}, three);
    EXPECT_FALSE(all.isEmpty());
    EXPECT_EQ(all.visiblePartOf(kEye).right, kEye.right);
    EXPECT_EQ(bandsOf(all.rowsOf(kEye, {16, 16})).size(), 0u);
    EXPECT_TRUE(all.rowsOf(kEye, {0, 0}).empty());
}

}  // namespace
}  // namespace macula::xr
