// Lines of equal value: circles of closed form, and every piece against a slow walk over all squares.
#include "slices/contour_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "slices/made_volumes.h"

namespace macula::slices {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

SampledSlice sliceOf(const glm::ivec2& sizePx, const std::function<double(const glm::dvec2&)>& value) {
    SampledSlice slice{.sizePx = sizePx, .values = {}};
    for (int y = 0; y < sizePx.y; ++y)
        for (int x = 0; x < sizePx.x; ++x) slice.values.push_back(float(value({x + 0.5, y + 0.5})));
    return slice;
}

bool isClosed(const ContourLine& line) {
    return line.size() > 2 && line.front() == line.back();
}

double lengthOf(const ContourLine& line) {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
    return length;
}

// Twice the signed area, positive clockwise where y goes down.
double areaOf(const ContourLine& line) {
    double area = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        area += line[i - 1].x * line[i].y - line[i].x * line[i - 1].y;
    return 0.5 * area;
}

TEST(ContourLines, OfAConeAreCircles) {
    const glm::dvec2 centre(50.3, 47.9);
    const SampledSlice slice =
        sliceOf({101, 97}, [&](const glm::dvec2& at) { return 60.0 - glm::distance(at, centre); });
    for (const double radius : {1.7, 10.0, 30.0, 45.0}) {
        const auto lines = contourLines(slice, 60.0 - radius);
        ASSERT_EQ(lines.size(), 1u) << radius;
        EXPECT_TRUE(isClosed(lines[0]));
        for (const glm::dvec2& point : lines[0]) EXPECT_NEAR(glm::distance(point, centre), radius, 0.1);
        EXPECT_NEAR(areaOf(lines[0]), std::numbers::pi * radius * radius, 0.02 * radius * radius + 1.0)
            << "high values are on the right";
    }
}

// As the window draws them: voxels of 2.5 mm, a picture with 0.8 mm for each pixel. Of smaller spheres the
// grid of the dose itself is off by more.
TEST(ContourLines, OfASphericalDoseAreCirclesToATenthOfAPixel) {
    const glm::ivec3 size(41, 41, 31);
    const double mm = 2.5;
    const glm::dvec3 centre(3.0, -2.0, 1.0);
    const glm::dmat4 worldFromVoxel = affine({mm, 0, 0}, {0, mm, 0}, {0, 0, mm}, {-50, -50, -37.5});
    std::vector<float> doses;
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const glm::dvec3 at(worldFromVoxel * glm::dvec4(i, j, k, 1));
                doses.push_back(float(60.0 - glm::distance(at, centre)));
            }
        }
    }
    const Volume dose = test::volumeOf(size, worldFromVoxel, doses);
    const SliceFrame frame{
        .plane = planeOf(Orientation::axial, {0, 0, 1}), .mmPerPixel = 0.8, .sizePx = {160, 150}};
    const SampledSlice slice = sampleSlice(dose, frame, {}, Filter::linear);
    for (const double radiusMm : {25.0, 32.0, 40.0}) {
        const auto lines = contourLines(slice, 60.0 - radiusMm);
        ASSERT_EQ(lines.size(), 1u);
        for (const glm::dvec2& point : lines[0]) {
            const double off = glm::distance(frame.worldFromPicture(point), centre) - radiusMm;
            EXPECT_LT(std::abs(off) / frame.mmPerPixel, 0.1) << radiusMm;
        }
    }
}

// A point is where the straight line between two pixels has the level; sides are found one by one, in double.
std::set<std::pair<double, double>> crossingsOf(const SampledSlice& slice, double level) {
    std::set<std::pair<double, double>> points;
    const glm::ivec2 size = slice.sizePx;
    const auto at = [&](int x, int y) { return double(slice.values[std::size_t(y * size.x + x)]); };
    const auto isWhole = [&](int x, int y) {
        if (x < 0 || y < 0 || x + 1 >= size.x || y + 1 >= size.y) return false;
        return !std::isnan(at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1));
    };
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            if (x + 1 < size.x && (isWhole(x, y) || isWhole(x, y - 1)) &&
                (at(x, y) >= level) != (at(x + 1, y) >= level))
                points.emplace(x + 0.5 + (level - at(x, y)) / (at(x + 1, y) - at(x, y)), y + 0.5);
            if (y + 1 < size.y && (isWhole(x, y) || isWhole(x - 1, y)) &&
                (at(x, y) >= level) != (at(x, y + 1) >= level))
                points.emplace(x + 0.5, y + 0.5 + (level - at(x, y)) / (at(x, y + 1) - at(x, y)));
        }
    }
    return points;
}

