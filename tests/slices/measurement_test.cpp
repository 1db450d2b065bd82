// Measurements against closed forms, the phantom and brute force.
#include "slices/measurement.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "base/phantom.h"
#include "slices/cut_voxels.h"

namespace macula::slices {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kOrientations{Orientation::axial, Orientation::coronal, Orientation::sagittal};

using Stored = std::function<int(const glm::ivec3&)>;

Volume volumeOf(VolumeOptions options, const Stored& stored) {
    std::vector<std::uint16_t> voxels;
    glm::ivec3 v;
    for (v.z = 0; v.z < options.size.z; ++v.z)
        for (v.y = 0; v.y < options.size.y; ++v.y)
            for (v.x = 0; v.x < options.size.x; ++v.x) voxels.push_back(std::uint16_t(stored(v)));
    auto made = Volume::create(std::move(options), std::move(voxels));
    EXPECT_TRUE(made.ok());
    return std::move(made).value();
}

// 41 x 41 x 4 voxels of 1 mm, at their indices.
Volume grid(const Stored& stored) {
    return volumeOf({.size = {41, 41, 4}, .unit = Unit::hounsfield}, stored);
}

Ellipse ellipseAt(const glm::dvec3& centreMm, const glm::dvec2& radiiMm) {
    return {.plane = {.centreMm = centreMm}, .radiiMm = radiiMm};
}

SlicePlane turned(const SlicePlane& plane, double angleDeg, const glm::dvec3& axis) {
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), glm::radians(angleDeg), glm::normalize(axis)));
    return {plane.centreMm, turn * plane.right, turn * plane.down};
}

TEST(Measurement, LengthIsThatOfTheLine) {
    EXPECT_DOUBLE_EQ(lengthMm(Distance{{glm::dvec3(1, 2, 3), glm::dvec3(4, -2, 15)}}), 13.0);
    EXPECT_EQ(lengthMm(Distance{}), 0.0);
    EXPECT_DOUBLE_EQ(lengthMm(Distance{{glm::dvec3(0.0), glm::dvec3(3e300, 4e300, 0)}}), 5e300);
    EXPECT_DOUBLE_EQ(lengthMm(Distance{{glm::dvec3(0.0), glm::dvec3(3e-300, 4e-300, 0)}}), 5e-300);
    EXPECT_TRUE(std::isnan(lengthMm(Distance{{glm::dvec3(0.0), glm::dvec3(kNaN, 0, 0)}})));
    EXPECT_TRUE(std::isnan(lengthMm(Distance{{glm::dvec3(0.0), glm::dvec3(kInfinity, 0, 0)}})));
}

TEST(Measurement, AngleIsThatAtTheSecondPoint) {
    const auto angle = [](const glm::dvec3& a, const glm::dvec3& vertex, const glm::dvec3& b) {
        return angleDeg(Angle{{a, vertex, b}});
    };
    EXPECT_DOUBLE_EQ(angle({5, 1, 1}, {1, 1, 1}, {1, 9, 1}), 90.0);
    EXPECT_DOUBLE_EQ(angle({5, 1, 1}, {1, 1, 1}, {9, 9, 1}), 45.0);
    EXPECT_NEAR(angle({1, 1, 0}, {0, 0, 0}, {0, 1, 1}), 60.0, 1e-12);
    EXPECT_NEAR(angle({2, 0, 0}, {0, 0, 0}, {-1, std::sqrt(3.0), 0}), 120.0, 1e-12);
    EXPECT_DOUBLE_EQ(angle({2, 2, 2}, {1, 1, 1}, {-3, -3, -3}), 180.0);
    EXPECT_EQ(angle({2, 0, 0}, {0, 0, 0}, {7, 0, 0}), 0.0);
    // Where an arc cosine has no digits left.
    EXPECT_NEAR(angle({1, 0, 0}, {0, 0, 0}, {1, 1e-9, 0}), glm::degrees(1e-9), 1e-15);
    EXPECT_NEAR(angle({1e200, 0, 0}, {0, 0, 0}, {0, 1e-200, 0}), 90.0, 1e-12);

    EXPECT_TRUE(std::isnan(angle({1, 1, 1}, {1, 1, 1}, {2, 1, 1})));
    EXPECT_TRUE(std::isnan(angle({2, 1, 1}, {1, 1, 1}, {1, 1, 1})));
    EXPECT_TRUE(std::isnan(angle({kNaN, 1, 1}, {1, 1, 1}, {2, 1, 1})));
}

