// Where lights shine from, in the world and on the dome over the picture.
#include "scene/lights/light_direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace macula::scene {
namespace {

using trace::LightFrame;
using trace::SoftLight;

CameraBasis fromAnterior() {
    return *basis({.positionMm = {0, -500, 0}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}});
}

CameraBasis oblique() {
    return *basis({.positionMm = {300, -200, 150}, .targetMm = {10, 20, 30}, .up = {0.1, 0.2, 1}});
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-9)
        << a.x << " " << a.y << " " << a.z << ", not " << b.x << " " << b.y << " " << b.z;
}

TEST(LightDirection, PatientAnglesAreThoseOfTheRigsPage) {
    const LightStand stand{LightFrame::patient, oblique(), 0.0};
    expectNear(directionTo({.azimuthDeg = 0}, stand), {0, -1, 0});                      // anterior
    expectNear(directionTo({.azimuthDeg = 90}, stand), {1, 0, 0});                      // the patient's left
    expectNear(directionTo({.azimuthDeg = 33, .elevationDeg = 90}, stand), {0, 0, 1});  // superior
}

TEST(LightDirection, CameraAnglesAreOfThePicture) {
    const CameraBasis eye = oblique();
    const LightStand stand{LightFrame::camera, eye, 0.0};
    expectNear(directionTo({.azimuthDeg = 0}, stand), -eye.forward);  // from behind the viewer
    expectNear(directionTo({.azimuthDeg = 90}, stand), eye.right);
    expectNear(directionTo({.azimuthDeg = 0, .elevationDeg = 90}, stand), eye.up);
}

// The same turn as the tracer's (writeLights in scene.cpp): what was at azimuth 0 is then at this azimuth.
TEST(LightDirection, TurnsWithTheRotation) {
    expectNear(directionTo({.azimuthDeg = -20}, {LightFrame::patient, oblique(), 110.0}), {1, 0, 0});
}

TEST(LightDirection, ShiningFromIsTheInverse) {
    std::mt19937 dice(5);
    std::normal_distribution<double> any;
    for (const LightFrame frame : {LightFrame::patient, LightFrame::camera}) {
        for (int i = 0; i < 200; ++i) {
            const LightStand stand{frame, oblique(), 77.0 * any(dice)};
            const glm::dvec3 direction(any(dice), any(dice), any(dice));
            const SoftLight light = shiningFrom({.radiance = 7.0}, direction, stand);
            expectNear(directionTo(light, stand), glm::normalize(direction));
            EXPECT_LE(std::abs(light.azimuthDeg), 180.0);
            EXPECT_EQ(light.radiance, 7.0);
        }
    }
}

TEST(LightDirection, KeepsTheAzimuthAtThePoles) {
    const LightStand stand{LightFrame::patient, oblique(), 0.0};
    const SoftLight light = shiningFrom({.azimuthDeg = 40}, {0, 0, -2}, stand);
    EXPECT_EQ(light.elevationDeg, -90.0);
    EXPECT_EQ(light.azimuthDeg, 40.0);
}

TEST(LightDirection, NoDirectionMovesNothing) {
    const LightStand stand{LightFrame::patient, oblique(), 0.0};
    const SoftLight light{.azimuthDeg = 1, .elevationDeg = 2};
    EXPECT_EQ(shiningFrom(light, glm::dvec3(0.0), stand), light);
    EXPECT_EQ(shiningFrom(light, glm::dvec3(std::numeric_limits<double>::quiet_NaN()), stand), light);
    EXPECT_EQ(shiningFrom(light, glm::dvec3(std::numeric_limits<double>::infinity()), stand), light);
}

TEST(LightDome, ItsMiddleShinesFromTheEyeAndItsRimFromBehind) {
    const CameraBasis eye = fromAnterior();
    expectNear(directionOnDome({0, 0}, eye, 1.5), -eye.forward);
    expectNear(directionOnDome(circleOnDome(90.0, 0.0, 1.5), eye, 1.5), {1, 0, 0});  // the patient's left
    expectNear(directionOnDome(circleOnDome(90.0, std::numbers::pi / 2, 1.5), eye, 1.5), {0, 0, 1});
    expectNear(directionOnDome(circleOnDome(180.0, 1.0, 1.5), eye, 1.5), eye.forward);
    expectNear(directionOnDome({-9, 0}, eye, 1.5), eye.forward);  // outside: the rim
}

TEST(LightDome, PlacesAndDirectionsAreInverse) {
    std::mt19937 dice(6);
    std::normal_distribution<double> any;
    for (const double aspect : {0.5, 1.0, 2.0}) {
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 direction = glm::normalize(glm::dvec3(any(dice), any(dice), any(dice)));
            const glm::dvec2 place = placeOnDome(direction, oblique(), aspect);
            expectNear(directionOnDome(place, oblique(), aspect), direction);
            EXPECT_LE(std::max(std::abs(place.x), std::abs(place.y)), 1.0);  // all of it is in the picture
        }
    }
}

TEST(LightDome, IsRoundInThePicture) {
    const double aspect = 1.6;
    const glm::dvec2 right = circleOnDome(90.0, 0.0, aspect);
    const glm::dvec2 up = circleOnDome(90.0, std::numbers::pi / 2, aspect);
    EXPECT_NEAR(right.x * aspect, up.y, 1e-12);
}

}  // namespace
}  // namespace macula::scene
