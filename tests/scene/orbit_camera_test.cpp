#include "scene/camera/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace macula::scene {
namespace {

constexpr Box kBox{{-100, -50, -200}, {140, 90, 160}};
constexpr double kHeightPx = 600;

OrbitCamera someCamera() {
    return {.targetMm = {10, -20, 30}, .distanceMm = 700, .azimuthDeg = 33, .elevationDeg = -21};
}

// Where a point is in the picture, in pixels from its centre, y downwards.
glm::dvec2 project(const OrbitCamera& orbit, const glm::dvec3& pointMm) {
    const Camera camera = toCamera(orbit);
    const CameraBasis axes = *basis(camera);
    const glm::dvec3 toPoint = pointMm - camera.positionMm;
    const double depth = glm::dot(toPoint, axes.forward);
    const double pixelsPerTangent = 0.5 * kHeightPx / std::tan(glm::radians(camera.verticalFovDeg) / 2);
    return {glm::dot(toPoint, axes.right) / depth * pixelsPerTangent,
            -glm::dot(toPoint, axes.up) / depth * pixelsPerTangent};
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(OrbitCamera, StandardViewsAreThoseOfTheCommand) {
    for (const auto from : {ViewDirection::anterior, ViewDirection::posterior, ViewDirection::left,
                            ViewDirection::right, ViewDirection::superior, ViewDirection::inferior,
                            ViewDirection::oblique, ViewDirection::threeQuarter, ViewDirection::turned}) {
        const Camera expected = framePoints(cornersOf(kBox), standardBasis(from), 30, 1.25);
        const Camera camera = toCamera(framed(cornersOf(kBox), from, 30, 1.25));
        expectNear(camera.positionMm, expected.positionMm, 1e-9);
        expectNear(camera.targetMm, expected.targetMm, 1e-9);
        expectNear(basis(camera)->up, basis(expected)->up, 1e-9);
        expectNear(basis(camera)->right, basis(expected)->right, 1e-9);
    }
}

TEST(OrbitCamera, FitsFromWhereItLooks) {
    const OrbitCamera before = someCamera();
    const OrbitCamera camera = fitted(before, cornersOf(kBox), 1.25);
    EXPECT_EQ(camera.azimuthDeg, before.azimuthDeg);
    EXPECT_EQ(camera.elevationDeg, before.elevationDeg);
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    for (const glm::dvec3& corner : cornersOf(kBox)) {
        low = glm::min(low, project(camera, corner));
        high = glm::max(high, project(camera, corner));
    }
    const glm::dvec2 part = (high - low) / glm::dvec2(1.25 * kHeightPx, kHeightPx);
    EXPECT_NEAR(std::max(part.x, part.y), 0.9, 1e-9);
    EXPECT_NEAR(low.x + high.x, 0.0, 0.01 * kHeightPx);
    EXPECT_NEAR(low.y + high.y, 0.0, 0.01 * kHeightPx);
}

TEST(OrbitCamera, OrbitKeepsTargetAndDistance) {
    const OrbitCamera before = someCamera();
    for (const double azimuth : {-400.0, -7.0, 0.0, 90.0, 359.0}) {
        for (const double elevation : {-300.0, -5.0, 0.0, 60.0, 500.0}) {
            const Camera camera = toCamera(orbited(before, azimuth, elevation));
            expectNear(camera.targetMm, before.targetMm, 0.0);
            EXPECT_NEAR(glm::distance(camera.positionMm, camera.targetMm), before.distanceMm, 1e-9);
        }
    }
}

TEST(OrbitCamera, TheTurntableNeverFlips) {
    OrbitCamera camera = someCamera();
    glm::dvec3 lastUp = basis(toCamera(camera))->up;
    for (int step = 0; step < 2000; ++step) {
        camera = orbited(camera, 1.3, step % 400 < 200 ? 1.1 : -1.1);  // over both poles, had it no limit
        const auto axes = basis(toCamera(camera));
        ASSERT_TRUE(axes.ok());
        EXPECT_GE(axes->up.z, -1e-12);               // superior is never below
        EXPECT_NEAR(axes->right.z, 0.0, 1e-12);      // and the horizon stays level
        EXPECT_GT(glm::dot(axes->up, lastUp), 0.9);  // without jumps
        lastUp = axes->up;
    }
}

TEST(OrbitCamera, AnglesComeBackAfterAFullTurn) {
    OrbitCamera camera = someCamera();
    for (int i = 0; i < 72; ++i) camera = orbited(camera, 5, 0);
    EXPECT_NEAR(camera.azimuthDeg, someCamera().azimuthDeg, 1e-9);
}

TEST(OrbitCamera, TheFrontOfThePatientFollowsTheDrag) {
    const OrbitCamera before = someCamera();
    const Camera camera = toCamera(before);
    const glm::dvec3 front = before.targetMm + 100.0 * glm::normalize(camera.positionMm - camera.targetMm);
    EXPECT_GT(project(orbitedByDrag(before, 20, 0, kHeightPx), front).x, 1.0);
    EXPECT_LT(project(orbitedByDrag(before, -20, 0, kHeightPx), front).x, -1.0);
    EXPECT_GT(project(orbitedByDrag(before, 0, 20, kHeightPx), front).y, 1.0);
    EXPECT_LT(project(orbitedByDrag(before, 0, -20, kHeightPx), front).y, -1.0);
}

TEST(OrbitCamera, PanKeepsThePointUnderTheCursor) {
    const OrbitCamera before = someCamera();
    const CameraBasis axes = *basis(toCamera(before));
    const glm::dvec3 point = before.targetMm + 40.0 * axes.right - 25.0 * axes.up;
    const glm::dvec2 at = project(before, point);
    const OrbitCamera after = pannedByDrag(before, 37, -52, kHeightPx);
    EXPECT_NEAR(project(after, point).x, at.x + 37, 1e-9);
    EXPECT_NEAR(project(after, point).y, at.y - 52, 1e-9);
    // Parallel to the picture, and nothing else changed.
    EXPECT_NEAR(glm::dot(after.targetMm - before.targetMm, axes.forward), 0.0, 1e-9);
    EXPECT_EQ(after.distanceMm, before.distanceMm);
    EXPECT_EQ(after.azimuthDeg, before.azimuthDeg);
}

TEST(OrbitCamera, ZoomStopsBeforeTheTargetAndBeforeThePatientIsLost) {
    const double diagonal = kBox.diagonal();
    EXPECT_NEAR(zoomed(someCamera(), 2.0, diagonal).distanceMm, 350.0, 1e-9);
    EXPECT_GT(zoomed(someCamera(), 1e30, diagonal).distanceMm, 0.0);
    EXPECT_TRUE(basis(toCamera(zoomed(someCamera(), 1e30, diagonal))).ok());
    EXPECT_LT(zoomed(someCamera(), 0.0, diagonal).distanceMm, 100 * diagonal);
}

// Clockwise in the picture: what was on top comes to the right.
TEST(OrbitCamera, RollsThePatientClockwise) {
    const OrbitCamera upright = framed(cornersOf(kBox), ViewDirection::anterior, 30, 1);
    const EdgeLetters quarter = edgeLetters(rolled(upright, 90));
    EXPECT_EQ(quarter.right, "S");
    EXPECT_EQ(quarter.top, "R");
    EXPECT_EQ(quarter.left, "I");
    const EdgeLetters back = edgeLetters(rolled(upright, -90));
    EXPECT_EQ(back.left, "S");
    EXPECT_EQ(edgeLetters(rolled(rolled(upright, 190), 170)).top, "S");
    EXPECT_EQ(rolledByDrag(upright, kHeightPx, kHeightPx).rollDeg, -180.0) << "half a turn";
    for (const double roll : {0.0, 37.0, -120.0, 179.0}) {
        for (const double elevation : {-90.0, -20.0, 0.0, 89.9, 90.0}) {
            OrbitCamera camera = someCamera();
            camera.elevationDeg = elevation;
            const auto axes = basis(toCamera(rolled(camera, roll)));
            ASSERT_TRUE(axes.ok());
            // Never mirrored.
            EXPECT_NEAR(glm::dot(glm::cross(axes->right, axes->up), -axes->forward), 1.0, 1e-9);
        }
    }
}

TEST(OrbitCamera, ComesBackFromItsCamera) {
    for (const double roll : {0.0, 12.0, -170.0}) {
        for (const double elevation : {-60.0, 0.0, 40.0}) {
            for (const bool isParallel : {false, true}) {
                OrbitCamera before = rolled(someCamera(), roll);
                before.elevationDeg = elevation;
                before.isParallel = isParallel;
                const OrbitCamera after = orbitCameraOf(standingBefore(toCamera(before), kBox));
                EXPECT_NEAR(after.distanceMm, before.distanceMm, 1e-6);
                EXPECT_NEAR(after.azimuthDeg, before.azimuthDeg, 1e-6);
                EXPECT_NEAR(after.elevationDeg, before.elevationDeg, 1e-6);
                EXPECT_NEAR(after.rollDeg, before.rollDeg, 1e-5);
                EXPECT_EQ(after.isParallel, isParallel);
                if (roll == 0.0) {
                    EXPECT_EQ(after.rollDeg, 0.0);
                }
            }
        }
    }
}

TEST(OrbitCamera, ThePatientFollowsTheDragInARolledPictureToo) {
    const OrbitCamera before = rolled(someCamera(), 70);
    const Camera camera = toCamera(before);
    const glm::dvec3 front = before.targetMm + 100.0 * glm::normalize(camera.positionMm - camera.targetMm);
    EXPECT_GT(project(orbitedByDrag(before, 20, 0, kHeightPx), front).x, 1.0);
    EXPECT_GT(project(orbitedByDrag(before, 0, 20, kHeightPx), front).y, 1.0);
    const CameraBasis axes = *basis(camera);
    const glm::dvec3 point = before.targetMm + 40.0 * axes.right - 25.0 * axes.up;
    const glm::dvec2 at = project(before, point);
    const OrbitCamera after = pannedByDrag(before, 37, -52, kHeightPx);
    EXPECT_NEAR(project(after, point).x, at.x + 37, 1e-9);
    EXPECT_NEAR(project(after, point).y, at.y - 52, 1e-9);
}

TEST(OrbitCamera, FliesForwardWithWhatItTurnsAround) {
    const OrbitCamera before = someCamera();
    const Camera from = toCamera(before);
    const Camera to = toCamera(flown(before, 50, kBox));
    const glm::dvec3 forward = basis(from)->forward;
    expectNear(to.positionMm, from.positionMm + 50.0 * forward, 1e-9);
    expectNear(to.targetMm, from.targetMm + 50.0 * forward, 1e-9);
    OrbitCamera far = before;
    for (int i = 0; i < 1000; ++i) far = flown(far, 40, kBox);
    EXPECT_LE(glm::distance(far.targetMm, kBox.centre()), kBox.diagonal());
    EXPECT_NE(flown(far, -40, kBox).targetMm, far.targetMm) << "the way back is free";
    EXPECT_EQ(flown(before, std::nan(""), kBox).targetMm, before.targetMm);
}

TEST(OrbitCamera, TurnsToASideAsNearAsBefore) {
    for (const auto side : {ViewDirection::anterior, ViewDirection::posterior, ViewDirection::left,
                            ViewDirection::right, ViewDirection::superior, ViewDirection::inferior,
                            ViewDirection::oblique, ViewDirection::threeQuarter, ViewDirection::turned}) {
        const OrbitCamera turned = turnedTo(rolled(someCamera(), 33), side);
        EXPECT_EQ(turned.targetMm, someCamera().targetMm);
        EXPECT_EQ(turned.distanceMm, someCamera().distanceMm);
        const CameraBasis expected = standardBasis(side);
        expectNear(basis(toCamera(turned))->forward, expected.forward, 1e-9);
        expectNear(basis(toCamera(turned))->up, expected.up, 1e-9);
    }
}

TEST(OrbitCamera, ParallelRaysKeepTheScaleOfTheTargetAndZoomChangesIt) {
    OrbitCamera camera = someCamera();
    const double mm = mmPerPixel(camera, kHeightPx);
    EXPECT_NEAR(mm, 2.0 * 700 * std::tan(glm::radians(15.0)) / kHeightPx, 1e-12);
    camera.isParallel = true;
    EXPECT_NEAR(mmPerPixel(camera, kHeightPx), mm, 1e-12);
    EXPECT_NEAR(toCamera(zoomed(camera, 2.0, kBox.diagonal())).parallelHeightMm, 0.5 * mm * kHeightPx, 1e-9);
    for (const double magnification : {1e-30, 1e30})
        EXPECT_TRUE(basis(toCamera(zoomed(camera, magnification, kBox.diagonal()))).ok());
    const OrbitCamera all = fitted(camera, cornersOf(kBox), 1.25);
    EXPECT_TRUE(all.isParallel);
    EXPECT_EQ(all.azimuthDeg, camera.azimuthDeg);
    const CameraBasis axes = *basis(toCamera(all));
    glm::dvec2 most(0.0);
    for (const glm::dvec3& corner : cornersOf(kBox)) {
        const glm::dvec3 v = corner - all.targetMm;
        most = glm::max(most, glm::abs(glm::dvec2(glm::dot(v, axes.right), glm::dot(v, axes.up))));
    }
    const double half = 0.5 * mmPerPixel(all, kHeightPx) * kHeightPx;
    EXPECT_NEAR(std::max(most.x / 1.25, most.y) / half, 0.9, 1e-9);
}

TEST(OrbitCamera, LettersAreThoseOfARadiologicalDisplay) {
    const EdgeLetters front = edgeLetters(framed(cornersOf(kBox), ViewDirection::anterior, 30, 1));
    EXPECT_EQ(front.left, "R");
    EXPECT_EQ(front.right, "L");
    EXPECT_EQ(front.top, "S");
    EXPECT_EQ(front.bottom, "I");
    const EdgeLetters below = edgeLetters(framed(cornersOf(kBox), ViewDirection::inferior, 30, 1));
    EXPECT_EQ(below.left, "R");
    EXPECT_EQ(below.top, "A");
    const EdgeLetters above = edgeLetters(framed(cornersOf(kBox), ViewDirection::superior, 30, 1));
    EXPECT_EQ(above.left, "L");
    EXPECT_EQ(above.top, "A");
    const EdgeLetters oblique =
        edgeLetters(orbited(framed(cornersOf(kBox), ViewDirection::anterior, 30, 1), 30, 0));
    EXPECT_EQ(oblique.right, "LP");
}

}  // namespace
}  // namespace macula::scene