// A person who points at the corners of the marker, on pixels of a twentieth of a voxel.
TEST(Measurement, DistancesOfThePhantomAreRightToATenthOfAVoxel) {
    constexpr double kVoxelMm = 1.2;
    const double half = phantom::markerHalfEdgeMm();
    for (const Orientation orientation : kOrientations) {
        const SlicePlane plane = planeOf(orientation, phantom::markerCentreMm());
        const SliceFrame frame{.plane = plane, .mmPerPixel = kVoxelMm / 20.0, .sizePx = {601, 601}};
        const auto corner = [&](double right, double down) {
            return plane.centreMm + half * (right * plane.right + down * plane.down);
        };
        const auto clicked = [&](const glm::dvec3& mm) {
            return frame.worldFromPicture(glm::floor(frame.pictureFromWorld(mm)) + 0.5);
        };
        // The marker is where it is said to be.
        for (const double side : {-1.0, 1.0}) {
            EXPECT_EQ(phantom::valueHu(corner(0.999 * side, 0.0)), 1000);
            EXPECT_NE(phantom::valueHu(corner(1.001 * side, 0.0)), 1000);
        }
        const glm::dvec3 a = clicked(corner(-1, -1));
        const glm::dvec3 b = clicked(corner(1, -1));
        const glm::dvec3 c = clicked(corner(1, 1));
        EXPECT_NEAR(lengthMm(Distance{{a, b}}), 2.0 * half, 0.1 * kVoxelMm);
        EXPECT_NEAR(lengthMm(Distance{{b, c}}), 2.0 * half, 0.1 * kVoxelMm);
        EXPECT_NEAR(lengthMm(Distance{{a, c}}), std::sqrt(8.0) * half, 0.1 * kVoxelMm);
        EXPECT_NEAR(angleDeg(Angle{{a, b, c}}), 90.0, 0.5);
        EXPECT_NEAR(angleDeg(Angle{{b, a, c}}), 45.0, 0.5);
    }
}

TEST(ValuesIn, TheMarkerOfThePhantomAreItsOwn) {
    const Volume volume = phantom::make({.size = {100, 80, 60}, .spacingMm = {3.0, 3.0, 4.0}});
    for (const Orientation orientation : kOrientations) {
        for (const double turn : {0.0, 33.0}) {
            // Half a voxel around it is marker too.
            Ellipse ellipse = ellipseAt({}, glm::dvec2(5.5));
            ellipse.plane = turned(planeOf(orientation, phantom::markerCentreMm()), turn, {1, 2, 3});
            const auto values = valuesIn(ellipse, volume);
            ASSERT_TRUE(values);
            EXPECT_GE(values->voxels, 4u);
            EXPECT_DOUBLE_EQ(values->mean, 1000.0);
            EXPECT_EQ(values->deviation, 0.0);
            EXPECT_EQ(values->low, 1000.0);
            EXPECT_EQ(values->high, 1000.0);
            EXPECT_DOUBLE_EQ(values->areaMm2, std::numbers::pi * 5.5 * 5.5);
            // On the other side of the patient there is none: nothing is mirrored.
            ellipse.plane.centreMm.x *= -1.0;
            const auto mirrored = valuesIn(ellipse, volume);
            ASSERT_TRUE(mirrored);
            EXPECT_LT(mirrored->high, 1000.0);
        }
    }
}

