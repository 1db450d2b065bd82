// Where eyes are, and what cameras they have.
#include "xr/eyes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace macula::xr {
namespace {

// Upright, a metre ahead of where the stage begins: patient left to the right, posterior ahead.
const glm::dmat4 kStageFromWorld = affine({1e-3, 0, 0}, {0, 0, -1e-3}, {0, 1e-3, 0}, {0.0, 1.5, -1.0});
const glm::dmat4 kWorldFromStage = glm::inverse(kStageFromWorld);

Pose facing(const glm::dvec3& positionM, const glm::dvec3& axis = {0, 1, 0}, double degrees = 0.0) {
    return {positionM, glm::angleAxis(glm::radians(degrees), glm::normalize(axis))};
}

std::vector<Eye> outwards() {
    return {{facing({-0.032, 1.6, 0.1}), -1.376, 0.839, 0.966, -1.428},
            {facing({0.032, 1.6, 0.1}), -0.839, 1.376, 0.966, -1.428}};
}

// Where the picture of an eye, by its own sides, shows a point of the world, in pixels of its part.
glm::dvec2 seenBy(const Eye& eye, const glm::ivec2& partPx, const glm::dvec3& worldMm) {
    const glm::dvec3 p =
        transformPoint(glm::inverse(kWorldFromStage * stageFromPose(eye.pose)), worldMm);  // metres
    const glm::dvec2 tangent(p.x / -p.z, p.y / -p.z);
    return {(tangent.x - eye.left) / (eye.right - eye.left) * partPx.x,
            (eye.up - tangent.y) / (eye.up - eye.down) * partPx.y};
}

// The same by the camera, as the tracer sees it.
glm::dvec2 seenBy(const Camera& camera, const glm::ivec2& sizePx, const glm::dvec3& worldMm) {
    const CameraBasis axes = *basis(camera);
    const glm::dvec3 towards = worldMm - camera.positionMm;
    const double focalPx = 0.5 * sizePx.y / std::tan(0.5 * glm::radians(camera.verticalFovDeg));
    const double along = glm::dot(towards, axes.forward);
    return {0.5 * sizePx.x + focalPx * glm::dot(towards, axes.right) / along,
            0.5 * sizePx.y - focalPx * glm::dot(towards, axes.up) / along};
}

TEST(Eyes, AnEvenFieldIsItsOwnPicture) {
    const double side = std::tan(0.6);
    const std::vector<Eye> eyes{{facing({0, 1.6, 0}), -side, side, side, -side}};
    const EyePictures pictures = picturesFor(eyes, kWorldFromStage, {64, 64}).value();
    EXPECT_EQ(pictures.sizePx, glm::ivec2(64));
    EXPECT_EQ(pictures.eyes[0].firstPx, glm::ivec2(0));
    EXPECT_EQ(pictures.eyes[0].partPx, glm::ivec2(64));
    EXPECT_NEAR(pictures.eyes[0].camera.verticalFovDeg, glm::degrees(1.2), 1e-9);
    EXPECT_NEAR(pictures.eyes[0].eye.left, -side, 1e-12);
}

// What is cut out of the even picture is exactly what the eye sees, at every point.
TEST(Eyes, APartOfAnEvenPictureIsTheUnevenOne) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (const glm::ivec2& mostPx : {glm::ivec2(64), glm::ivec2(67, 93), glm::ivec2(1680, 1760)}) {
        std::vector<Eye> eyes = outwards();
        for (Eye& eye : eyes) eye.pose.orientation = glm::angleAxis(0.3, glm::normalize(glm::dvec3(1, 2, 3)));
        const EyePictures pictures = picturesFor(eyes, kWorldFromStage, mostPx).value();
        EXPECT_EQ(pictures.sizePx % 2, glm::ivec2(0));
        for (std::size_t i = 0; i < eyes.size(); ++i) {
            const EyePicture& picture = pictures.eyes[i];
            EXPECT_LE(picture.partPx.x, mostPx.x);
            EXPECT_LE(picture.partPx.y, mostPx.y);
            EXPECT_GE(picture.firstPx.x, 0);
            EXPECT_GE(picture.firstPx.y, 0);
            EXPECT_LE(picture.firstPx.x + picture.partPx.x, pictures.sizePx.x);
            EXPECT_LE(picture.firstPx.y + picture.partPx.y, pictures.sizePx.y);
            // All that the eye sees, and less than a pixel more.
            const double pixel = (picture.eye.right - picture.eye.left) / picture.partPx.x;
            EXPECT_NEAR((picture.eye.up - picture.eye.down) / picture.partPx.y, pixel, 1e-12);
            const auto expectBeside = [&](double wanted, double got, double outwardsIs) {
                EXPECT_GE((got - wanted) * outwardsIs, -1e-5 * pixel);
                EXPECT_LE((got - wanted) * outwardsIs, pixel);
            };
            expectBeside(eyes[i].left, picture.eye.left, -1.0);
            expectBeside(eyes[i].right, picture.eye.right, 1.0);
            expectBeside(eyes[i].up, picture.eye.up, 1.0);
            expectBeside(eyes[i].down, picture.eye.down, -1.0);
            for (int k = 0; k < 50; ++k) {
                const glm::dvec3 inEye(0.4 * uniform(random), 0.4 * uniform(random),
                                       -0.5 - 0.4 * uniform(random));
                const glm::dvec3 worldMm =
                    transformPoint(kWorldFromStage * stageFromPose(picture.eye.pose), inEye);
                const glm::dvec2 whole = seenBy(picture.camera, pictures.sizePx, worldMm);
                const glm::dvec2 part = seenBy(picture.eye, picture.partPx, worldMm);
                EXPECT_NEAR(whole.x - picture.firstPx.x, part.x, 1e-6);
                EXPECT_NEAR(whole.y - picture.firstPx.y, part.y, 1e-6);
            }
        }
    }
}

