#include "scene/clip/clip_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/phantom.h"
#include "scene/choice/clip_choice.h"

namespace macula::scene {
namespace {

constexpr Box kBox{{-10, -20, -30}, {10, 20, 30}};

slices::SlicePlane axial(double zMm) {
    return {.centreMm = {3, -7, zMm}, .right = {1, 0, 0}, .down = {0, 1, 0}};
}

slices::SlicePlane diagonal(const glm::dvec3& centreMm) {
    return {.centreMm = centreMm,
            .right = glm::normalize(glm::dvec3(1, -1, 0)),
            .down = glm::normalize(glm::dvec3(1, 1, -2))};
}

// Convex, from right to down: each corner turns that way.
void expectOrdered(const std::vector<glm::dvec3>& outline, const slices::SlicePlane& plane) {
    const glm::dvec3 normal = glm::cross(plane.right, plane.down);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec3& a = outline[i];
        const glm::dvec3& b = outline[(i + 1) % outline.size()];
        const glm::dvec3& c = outline[(i + 2) % outline.size()];
        EXPECT_GT(glm::dot(glm::cross(b - a, c - b), normal), 0.0) << i;
        EXPECT_NEAR(glm::dot(a - plane.centreMm, normal), 0.0, 1e-9) << i;
    }
}

TEST(ClipOutline, OfAnAxialSliceIsTheBoxFromAbove) {
    const auto outline = outlineMm(kBox, axial(5));
    ASSERT_EQ(outline.size(), 4u);
    expectOrdered(outline, axial(5));
    glm::dvec3 low = outline[0];
    glm::dvec3 high = outline[0];
    for (const glm::dvec3& p : outline) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    EXPECT_EQ(low, glm::dvec3(-10, -20, 5));
    EXPECT_EQ(high, glm::dvec3(10, 20, 5));
}

TEST(ClipOutline, OfACubeCutAcrossItsDiagonalIsAHexagon) {
    const Box cube{{-1, -1, -1}, {1, 1, 1}};
    const auto plane = diagonal({0, 0, 0});
    const auto outline = outlineMm(cube, plane);
    ASSERT_EQ(outline.size(), 6u);
    expectOrdered(outline, plane);
    for (const glm::dvec3& p : outline) EXPECT_NEAR(glm::length(p), std::sqrt(2.0), 1e-12);
}

TEST(ClipOutline, NearACornerIsATriangle) {
    const auto plane = diagonal({9, 19, 29});
    const auto outline = outlineMm(kBox, plane);
    ASSERT_EQ(outline.size(), 3u);
    expectOrdered(outline, plane);
}

// A slice on a face of the box shows where it is cut.
TEST(ClipOutline, OnAFaceIsThatFace) {
    EXPECT_EQ(outlineMm(kBox, axial(30)).size(), 4u);
    EXPECT_EQ(outlineMm(kBox, axial(-30)).size(), 4u);
}

TEST(ClipOutline, IsEmptyWhereTheyDoNotMeet) {
    EXPECT_TRUE(outlineMm(kBox, axial(30.001)).empty());
    EXPECT_TRUE(outlineMm(kBox, axial(-1e9)).empty());
    EXPECT_TRUE(outlineMm(kBox, diagonal({11, 20, 30})).empty());
    EXPECT_TRUE(outlineMm({{1, 1, 1}, {0, 2, 2}}, axial(1.5)).empty()) << "an empty box";
    EXPECT_TRUE(outlineMm({{1, 1, 1}, {1, 2, 2}}, axial(1.5)).empty()) << "a flat box";
}

TEST(ClipOutline, IsEmptyOfWhatIsNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(outlineMm(kBox, axial(nan)).empty());
    EXPECT_TRUE(outlineMm(kBox, axial(infinite)).empty());
    EXPECT_TRUE(outlineMm(kBox, axial(1e308)).empty());
    EXPECT_TRUE(outlineMm({{nan, -1, -1}, {1, 1, 1}}, axial(0)).empty());
    EXPECT_TRUE(outlineMm({{-1e308, -1, -1}, {1e308, 1, 1}}, axial(0)).empty());
    EXPECT_TRUE(outlineMm(kBox, {.centreMm = {}, .right = {}, .down = {}}).empty());
}

TEST(ClipOutline, OfAClipIsWhatItKeeps) {
    const Volume volume = phantom::make({.size = {12, 10, 8}, .spacingMm = {20, 20, 20}});
    const Box all = volume.worldBox();
    const auto plane = axial(all.centre().z);
    EXPECT_TRUE(keptOutlineMm(std::nullopt, volume, plane).empty()) << "nothing is cut off";
    const auto outline = keptOutlineMm(*chooseClip("left-half"), volume, plane);
    ASSERT_EQ(outline.size(), 4u);
    double lowest = outline[0].x;
    double highest = outline[0].x;
    for (const glm::dvec3& p : outline) {
        lowest = std::min(lowest, p.x);
        highest = std::max(highest, p.x);
    }
    EXPECT_NEAR(lowest, all.centre().x, 1e-9) << "L is positive";
    EXPECT_NEAR(highest, all.high.x, 1e-9);
}

}  // namespace
}  // namespace macula::scene