// Gauss's circle problem has these counts: 81 points with integer coordinates within 5, 317 within 10.
TEST(ValuesIn, APlaneOfVoxelsAreOverThoseWhoseCentreLiesWithin) {
    const Volume volume = grid([](const glm::ivec3& v) { return 1000 + v.x + 40 * v.y + 10000 * v.z; });
    const auto small = valuesIn(ellipseAt({20, 20, 2}, glm::dvec2(5.001)), volume);
    const auto large = valuesIn(ellipseAt({20, 20, 2}, glm::dvec2(10.001)), volume);
    ASSERT_TRUE(small && large);
    EXPECT_EQ(small->voxels, 81u);
    EXPECT_EQ(large->voxels, 317u);
    EXPECT_EQ(valuesIn(ellipseAt({20, 20, 2}, glm::dvec2(10.0)), volume)->voxels, 317u) << "on it, too";
    // What is linear has the mean of the middle.
    EXPECT_NEAR(small->mean, 21820.0, 1e-9);
    EXPECT_EQ(small->low, 21820.0 - 5 * 40);
    EXPECT_EQ(small->high, 21820.0 + 5 * 40);

    // The sums in two passes, of an ellipse that lies anywhere and is turned in its plane.
    Ellipse ellipse = ellipseAt({18.3, 22.1, 1.0}, {9.2, 4.7});
    ellipse.plane = turned(ellipse.plane, 31.0, {0, 0, 1});
    std::vector<double> within;
    for (int j = 0; j < 41; ++j) {
        for (int i = 0; i < 41; ++i) {
            const glm::dvec3 from = glm::dvec3(i, j, 1) - ellipse.plane.centreMm;
            const double u = glm::dot(from, ellipse.plane.right) / 9.2;
            const double v = glm::dot(from, ellipse.plane.down) / 4.7;
            if (u * u + v * v <= 1.0) within.push_back(volume.value(i, j, 1));
        }
    }
    double mean = 0.0;
    for (const double value : within) mean += value / double(within.size());
    double squares = 0.0;
    for (const double value : within) squares += (value - mean) * (value - mean);
    const auto values = valuesIn(ellipse, volume);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->voxels, within.size());
    EXPECT_NEAR(values->mean, mean, 1e-8);
    EXPECT_NEAR(values->deviation, std::sqrt(squares / double(within.size() - 1)), 1e-8);
}

TEST(ValuesIn, HalfWayBetweenTwoSlicesAreOfTheLaterOneWhateverTheRounding) {
    for (int turn = 0; turn < 50; ++turn) {
        const glm::dmat4 worldFromVoxel =
            glm::rotate(glm::dmat4(1.0), 0.7 * turn, glm::normalize(glm::dvec3(1, turn, 2))) *
            glm::scale(glm::dmat4(1.0), glm::dvec3(0.7, 0.9, 1.1));
        const Volume volume =
            volumeOf({.size = {20, 20, 4}, .worldFromVoxel = worldFromVoxel, .unit = Unit::hounsfield},
                     [](const glm::ivec3& v) { return 100 * v.z; });
        Ellipse ellipse = ellipseAt(transformPoint(worldFromVoxel, {9.6, 9.7, 1.5}), {4.0, 3.0});
        ellipse.plane.right = glm::normalize(glm::dvec3(worldFromVoxel[0]));
        ellipse.plane.down = glm::normalize(glm::dvec3(worldFromVoxel[1]));
        const auto values = valuesIn(ellipse, volume);
        ASSERT_TRUE(values);
        EXPECT_EQ(values->low, 200.0) << turn;
        EXPECT_EQ(values->high, 200.0) << turn;
        // Each voxel once: as many as in a plane of voxels.
        ellipse.plane.centreMm = transformPoint(worldFromVoxel, {9.6, 9.7, 2.0});
        EXPECT_EQ(values->voxels, valuesIn(ellipse, volume)->voxels) << turn;
    }
}

using Index = std::tuple<int, int, int>;

// What lies nearest to each of many points of the plane: their number and the sum of their (u, v), in mm.
struct Sampled {
    int samples = 0;
    glm::dvec2 sum{0.0};
};
std::map<Index, Sampled> sampledCuts(const SlicePlane& plane, const Volume& volume, double reachMm,
                                     double stepMm) {
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    std::map<Index, Sampled> cuts;
    const int steps = int(reachMm / stepMm);
    for (int y = -steps; y <= steps; ++y) {
        for (int x = -steps; x <= steps; ++x) {
            const glm::dvec2 uv = stepMm * glm::dvec2(x, y);
            const glm::dvec3 mm = plane.centreMm + uv.x * plane.right + uv.y * plane.down;
            const glm::ivec3 v(glm::floor(transformPoint(voxelFromWorld, mm) + 0.5));
            if (glm::any(glm::lessThan(v, glm::ivec3(0))) ||
                glm::any(glm::greaterThanEqual(v, volume.size())))
                continue;
            Sampled& cut = cuts[{v.x, v.y, v.z}];
            ++cut.samples;
            cut.sum += uv;
        }
    }
    return cuts;
}