TEST(Eyes, ThePatientsLeftIsAtTheRightAndTheHeadIsUp) {
    const EyePictures pictures = picturesFor(outwards(), kWorldFromStage, {512, 512}).value();
    const glm::dvec2 middle = seenBy(pictures.centre, pictures.sizePx, {0, 0, 0});
    EXPECT_GT(seenBy(pictures.centre, pictures.sizePx, {50, 0, 0}).x, middle.x + 5.0);
    EXPECT_LT(seenBy(pictures.centre, pictures.sizePx, {0, 0, 50}).y, middle.y - 5.0);
    // The right eye sees what is near farther to the left.
    EXPECT_LT(seenBy(pictures.eyes[1].camera, pictures.sizePx, {0, 0, 0}).x,
              seenBy(pictures.eyes[0].camera, pictures.sizePx, {0, 0, 0}).x - 5.0);
    // 64 mm apart in the patient, at real-world scale.
    EXPECT_NEAR(glm::distance(pictures.eyes[0].camera.positionMm, pictures.eyes[1].camera.positionMm), 64.0,
                1e-9);
}

TEST(Eyes, WhatIsNoFieldIsRefused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto expectRefused = [](const std::function<void(Eye&)>& spoil) {
        std::vector<Eye> eyes = outwards();
        spoil(eyes[1]);
        const auto refused = picturesFor(eyes, kWorldFromStage, {64, 64});
        ASSERT_FALSE(refused.ok());
        EXPECT_EQ(refused.error().code, ErrorCode::usage);
    };
    expectRefused([&](Eye& eye) { eye.left = nan; });
    expectRefused([&](Eye& eye) { eye.pose.positionM.y = nan; });
    expectRefused([&](Eye& eye) { eye.pose.orientation = glm::dquat(0, 0, 0, 0); });
    expectRefused([&](Eye& eye) { std::swap(eye.left, eye.right); });
    expectRefused([&](Eye& eye) { eye.down = eye.up; });
    expectRefused([&](Eye& eye) { eye.right = 1e6; });
}

TEST(Eyes, TheGazeIsWhereItMeetsThePicture) {
    const double side = std::tan(0.6);
    const std::vector<Eye> eyes{{facing({0, 1.6, 0}), -side, side, side, -side}};
    const EyePictures pictures = picturesFor(eyes, kWorldFromStage, {64, 64}).value();
    const auto gaze = [&](const glm::dvec3& axis, double degrees) {
        return gazeIn(pictures.centre, pictures.sizePx, kWorldFromStage, facing({0, 1.6, 0}, axis, degrees));
    };
    EXPECT_NEAR(glm::length(gaze({0, 1, 0}, 0.0)), 0.0, 1e-9);
    // A turn about up is to the left where it is positive.
    EXPECT_NEAR(gaze({0, 1, 0}, -15.0).x, std::tan(glm::radians(15.0)) / side, 1e-9);
    EXPECT_NEAR(gaze({1, 0, 0}, 10.0).y, std::tan(glm::radians(10.0)) / side, 1e-9);
    EXPECT_NEAR(glm::distance(gaze({0, 1, 0}, -80.0), glm::dvec2(1.0, 0.0)), 0.0, 1e-9);
    EXPECT_EQ(gaze({0, 1, 0}, 180.0), glm::dvec2(0.0)) << "backwards";
}

}  // namespace
}  // namespace macula::xr
