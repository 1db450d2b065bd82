#include "slices/slice_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "made_volumes.h"
#include "slices/sampled_slice.h"

namespace macula::slices::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expectSame(const glm::dvec3& a, const glm::dvec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-9)
        << a.x << " " << a.y << " " << a.z << ", wanted " << b.x << " " << b.y << " " << b.z;
}

// LPS: +x to the left, +y to posterior, +z to the head.
TEST(SlicePlane, LooksAsARadiologistDoes) {
    const glm::dvec3 centre{1, 2, 3};
    const SlicePlane axial = planeOf(Orientation::axial, centre);
    EXPECT_EQ(orientationLetters(axial.right), "L");
    EXPECT_EQ(orientationLetters(axial.down), "P");
    EXPECT_EQ(orientationLetters(axial.normal()), "S");
    EXPECT_EQ(axial.centreMm, centre);
    const SlicePlane coronal = planeOf(Orientation::coronal, centre);
    EXPECT_EQ(orientationLetters(coronal.right), "L");
    EXPECT_EQ(orientationLetters(coronal.down), "I");
    EXPECT_EQ(orientationLetters(coronal.normal()), "P");
    const SlicePlane sagittal = planeOf(Orientation::sagittal, centre);
    EXPECT_EQ(orientationLetters(sagittal.right), "P");
    EXPECT_EQ(orientationLetters(sagittal.down), "I");
    EXPECT_EQ(orientationLetters(sagittal.normal()), "R");
}

TEST(SlicePlane, IsUsableWhenItsAxesAre) {
    EXPECT_TRUE(SlicePlane{}.isUsable());
    EXPECT_TRUE((SlicePlane{.right = {1.0005, 0, 0}}.isUsable()));
    EXPECT_FALSE((SlicePlane{.right = {1.01, 0, 0}}.isUsable()));
    EXPECT_FALSE((SlicePlane{.right = {0, 0, 0}}.isUsable()));
    EXPECT_FALSE((SlicePlane{.right = {0, 1, 0}}.isUsable()));
    EXPECT_FALSE((SlicePlane{.down = {0, kNan, 0}}.isUsable()));
    EXPECT_FALSE((SlicePlane{.centreMm = {0, 0, kNan}}.isUsable()));
    EXPECT_TRUE(SliceFrame{}.isUsable());
    EXPECT_FALSE(SliceFrame{.mmPerPixel = 0.0}.isUsable());
    EXPECT_FALSE(SliceFrame{.mmPerPixel = kNan}.isUsable());
}

// Of each pose: what its slices are, and what runs to the right and down in their picture.
struct Acquired {
    const char* pose;
    Orientation orientation;
    glm::dvec3 right;
    glm::dvec3 down;
};

TEST(AcquiredPlane, IsTurnedToWhatItIsNearestTo) {
    const double tilt = 0.25;
    const glm::dvec3 left{1, 0, 0};
    const glm::dvec3 posterior{0, 1, 0};
    const glm::dvec3 feet{0, 0, -1};
    const std::vector<Acquired> cases{
        {"axial", Orientation::axial, left, posterior},
        {"axial, from head to feet", Orientation::axial, left, posterior},
        {"prone", Orientation::axial, left, posterior},
        {"coronal", Orientation::coronal, left, feet},
        {"sagittal", Orientation::sagittal, posterior, feet},
        {"tilted gantry", Orientation::axial, left, {0, std::cos(tilt), -std::sin(tilt)}}};
    const std::vector<Pose> all = poses();
    for (const Acquired& wanted : cases) {
        SCOPED_TRACE(wanted.pose);
        const auto pose = std::ranges::find(all, wanted.pose, &Pose::name);
        ASSERT_NE(pose, all.end());
        const Volume volume = storedVolume({5, 6, 7}, pose->worldFromVoxel, Padding::none);
        EXPECT_EQ(acquiredOrientation(volume), wanted.orientation);
        const SlicePlane plane = acquiredPlane(volume, {4, 5, 6});
        expectSame(plane.centreMm, {4, 5, 6});
        expectSame(plane.right, wanted.right);
        expectSame(plane.down, wanted.down);
    }
}