TEST(ForEachCutVoxel, VisitsThoseThatBruteForceFinds) {
    // Oblique, anisotropic and sheared, as of a tilted gantry.
    const glm::dmat4 worldFromVoxel =
        affine({0.9, 0.1, 0.05}, {-0.1, 1.1, 0.2}, {0.3, 0.6, 2.5}, {-30, 12, 7});
    const Volume volume = volumeOf({.size = {12, 11, 8}, .worldFromVoxel = worldFromVoxel},
                                   [](const glm::ivec3&) { return 1; });
    constexpr double kStepMm = 0.05;
    const glm::dvec2 radiiMm(4.1, 2.3);
    std::size_t within = 0;
    std::size_t without = 0;
    for (int plane = 0; plane < 8; ++plane) {
        Ellipse ellipse = ellipseAt(transformPoint(worldFromVoxel, {5.2 + 0.13 * plane, 4.7, 3.6}), radiiMm);
        ellipse.plane = turned(planeOf(kOrientations.at(std::size_t(plane) % 3), ellipse.plane.centreMm),
                               17.0 * plane, {1.0, plane - 3.5, 0.6});
        std::set<Index> visited;
        forEachCutVoxel(ellipse, volume, [&](const glm::ivec3& v) {
            EXPECT_TRUE(visited.insert({v.x, v.y, v.z}).second) << "once each";
        });
        const auto cuts = sampledCuts(ellipse.plane, volume, 9.0, kStepMm);
        for (const auto& [voxel, cut] : cuts) {
            const glm::dvec2 middle = cut.sum / double(cut.samples);
            const double radii = glm::length(middle / radiiMm);
            // The middle of a sliver is not known that well.
            const double doubtMm = cut.samples > 150 ? 3.0 * kStepMm : 1.0;
            if (std::abs(radii - 1.0) * radiiMm.y <= doubtMm) continue;
            ++(radii < 1.0 ? within : without);
            EXPECT_EQ(visited.contains(voxel), radii < 1.0)
                << plane << ": " << std::get<0>(voxel) << " " << std::get<1>(voxel) << " "
                << std::get<2>(voxel);
        }
        // None that the plane passes by.
        const glm::dmat4 voxelFromWorld = glm::inverse(worldFromVoxel);
        const glm::dvec3 normal = glm::cross(transformVector(voxelFromWorld, ellipse.plane.right),
                                             transformVector(voxelFromWorld, ellipse.plane.down));
        const glm::dvec3 centre = transformPoint(voxelFromWorld, ellipse.plane.centreMm);
        for (const auto& [i, j, k] : visited) {
            const double beside = std::abs(glm::dot(normal, glm::dvec3(i, j, k) - centre));
            EXPECT_LE(beside, 0.50001 * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z)));
        }
    }
    // Most are not in doubt.
    EXPECT_GT(within, 120u);
    EXPECT_GT(without, 900u);
}

TEST(ValuesIn, ASmallEllipseIsTheVoxelItLiesIn) {
    const Volume volume = grid([](const glm::ivec3& v) { return v.x + 100 * v.y; });
    const auto values = valuesIn(ellipseAt({7.4, 12.6, 1.0}, glm::dvec2(0.01)), volume);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->voxels, 1u);
    EXPECT_EQ(values->mean, 1307.0);
    EXPECT_EQ(values->low, 1307.0);
    EXPECT_EQ(values->high, 1307.0);
    EXPECT_TRUE(std::isnan(values->deviation)) << "of one value there is none";
    // Up to half a voxel outside of the volume, and no farther.
    EXPECT_TRUE(valuesIn(ellipseAt({-0.4, 12, 1}, glm::dvec2(0.01)), volume));
    EXPECT_FALSE(valuesIn(ellipseAt({-0.6, 12, 1}, glm::dvec2(0.01)), volume));
    EXPECT_TRUE(valuesIn(ellipseAt({7, 12, 3.4}, glm::dvec2(2.0)), volume));
    EXPECT_FALSE(valuesIn(ellipseAt({7, 12, 3.6}, glm::dvec2(2.0)), volume));
    // What reaches into it counts where it does: a quarter of the points within 5 with their axes.
    EXPECT_EQ(valuesIn(ellipseAt({0, 0, 1}, glm::dvec2(5.001)), volume)->voxels, 26u);
}