TEST(ContourLines, GoThroughEveryCrossingOnceAndStayInTheirSquare) {
    test::Random random(7);
    for (int round = 0; round < 40; ++round) {
        const double holes = round % 2 == 0 ? 0.0 : 0.05;
        const glm::ivec2 size(2 + int(random() % 40), 2 + int(random() % 30));
        const SampledSlice slice = sliceOf(size, [&](const glm::dvec2&) {
            return test::uniform(random, 0.0, 1.0) < holes ? double(kNone) : test::uniform(random, 0.0, 1.0);
        });
        const double level = test::uniform(random, 0.1, 0.9);
        const auto wanted = crossingsOf(slice, level);
        std::size_t points = 0;
        for (const ContourLine& line : contourLines(slice, level)) {
            const std::size_t count = line.size() - (isClosed(line) ? 1 : 0);
            points += count;
            for (std::size_t i = 0; i < line.size(); ++i) {
                const auto near = [&](const std::pair<double, double>& p) {
                    return std::abs(p.first - line[i].x) + std::abs(p.second - line[i].y) < 1e-9;
                };
                EXPECT_TRUE(std::ranges::any_of(wanted, near));
                if (i == 0) continue;
                const glm::dvec2 middle = 0.5 * (line[i - 1] + line[i]) - 0.5;
                const glm::dvec2 square = glm::floor(middle);
                for (const glm::dvec2& end : {line[i - 1] - 0.5, line[i] - 0.5}) {
                    EXPECT_TRUE(end.x >= square.x - 1e-9 && end.x <= square.x + 1.0 + 1e-9);
                    EXPECT_TRUE(end.y >= square.y - 1e-9 && end.y <= square.y + 1.0 + 1e-9);
                }
            }
        }
        EXPECT_EQ(points, wanted.size());
    }
}

// High in two opposite corners: the bilinear surface is 0.5 in the middle.
TEST(ContourLines, ASaddleIsJoinedByItsMiddle) {
    const SampledSlice slice{.sizePx = {2, 2}, .values = {1.0f, 0.0f, 0.0f, 1.0f}};
    const auto joined = contourLines(slice, 0.4);
    const auto apart = contourLines(slice, 0.6);
    ASSERT_EQ(joined.size(), 2u);
    ASSERT_EQ(apart.size(), 2u);
    // Around a low corner, the upper right, or around a high one, the upper left.
    const auto isAround = [](const std::vector<ContourLine>& lines, const glm::dvec2& corner) {
        return std::ranges::any_of(lines, [&](const ContourLine& line) {
            return std::ranges::all_of(line,
                                       [&](const glm::dvec2& p) { return glm::distance(p, corner) < 0.45; });
        });
    };
    EXPECT_TRUE(isAround(joined, {1.5, 0.5}));
    EXPECT_TRUE(isAround(joined, {0.5, 1.5}));
    EXPECT_TRUE(isAround(apart, {0.5, 0.5}));
    EXPECT_TRUE(isAround(apart, {1.5, 1.5}));
}

TEST(ContourLines, APlateauAtTheLevelIsInside) {
    const SampledSlice slice = sliceOf({7, 7}, [](const glm::dvec2& at) {
        return std::max(std::abs(at.x - 3.5), std::abs(at.y - 3.5)) < 1.6;
    });
    const auto at = contourLines(slice, 1.0);
    ASSERT_EQ(at.size(), 1u);
    EXPECT_TRUE(isClosed(at[0]));
    EXPECT_NEAR(areaOf(at[0]), 4.0, 1e-9) << "through the outer pixels of the plateau";
    const auto half = contourLines(slice, 0.5);
    ASSERT_EQ(half.size(), 1u);
    EXPECT_NEAR(areaOf(half[0]), 9.0 - 4 * 0.125, 1e-9);
    EXPECT_TRUE(contourLines(slice, 1.001).empty());
    EXPECT_TRUE(contourLines(slice, 0.0).empty()) << "all is at least 0";
}

TEST(ContourLines, OnePixelIsADiamondOrNothing) {
    SampledSlice slice{.sizePx = {3, 3}, .values = std::vector<float>(9, 0.0f)};
    slice.values[4] = 1.0f;
    const auto lines = contourLines(slice, 0.5);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].size(), 5u);
    EXPECT_NEAR(areaOf(lines[0]), 0.5, 1e-9);
    EXPECT_TRUE(contourLines(slice, 1.0).empty()) << "a line of one point";
    for (const glm::ivec2& size : {glm::ivec2(1, 1), glm::ivec2(5, 1), glm::ivec2(1, 5)})
        EXPECT_TRUE(
            contourLines(sliceOf(size, [](const glm::dvec2& at) { return at.x + at.y; }), 2.0).empty());
}

TEST(ContourLines, EndWhereThereAreNoValues) {
    const SampledSlice slice = sliceOf(
        {20, 10}, [](const glm::dvec2& at) { return at.x > 9.0 && at.x < 12.0 ? double(kNone) : at.y; });
    const auto lines = contourLines(slice, 5.0);
    ASSERT_EQ(lines.size(), 2u);
    for (const ContourLine& line : lines) {
        EXPECT_FALSE(isClosed(line));
        for (const glm::dvec2& point : line) EXPECT_NEAR(point.y, 5.0, 1e-9);
    }
    EXPECT_NEAR(lengthOf(lines[0]) + lengthOf(lines[1]), 8.0 + 7.0, 1e-9);
}

TEST(ContourLines, BadInputHasNone) {
    const SampledSlice slice = sliceOf({9, 9}, [](const glm::dvec2& at) { return at.x; });
    for (const double level : {double(kNone), std::numeric_limits<double>::infinity()})
        EXPECT_TRUE(contourLines(slice, level).empty());
    EXPECT_TRUE(contourLines(slice, 4.0, [] { return true; }).empty());
    EXPECT_TRUE(contourLines({.sizePx = {9, 9}, .values = {1.0f}}, 0.5).empty());
    EXPECT_TRUE(contourLines({}, 0.5).empty());
    const SampledSlice huge{.sizePx = {2, 2}, .values = {-3e38f, 3e38f, -3e38f, 3e38f}};
    for (const ContourLine& line : contourLines(huge, 1.0))
        for (const glm::dvec2& point : line) EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
}

}  // namespace
}  // namespace macula::slices