// However the rows of an image lie: in its plane, along its rows, and not mirrored.
TEST(AcquiredPlane, IsInThePlaneOfTheSlicesAndNeverMirrored) {
    Random random(21);
    for (int n = 0; n < 500; ++n) {
        const SlicePlane rows = randomPlane({}, random);
        const double handed = n % 2 == 0 ? 1.0 : -1.0;
        const double shear = n % 3 == 0 ? 0.2 : 0.0;
        const glm::dvec3 toNext = 2.5 * handed * rows.normal() + shear * rows.right;
        const Volume volume = storedVolume(
            {3, 3, 3}, affine(0.7 * rows.right, 0.9 * rows.down, toNext, {1, 2, 3}), Padding::none);
        const SlicePlane plane = acquiredPlane(volume, {});
        const SlicePlane standard = planeOf(acquiredOrientation(volume), {});
        EXPECT_NEAR(glm::length(plane.right), 1.0, 1e-9);
        EXPECT_NEAR(glm::length(plane.down), 1.0, 1e-9);
        EXPECT_NEAR(glm::dot(plane.right, plane.down), 0.0, 1e-9);
        EXPECT_NEAR(std::abs(glm::dot(plane.normal(), rows.normal())), 1.0, 1e-9);
        EXPECT_GT(glm::dot(plane.normal(), standard.normal()), 0.57);  // of three, one is within 55 degrees
        // Along rows or columns.
        const double alongRows = std::abs(glm::dot(plane.right, rows.right));
        EXPECT_LT(std::min(alongRows, 1.0 - alongRows), 1e-9);
        // Quarter turns of it are no nearer.
        const auto alike = [&](const glm::dvec3& right, const glm::dvec3& down) {
            return glm::dot(right, standard.right) + glm::dot(down, standard.down);
        };
        const double best = alike(plane.right, plane.down);
        EXPECT_GE(best + 1e-6, alike(plane.down, -plane.right));
        EXPECT_GE(best + 1e-6, alike(-plane.right, -plane.down));
        EXPECT_GE(best + 1e-6, alike(-plane.down, plane.right));
    }
}

TEST(SliceFrame, LeadsToThePatientAndBack) {
    Random random(22);
    const SliceFrame axial{
        .plane = planeOf(Orientation::axial, {10, 20, 30}), .mmPerPixel = 0.5, .sizePx = {100, 60}};
    expectSame(axial.worldFromPicture({50, 30}), {10, 20, 30});
    expectSame(axial.worldFromPicture({0, 0}), {10 - 25, 20 - 15, 30});
    EXPECT_DOUBLE_EQ(axial.distanceMm({-5, 9, 34}), 4.0);
    for (int n = 0; n < 100; ++n) {
        const SliceFrame frame{.plane = randomPlane({n, 2, 3}, random),
                               .mmPerPixel = uniform(random, 0.01, 3.0),
                               .sizePx = {101, 60 + n}};
        const glm::dvec2 px{uniform(random, -50, 200), uniform(random, -50, 200)};
        const glm::dvec3 mm = frame.worldFromPicture(px);
        EXPECT_NEAR(frame.distanceMm(mm), 0.0, 1e-9);
        const glm::dvec3 off = mm + 12.5 * frame.plane.normal();
        EXPECT_NEAR(frame.distanceMm(off), 12.5, 1e-9);
        EXPECT_LT(glm::length(frame.pictureFromWorld(off) - px), 1e-6);
    }
}

// 100 x 80 x 60 mm.
Volume block() {
    return storedVolume({50, 40, 20}, affine({2, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-49, -39, -28.5}),
                        Padding::none);
}

TEST(FittedScale, TakesAllThatThePlaneMeets) {
    const Volume volume = block();
    EXPECT_NEAR(fittedMmPerPixel(volume, planeOf(Orientation::axial, {}), {500, 500}), 0.2, 1e-12);
    EXPECT_NEAR(fittedMmPerPixel(volume, planeOf(Orientation::axial, {}), {500, 100}), 0.8, 1e-12);
    EXPECT_NEAR(fittedMmPerPixel(volume, planeOf(Orientation::coronal, {}), {500, 100}), 0.6, 1e-12);
    EXPECT_NEAR(fittedMmPerPixel(volume, planeOf(Orientation::sagittal, {}), {500, 500}), 0.16, 1e-12);
    // From a centre that is 10 mm to one side it is farther to the other.
    EXPECT_NEAR(fittedMmPerPixel(volume, planeOf(Orientation::axial, {10, 0, 29}), {500, 500}), 0.24, 1e-12);
    // A plane that meets nothing: all of it.
    EXPECT_NEAR(fittedMmPerPixel(volume, planeOf(Orientation::axial, {0, 0, 500}), {500, 500}), 0.2, 1e-12);
    EXPECT_EQ(fittedMmPerPixel(volume, {.right = {kNan, 0, 0}}, {500, 500}), 1.0);
}