TEST(ValuesIn, PaddingIsLeftOut) {
    VolumeOptions options{.size = {41, 41, 4}, .unit = Unit::hounsfield, .padding = StoredRange{0, 9}};
    const Ellipse ellipse = ellipseAt({20, 20, 2}, glm::dvec2(5.001));
    const Volume half = volumeOf(options, [](const glm::ivec3& v) { return v.x < 20 ? 5 : 700; });
    const auto values = valuesIn(ellipse, half);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->voxels, 46u) << "half of the 70 beside the middle, and the 11 of the middle";
    EXPECT_EQ(values->low, 700.0);
    EXPECT_FALSE(valuesIn(ellipse, volumeOf(options, [](const glm::ivec3&) { return 3; })));

    std::vector<float> voxels(std::size_t(41) * 41 * 4, std::numeric_limits<float>::quiet_NaN());
    voxels[(2 * 41 + 20) * 41 + 21] = 2.5f;
    voxels[(2 * 41 + 20) * 41 + 22] = -7.0f;
    const auto made = Volume::createFloat({.size = {41, 41, 4}, .provenance = {}, .floatPadding = -7.0f},
                                          std::move(voxels));
    ASSERT_TRUE(made.ok());
    const auto one = valuesIn(ellipse, *made);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->voxels, 1u);
    EXPECT_EQ(one->mean, 2.5);
}

TEST(ValuesIn, AbsurdEllipsesAreAllOfThePlaneOrNothing) {
    const Volume volume = grid([](const glm::ivec3& v) { return v.x; });
    for (const double radius : {100.0, 1e6, 1e150, 1e300}) {
        const auto values = valuesIn(ellipseAt({20, 20, 2}, glm::dvec2(radius)), volume);
        ASSERT_TRUE(values) << radius;
        EXPECT_EQ(values->voxels, 41u * 41u) << radius;
        EXPECT_NEAR(values->mean, 20.0, 1e-9) << radius;
    }
    const auto thin = valuesIn(ellipseAt({20, 20, 2}, {1e300, 1e-6}), volume);
    ASSERT_TRUE(thin);
    EXPECT_EQ(thin->voxels, 41u) << "the row that it lies on";
    EXPECT_TRUE(valuesIn(ellipseAt({20, 20, 2}, {1e300, 1e-320}), volume));
    // A plane that no axis of the volume lies in.
    Ellipse oblique = ellipseAt({20, 20, 1.5}, glm::dvec2(1e9));
    oblique.plane = turned(oblique.plane, 54.0, {1, -1, 0.3});
    EXPECT_GT(valuesIn(oblique, volume)->voxels, 41u);

    for (const double radius : {0.0, -0.0, -3.0, kNaN, kInfinity, -kInfinity}) {
        EXPECT_FALSE(valuesIn(ellipseAt({20, 20, 2}, {radius, 5.0}), volume)) << radius;
        EXPECT_FALSE(valuesIn(ellipseAt({20, 20, 2}, {5.0, radius}), volume)) << radius;
    }
    for (const double x : {kNaN, kInfinity, 1e300, -1e12}) {
        EXPECT_FALSE(valuesIn(ellipseAt({x, 20, 2}, glm::dvec2(5.0)), volume)) << x;
        EXPECT_FALSE(valuesIn(ellipseAt({20, 20, x}, glm::dvec2(1e300)), volume)) << x;
    }
    for (const glm::dvec3& right : {glm::dvec3(0.0), glm::dvec3(0, 1, 0), glm::dvec3(kNaN, 0, 0)}) {
        Ellipse flat = ellipseAt({20, 20, 2}, glm::dvec2(5.0));
        flat.plane.right = right;  // no plane with `down`
        EXPECT_FALSE(valuesIn(flat, volume));
    }
}

