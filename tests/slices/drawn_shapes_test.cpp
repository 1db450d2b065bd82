// Shapes that a hand draws, against closed forms and brute force: both axes of a lesion, Cobb angles, lines
// and outlines.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "slices/cut_voxels.h"
#include "slices/interpolated.h"
#include "slices/measurement.h"
#include "slices/outline.h"

namespace macula::slices {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr glm::dvec3 kUp{0.0, 0.0, 1.0};

// 41 x 41 x 4 voxels of 1 mm, at their indices; the value is x + 41 y + 2000 z.
Volume grid(VolumeOptions options = {}) {
    options.size = {41, 41, 4};
    options.unit = Unit::hounsfield;
    std::vector<std::uint16_t> voxels;
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 41; ++y)
            for (int x = 0; x < 41; ++x) voxels.push_back(std::uint16_t(x + 41 * y + 2000 * z));
    auto made = Volume::create(std::move(options), std::move(voxels));
    EXPECT_TRUE(made.ok());
    return std::move(made).value();
}

Outline rectangle(double left, double top, double right, double bottom, double z) {
    return {{{left, top, z}, {right, top, z}, {right, bottom, z}, {left, bottom, z}}};
}

// An ellipse as a polygon of many sides.
Outline roundOutline(const Ellipse& ellipse, int sides) {
    Outline outline;
    for (int i = 0; i < sides; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / sides;
        outline.pointsMm.push_back(ellipse.plane.centreMm +
                                   std::cos(turn) * ellipse.radiiMm.x * ellipse.plane.right +
                                   std::sin(turn) * ellipse.radiiMm.y * ellipse.plane.down);
    }
    return outline;
}

using Voxels = std::set<std::tuple<int, int, int>>;

Voxels voxelsOf(const Outline& outline, const glm::dvec3& normal, const Volume& volume) {
    Voxels voxels;
    forEachCutVoxel(outline, normal, volume, [&](const glm::ivec3& v) {
        EXPECT_TRUE(voxels.emplace(v.x, v.y, v.z).second) << "twice";
    });
    return voxels;
}

TEST(Bidirectional, TheLongerLineIsTheLongAxis) {
    const Bidirectional lesion{.firstMm = {{{0, 0, 0}, {30, 40, 0}}},
                               .secondMm = {{{12, 21, 0}, {20, 15, 0}}}};
    EXPECT_DOUBLE_EQ(axesOf(lesion).longMm, 50.0);
    EXPECT_DOUBLE_EQ(axesOf(lesion).shortMm, 10.0);
    const Bidirectional swapped{.firstMm = lesion.secondMm, .secondMm = lesion.firstMm};
    EXPECT_DOUBLE_EQ(axesOf(swapped).longMm, 50.0);
    EXPECT_DOUBLE_EQ(axesOf(swapped).shortMm, 10.0);
    EXPECT_EQ(axesOf({}).longMm, 0.0);
    const Bidirectional broken{.firstMm = {{{0, 0, 0}, {kNaN, 0, 0}}}, .secondMm = lesion.secondMm};
    EXPECT_TRUE(std::isnan(axesOf(broken).longMm));
    EXPECT_TRUE(std::isnan(axesOf(broken).shortMm));

    const Volume volume = grid();
    EXPECT_EQ(textOf({.shape = lesion}, volume), "50.0 × 10.0 mm");
    EXPECT_EQ(textOf({.shape = swapped}, volume), "50.0 × 10.0 mm");
    EXPECT_EQ(textOf({.shape = broken}, volume), "–");
    EXPECT_EQ(textOf({.shape = lesion}, grid({.provenance = {.isCalibrated = false}})), "≈ 50.0 × 10.0 mm");
}

TEST(CobbAngle, IsTheSmallerOneBetweenTheLines) {
    const auto angle = [](const glm::dvec3& a, const glm::dvec3& b) {
        return angleDeg(
            CobbAngle{{glm::dvec3(1, 2, 3), glm::dvec3(1, 2, 3) + a, {9, 9, 9}, glm::dvec3(9) + b}});
    };
    EXPECT_NEAR(angle({1, 0, 0}, {1, 1, 0}), 45.0, 1e-12);
    EXPECT_NEAR(angle({1, 0, 0}, {-1, -1, 0}), 45.0, 1e-12) << "whichever way it was drawn";
    EXPECT_NEAR(angle({-4, 0, 0}, {0, 3, 0}), 90.0, 1e-12);
    EXPECT_NEAR(angle({1, 0, 0}, {-7, 0, 0}), 0.0, 1e-12);
    EXPECT_TRUE(std::isnan(angle({0, 0, 0}, {1, 0, 0})));
    EXPECT_TRUE(std::isnan(angle({kInfinity, 0, 0}, {1, 0, 0})));
    EXPECT_EQ(textOf({.shape = CobbAngle{{glm::dvec3(0, 0, 0), {5, 0, 0}, {0, 9, 0}, {5, 14, 0}}}}, grid()),
              "45.0°");
}