// At that scale nothing is outside of the picture, and at half of it something is.
TEST(FittedScale, HasNothingOutsideOfThePicture) {
    Random random(23);
    for (const Pose& pose : poses()) {
        SCOPED_TRACE(pose.name);
        const Volume volume = storedVolume({20, 24, 16}, pose.worldFromVoxel, Padding::none);
        for (int n = 0; n < 10; ++n) {
            const glm::ivec2 size{120, 80};
            SliceFrame twice{.plane = randomPlane(randomPointMm(volume, random), random),
                             .mmPerPixel = 1.0,
                             .sizePx = 2 * size};
            const double fitted = fittedMmPerPixel(volume, twice.plane, size);
            for (const double scale : {fitted, fitted / 2.0}) {
                twice.mmPerPixel = scale;
                const SampledSlice slice = sampleSlice(volume, twice, {}, Filter::nearest);
                int outside = 0;
                for (int y = 0; y < twice.sizePx.y; ++y) {
                    for (int x = 0; x < twice.sizePx.x; ++x) {
                        const bool isInPicture = x >= size.x / 2 && x < size.x / 2 + size.x &&
                                                 y >= size.y / 2 && y < size.y / 2 + size.y;
                        const float value = slice.values[std::size_t(y * twice.sizePx.x + x)];
                        outside += !isInPicture && !std::isnan(value) ? 1 : 0;
                    }
                }
                if (scale == fitted)
                    EXPECT_EQ(outside, 0);
                else
                    EXPECT_GT(outside, 0);
            }
        }
    }
}

TEST(StepMm, IsFromOnePlaneOfVoxelsToTheNext) {
    const Volume volume = block();
    EXPECT_NEAR(stepMm(volume, planeOf(Orientation::axial, {})), 3.0, 1e-12);
    EXPECT_NEAR(stepMm(volume, planeOf(Orientation::coronal, {})), 2.0, 1e-12);
    EXPECT_NEAR(stepMm(volume, planeOf(Orientation::sagittal, {})), 2.0, 1e-12);
    const SlicePlane oblique{.right = {1, 0, 0}, .down = {0, std::cos(0.3), std::sin(0.3)}};
    EXPECT_NEAR(stepMm(volume, oblique), 2.0, 1e-12);
    EXPECT_NEAR(stepMm(volume, {.right = {kNan, 0, 0}}), 2.0, 1e-12);
}

// With a tilted gantry the next slice is nearer than the next position.
TEST(StepMm, IsAlongTheNormalOfASheared) {
    const double tilt = 0.25;
    const Volume volume = storedVolume(
        {5, 5, 5}, affine({0.5, 0, 0}, {0, 0.5 * std::cos(tilt), -0.5 * std::sin(tilt)}, {0, 0, 2}, {}),
        Padding::none);
    EXPECT_NEAR(stepMm(volume, acquiredPlane(volume, {})), 2.0 * std::cos(tilt), 1e-12);
    EXPECT_NEAR(stepMm(volume, planeOf(Orientation::axial, {})), 0.5, 1e-12);
    EXPECT_NEAR(stepMm(volume, planeOf(Orientation::sagittal, {})), 0.5, 1e-12);
}

// A turn about the normal changes nothing; any other one moves the normal, and the picture least.
TEST(Tilted, TurnsTheNormalAndThePictureLeast) {
    for (const Orientation orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        const SlicePlane plane = planeOf(orientation, {1, 2, 3});
        const SlicePlane same = tilted(plane, glm::angleAxis(1.1, plane.normal()));
        EXPECT_LT(glm::distance(same.right, plane.right) + glm::distance(same.down, plane.down), 1e-12);
        const glm::dquat turn = glm::angleAxis(0.4, plane.right) * glm::angleAxis(0.9, plane.normal());
        const SlicePlane tilt = tilted(plane, turn);
        EXPECT_EQ(tilt.centreMm, plane.centreMm);
        EXPECT_TRUE(tilt.isUsable());
        EXPECT_LT(glm::distance(tilt.normal(), turn * plane.normal()), 1e-12);
        EXPECT_LT(glm::distance(tilt.right, plane.right), 1e-12) << "the axis of the tilt stays";
        const SlicePlane behind = tilted(plane, glm::angleAxis(0.9 * std::numbers::pi, plane.right));
        EXPECT_GT(glm::dot(behind.normal(), plane.normal()), 0.9) << "never seen from behind";
        EXPECT_TRUE(behind.isUsable());
        const glm::dquat half = leastTurn(plane.normal(), -plane.normal(), plane.down);
        EXPECT_LT(glm::distance(half * plane.normal(), -plane.normal()), 1e-12);
        EXPECT_LT(glm::distance(half * plane.down, plane.down), 1e-12);
    }
}

TEST(DepthsMm, AreHalfAVoxelBeyondTheOuterMiddles) {
    const DepthRange axial = depthsMm(block(), planeOf(Orientation::axial, {3, 4, 10}));
    EXPECT_NEAR(axial.lowMm, -40.0, 1e-12);
    EXPECT_NEAR(axial.highMm, 20.0, 1e-12);
    const DepthRange sagittal = depthsMm(block(), planeOf(Orientation::sagittal, {10, 0, 0}));
    EXPECT_NEAR(sagittal.lowMm, -40.0, 1e-12);  // its normal is to the patient's right
    EXPECT_NEAR(sagittal.highMm, 60.0, 1e-12);
}

}  // namespace
}  // namespace macula::slices::test