TEST(ValuesIn, ADeviationThatIsSmallBesideTheMeanKeepsItsDigits) {
    VolumeOptions options{.size = {41, 41, 4}, .unitsFromStored = {.slope = 1.0, .intercept = 1e9}};
    const Volume volume = volumeOf(options, [](const glm::ivec3& v) { return v.x % 2; });
    const auto values = valuesIn(ellipseAt({20, 20, 2}, glm::dvec2(1e3)), volume);
    ASSERT_TRUE(values);
    const double n = 41.0 * 41.0;
    const double odd = 41.0 * 20.0;
    EXPECT_NEAR(values->mean, 1e9 + odd / n, 1e-5);
    EXPECT_NEAR(values->deviation, std::sqrt(odd * (n - odd) / (n * (n - 1.0))), 1e-6);
}

TEST(LiesIn, IsAboutAllPointsAndTheNormal) {
    const SlicePlane axial = planeOf(Orientation::axial, {10, 20, 30});
    Measurement distance{.shape = Distance{{glm::dvec3(0, 0, 30.4), glm::dvec3(50, 0, 29.7)}}};
    EXPECT_TRUE(liesIn(distance, axial, 0.5));
    EXPECT_FALSE(liesIn(distance, axial, 0.35)) << "one end is too far";
    EXPECT_TRUE(liesIn({.shape = Distance{{glm::dvec3(0, 0, 30), glm::dvec3(9, 9, 30)}}}, axial, 0.0));
    distance.normal = {0, 0, -2.0};
    EXPECT_TRUE(liesIn(distance, axial, 0.5)) << "from the other side, and of any length";
    distance.normal = {0, 0.01, 1.0};
    EXPECT_TRUE(liesIn(distance, axial, 0.5)) << "half a degree";
    distance.normal = {0, 0.03, 1.0};
    EXPECT_FALSE(liesIn(distance, axial, 0.5)) << "two degrees";
    distance.normal = {1, 0, 0};
    EXPECT_FALSE(liesIn(distance, axial, 0.5));

    const Measurement angle{.shape = Angle{{glm::dvec3(0, 0, 30), {1, 0, 30}, {1, 5, 31}}}};
    EXPECT_TRUE(liesIn(angle, axial, 1.0));
    EXPECT_FALSE(liesIn(angle, axial, 0.9));

    // Of an ellipse its own plane counts, and its rim.
    Ellipse shape{.plane = planeOf(Orientation::axial, {0, 0, 30.2}), .radiiMm = {40, 40}};
    EXPECT_TRUE(liesIn({.shape = shape, .normal = {1, 0, 0}}, axial, 0.3));
    EXPECT_FALSE(liesIn({.shape = shape}, axial, 0.1));
    shape.plane = turned(shape.plane, 0.5, {1, 0, 0});
    EXPECT_FALSE(liesIn({.shape = shape}, axial, 0.3)) << "its rim is 0.35 mm farther away";
    EXPECT_TRUE(liesIn({.shape = shape}, axial, 0.6));
    shape.plane = planeOf(Orientation::coronal, {0, 0, 30});
    EXPECT_FALSE(liesIn({.shape = shape}, axial, 1e6));
}

TEST(LiesIn, WhatIsNoNumberLiesInNoPlane) {
    const SlicePlane axial = planeOf(Orientation::axial, {0, 0, 0});
    const Measurement good{.shape = Distance{}};
    EXPECT_TRUE(liesIn(good, axial, 1.0));
    EXPECT_FALSE(liesIn(good, axial, kNaN));
    EXPECT_FALSE(liesIn(good, axial, -1.0));
    EXPECT_FALSE(liesIn({.shape = Distance{}, .normal = glm::dvec3(0.0)}, axial, 1.0));
    EXPECT_FALSE(liesIn({.shape = Distance{}, .normal = {0, 0, kNaN}}, axial, 1.0));
    EXPECT_FALSE(liesIn({.shape = Distance{{glm::dvec3(0, 0, kNaN), {}}}}, axial, 1.0));
    EXPECT_FALSE(liesIn({.shape = Ellipse{.plane = axial, .radiiMm = {kNaN, 1.0}}}, axial, 1.0));
    EXPECT_FALSE(liesIn(good, {.right = {0, 0, 0}}, 1.0));
}