TEST(OpenLine, IsAsLongAsItsPieces) {
    EXPECT_DOUBLE_EQ(lengthMm(OpenLine{{{0, 0, 0}, {3, 4, 0}, {3, 4, 12}}}), 17.0);
    EXPECT_EQ(lengthMm(OpenLine{{{1, 1, 1}, {1, 1, 1}}}), 0.0);
    EXPECT_TRUE(std::isnan(lengthMm(OpenLine{})));
    EXPECT_TRUE(std::isnan(lengthMm(OpenLine{{{1, 1, 1}}})));
    EXPECT_TRUE(std::isnan(lengthMm(OpenLine{{{1, 1, 1}, {kNaN, 1, 1}}})));
    EXPECT_TRUE(std::isnan(lengthMm(OpenLine{{{-1e308, 0, 0}, {1e308, 0, 0}, {-1e308, 0, 0}}})));
    EXPECT_EQ(textOf({.shape = OpenLine{{{0, 0, 0}, {3, 4, 0}, {3, 4, 12}}}}, grid()), "17.0 mm");
}

TEST(Arrow, SaysNothingByItself) {
    const Measurement arrow{.label = "here", .shape = Arrow{{1, 2, 0}, {9, 9, 0}}};
    EXPECT_EQ(textOf(arrow, grid()), "");
    EXPECT_FALSE(hasSize(arrow));
    EXPECT_EQ(pointsOf(arrow), (std::vector<glm::dvec3>{{1, 2, 0}, {9, 9, 0}}));
}

TEST(Outline, AreaIsThatOfThePolygonInAnyPlane) {
    EXPECT_DOUBLE_EQ(areaMm2(rectangle(1, 2, 5, 12, 3)), 40.0);
    const Outline concave{{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {5, 2, 0}, {0, 10, 0}}};
    EXPECT_NEAR(areaMm2(concave), 100.0 - 40.0, 1e-9);
    // In a plane with normal (1, 1, 1), far from the origin.
    const glm::dvec3 right = glm::normalize(glm::dvec3(1, -1, 0));
    const glm::dvec3 down = glm::cross(glm::normalize(glm::dvec3(1, 1, 1)), right);
    const Ellipse ellipse{.plane = {{5000, -3000, 900}, right, down}, .radiiMm = {8, 3}};
    EXPECT_NEAR(areaMm2(roundOutline(ellipse, 2000)), areaMm2(ellipse), 1e-5 * areaMm2(ellipse));

    EXPECT_TRUE(std::isnan(areaMm2(Outline{})));
    EXPECT_TRUE(std::isnan(areaMm2(Outline{{{0, 0, 0}, {1, 0, 0}}})));
    EXPECT_TRUE(std::isnan(areaMm2(Outline{{{0, 0, 0}, {1, 0, 0}, {kNaN, 1, 0}}})));
    EXPECT_TRUE(std::isnan(areaMm2(Outline{{{0, 0, 0}, {1, 0, 0}, {0, kInfinity, 0}}})));
    EXPECT_TRUE(std::isnan(areaMm2(Outline{{{0, 0, 0}, {1, 0, 0}, {0, 1e200, 0}}})));
    EXPECT_FALSE(areaMm2(Outline{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}) > 0.0) << "one point";
    EXPECT_FALSE(areaMm2(Outline{{{0, 0, 0}, {5, 0, 0}, {9, 0, 0}}}) > 0.0) << "a line";
    const Outline crossing{{{0, 0, 0}, {10, 0, 0}, {0, 5, 0}, {10, 9, 0}}};
    EXPECT_TRUE(std::isnan(areaMm2(crossing))) << "it has no inside";
    EXPECT_FALSE(valuesIn(crossing, kUp, grid()));
    EXPECT_EQ(textOf({.shape = crossing}, grid()), "–, –");
}

// In a plane of voxels those whose centre lies in or on it count: here all from 10 to 14 and 20 to 22.
TEST(Outline, HasTheVoxelsWhoseCentreItHolds) {
    const Volume volume = grid();
    const auto values = valuesIn(rectangle(10, 20, 14, 22, 1), kUp, volume);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->voxels, 15u);
    EXPECT_DOUBLE_EQ(values->areaMm2, 8.0);
    EXPECT_DOUBLE_EQ(values->mean, 12 + 41 * 21 + 2000);
    EXPECT_DOUBLE_EQ(values->low, 10 + 41 * 20 + 2000);
    EXPECT_DOUBLE_EQ(values->high, 14 + 41 * 22 + 2000);
    // Variance of a sample: 15/14 of (2 for x, 41² times 2/3 for y).
    EXPECT_NEAR(values->deviation, std::sqrt((2.0 + 41.0 * 41.0 * 2.0 / 3.0) * 15.0 / 14.0), 1e-9);
    EXPECT_EQ(textOf({.shape = rectangle(10, 20, 14, 22, 1)}, volume),
              "2873 ± 35 HU, min 2830, max 2916, 8.00 mm²");

    // Backwards, and from another first point, it is the same.
    Outline backwards = rectangle(10, 20, 14, 22, 1);
    std::ranges::reverse(backwards.pointsMm);
    EXPECT_EQ(valuesIn(backwards, kUp, volume)->voxels, 15u);
    EXPECT_EQ(valuesIn(backwards, -kUp, volume)->mean, values->mean);

    // A notch holds none of its voxels: only x of 10, 11, 13, 14 in the upper two rows.
    const Outline notched{{{10, 20, 1},
                           {11.5, 20, 1},
                           {11.5, 21.5, 1},
                           {12.5, 21.5, 1},
                           {12.5, 20, 1},
                           {14, 20, 1},
                           {14, 22, 1},
                           {10, 22, 1}}};
    EXPECT_EQ(valuesIn(notched, kUp, volume)->voxels, 13u);

    // Too small for a centre: that of the voxel around it.
    const auto small = valuesIn(rectangle(10.2, 20.2, 10.4, 20.4, 1), kUp, volume);
    ASSERT_TRUE(small);
    EXPECT_EQ(small->voxels, 1u);
    EXPECT_DOUBLE_EQ(small->mean, 10 + 41 * 20 + 2000);
    EXPECT_FALSE(valuesIn(rectangle(100, 100, 110, 110, 1), kUp, volume)) << "beside the volume";
    EXPECT_FALSE(valuesIn(rectangle(10, 20, 14, 22, 1), {0, 0, 0}, volume)) << "no plane";
    EXPECT_FALSE(valuesIn(rectangle(10, 20, 14, 22, 1), {kNaN, 0, 1}, volume));
}

// A polygon of many sides has the voxels of the ellipse that it follows, in turned planes too, except those
// so near to its rim that rounding decides.
TEST(Outline, AgreesWithTheEllipseThatItFollows) {
    const Volume volume = grid();
    for (const glm::dvec3& towards :
         {glm::dvec3(0, 0, 1), glm::dvec3(0.2, -0.1, 1), glm::dvec3(1, 0.3, 0.4)}) {
        const glm::dvec3 normal = glm::normalize(towards);
        const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0.1), normal));
        const Ellipse ellipse{.plane = {{19.3, 21.7, 1.4}, right, glm::cross(normal, right)},
                              .radiiMm = {11.3, 7.9}};
        const Voxels drawn = voxelsOf(roundOutline(ellipse, 900), normal, volume);
        Voxels exact;
        forEachCutVoxel(ellipse, volume, [&](const glm::ivec3& v) { exact.emplace(v.x, v.y, v.z); });
        std::size_t apart = 0;
        for (const auto& each : exact) apart += drawn.contains(each) ? 0 : 1;
        for (const auto& each : drawn) apart += exact.contains(each) ? 0 : 1;
        EXPECT_GT(exact.size(), 50u);
        EXPECT_LE(apart, exact.size() / 100) << towards.x;
    }
}

TEST(Outline, PaddingAndInterpolatedSlicesAreAsInAnEllipse) {
    const Volume volume = grid({.provenance = {.interpolatedSlices = {{2, 2}}}});
    const Measurement there{.shape = rectangle(10, 20, 14, 22, 2)};
    const auto values = valuesIn(there, volume);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->interpolated, 15u);
    EXPECT_DOUBLE_EQ(interpolatedShare(there, volume), 1.0);
    EXPECT_DOUBLE_EQ(interpolatedShare({.shape = rectangle(10, 20, 14, 22, 1)}, volume), 0.0);
    EXPECT_DOUBLE_EQ(interpolatedShare({.shape = Outline{}}, volume), 0.0);
    EXPECT_EQ(sliceOf(there, volume), 2);
    EXPECT_FALSE(sliceOf({.shape = OpenLine{{{1, 1, 0}, {2, 2, 3}}}}, volume));
}