TEST(TextOf, IsWhatARadiologistReads) {
    const Volume volume = grid([](const glm::ivec3& v) { return v.x < 20 ? 35 : 160; });
    const auto text = [&](const auto& shape) { return textOf({.shape = shape}, volume); };
    EXPECT_EQ(text(Distance{{glm::dvec3(0.0), {12.34, 0, 0}}}), "12.3 mm");
    EXPECT_EQ(text(Distance{}), "0.0 mm");
    EXPECT_EQ(text(Distance{{glm::dvec3(0.0), {1e300, 0, 0}}}), "1e+300 mm");
    EXPECT_EQ(text(Distance{{glm::dvec3(0.0), {kNaN, 0, 0}}}), "–");
    EXPECT_EQ(text(Angle{{glm::dvec3(1, 0, 0), {}, {1, 1, 0}}}), "45.0°");
    EXPECT_EQ(text(Angle{}), "–");
    // 46 of 81 voxels have 160: (46 * 160 + 35 * 35) / 81, and a deviation of 125 sqrt(46 * 35 / (81 * 80)).
    EXPECT_EQ(text(ellipseAt({20, 20, 2}, glm::dvec2(5.001))), "106 ± 62 HU, min 35, max 160, 78.6 mm²");
    EXPECT_EQ(text(ellipseAt({5, 20, 2}, glm::dvec2(0.1))), "35 HU, min 35, max 35, 0.0314 mm²");
    EXPECT_EQ(text(ellipseAt({5, 20, 99}, {10, 10})), "–, 314 mm²");
    EXPECT_EQ(text(ellipseAt({5, 20, 99}, {kNaN, 10})), "–, –");
}

// Lengths and areas; angles and values do not depend on the size of a pixel.
TEST(TextOf, OfUncalibratedPixelsSizesAreEstimates) {
    VolumeOptions options{.size = {41, 41, 4}, .unit = Unit::hounsfield};
    options.provenance.isCalibrated = false;
    const Volume volume = volumeOf(options, [](const glm::ivec3& v) { return v.x < 20 ? 35 : 160; });
    const auto text = [&](const auto& shape) { return textOf({.shape = shape}, volume); };
    EXPECT_EQ(text(Distance{{glm::dvec3(0.0), {12.34, 0, 0}}}), "≈ 12.3 mm");
    EXPECT_EQ(text(Distance{{glm::dvec3(0.0), {kNaN, 0, 0}}}), "–");
    EXPECT_EQ(text(Angle{{glm::dvec3(1, 0, 0), {}, {1, 1, 0}}}), "45.0°");
    EXPECT_EQ(text(ellipseAt({20, 20, 2}, glm::dvec2(5.001))), "106 ± 62 HU, min 35, max 160, ≈ 78.6 mm²");
    EXPECT_TRUE(hasSize({.shape = Distance{}}));
    EXPECT_FALSE(hasSize({.shape = Angle{}}));
    EXPECT_TRUE(hasSize({.shape = Ellipse{}}));
}

TEST(TextOf, HasTheUnitOfTheVolumeAndDigitsForSmallValues) {
    const Ellipse ellipse = ellipseAt({20, 20, 2}, glm::dvec2(5.001));
    const auto text = [&](Unit unit, const std::string& name, const UnitsFromStored& map) {
        VolumeOptions options{.size = {41, 41, 4}, .unitsFromStored = map, .unit = unit, .unitName = name};
        return textOf({.shape = ellipse},
                      volumeOf(options, [](const glm::ivec3& v) { return v.x < 20 ? 35 : 160; }));
    };
    EXPECT_EQ(text(Unit::raw, "", {}), "106 ± 62, min 35, max 160, 78.6 mm²");
    EXPECT_EQ(text(Unit::suvBodyWeight, "", {.slope = 0.01}),
              "1.06 ± 0.62 SUV bw, min 0.35, max 1.60, 78.6 mm²");
    EXPECT_EQ(text(Unit::other, "mm²/s", {.slope = 1e-5}),
              "0.00106 ± 0.00062 mm²/s, min 0.00035, max 0.00160, 78.6 mm²");
    EXPECT_EQ(text(Unit::hounsfield, "", {.intercept = -106.0}), "0 ± 62 HU, min -71, max 54, 78.6 mm²")
        << "and no minus before a zero";
}

}  // namespace
}  // namespace macula::slices