TEST(LargestLoop, DropsWhereAHandOvershot) {
    // A square whose last side runs past its beginning.
    const std::vector<glm::dvec2> drawn{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0.5, -3}, {1, -3}};
    ASSERT_TRUE(crossesItself(drawn));
    const auto loop = largestLoop(drawn);
    EXPECT_FALSE(crossesItself(loop));
    EXPECT_GT(std::abs(signedArea(loop)), 90.0);
    const std::vector<glm::dvec2> eight{{0, 0}, {4, 4}, {4, 0}, {0, 4}};
    EXPECT_NEAR(std::abs(signedArea(largestLoop(eight))), 4.0, 1e-12) << "half of it";
    const std::vector<glm::dvec2> simple{{0, 0}, {4, 0}, {4, 4}};
    EXPECT_EQ(largestLoop(simple), simple);
    EXPECT_TRUE(largestLoop({}).empty());
}

TEST(Simplified, LeavesOutOnlyWhatLiesOnTheLine) {
    std::vector<glm::dvec3> line;
    for (int i = 0; i <= 100; ++i) line.emplace_back(i, 0, 0);
    for (int i = 1; i <= 100; ++i) line.emplace_back(100, i, 0);
    EXPECT_EQ(simplified(line, 0.01), (std::vector<glm::dvec3>{{0, 0, 0}, {100, 0, 0}, {100, 100, 0}}));
    EXPECT_EQ(simplified(std::vector<glm::dvec3>{{1, 1, 1}}, 0.5).size(), 1u);
    EXPECT_TRUE(simplified({}, 0.5).empty());
    // Of a circle no left out point is farther than the tolerance, so the length is nearly the same.
    std::vector<glm::dvec3> circle;
    for (int i = 0; i <= 3600; ++i)
        circle.emplace_back(50.0 * std::cos(i * std::numbers::pi / 1800),
                            50.0 * std::sin(i * std::numbers::pi / 1800), 0.0);
    const auto fewer = simplified(circle, 0.05);
    EXPECT_LT(fewer.size(), 150u);
    EXPECT_NEAR(lengthMm(OpenLine{fewer}), 100.0 * std::numbers::pi, 0.5);
}

TEST(InsideOf, ASquareHoldsWhatIsInAndOnIt) {
    const InsideOf square(std::vector<glm::dvec2>{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    EXPECT_TRUE(square({5, 5}));
    EXPECT_TRUE(square({0, 0}));
    EXPECT_TRUE(square({10, 3}));
    EXPECT_FALSE(square({10.001, 3}));
    EXPECT_FALSE(square({5, -0.001}));
    EXPECT_FALSE(square({kNaN, 5}));
    EXPECT_FALSE(square({5, kNaN}));
    EXPECT_FALSE(InsideOf({})({0, 0}));
    EXPECT_FALSE(InsideOf(std::vector<glm::dvec2>{{1, 1}, {1, 1}, {1, 1}})({2, 1}));
}

TEST(DrawnShapes, LieInTheSliceThatAllOfThemLiesIn) {
    const SlicePlane plane{.centreMm = {20, 20, 1}};
    const Bidirectional lesion{.firstMm = {{{10, 10, 1}, {30, 10, 1}}},
                               .secondMm = {{{20, 5, 1}, {20, 15, 1}}}};
    EXPECT_TRUE(liesIn({.shape = lesion}, plane, 0.4));
    Bidirectional leaning = lesion;
    leaning.secondMm[1].z = 2.0;
    EXPECT_FALSE(liesIn({.shape = leaning}, plane, 0.4));
    EXPECT_TRUE(liesIn({.shape = rectangle(1, 1, 2, 2, 1.2)}, plane, 0.4));
    EXPECT_FALSE(liesIn({.shape = rectangle(1, 1, 2, 2, 1.5)}, plane, 0.4));
    EXPECT_FALSE(liesIn({.shape = lesion, .normal = {1, 0, 0}}, plane, 0.4)) << "drawn on another plane";
    EXPECT_FALSE(liesIn({.shape = OpenLine{{{1, 1, 1}, {1, 1, kNaN}}}}, plane, 0.4));
}

}  // namespace
}  // namespace macula::slices
