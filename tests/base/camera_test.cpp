#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "base/camera.h"

namespace macula {
namespace {

constexpr Box kBox{{-100, -50, -200}, {100, 50, 200}};

TEST(Camera, FromTheFrontThePatientsLeftIsOnTheRightOfThePicture) {
    const auto frame = basis(frameBox(kBox, ViewDirection::anterior, 30, 1.0));
    ASSERT_TRUE(frame.ok());
    EXPECT_NEAR(frame->right.x, 1.0, 1e-12);
    EXPECT_NEAR(frame->up.z, 1.0, 1e-12);
    EXPECT_NEAR(frame->forward.y, 1.0, 1e-12);
}

TEST(Camera, EveryStandardViewSeesTheWholeBox) {
    for (const auto from :
         {ViewDirection::anterior, ViewDirection::posterior, ViewDirection::left, ViewDirection::right,
          ViewDirection::superior, ViewDirection::inferior, ViewDirection::oblique}) {
        for (const double aspect : {0.5, 1.0, 2.0}) {
            const Camera camera = frameBox(kBox, from, 40, aspect);
            const auto frame = basis(camera);
            ASSERT_TRUE(frame.ok());
            const double tanHalf = std::tan(glm::radians(20.0));
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 p{corner & 1 ? 100 : -100, corner & 2 ? 50 : -50, corner & 4 ? 200 : -200};
                const glm::dvec3 toPoint = p - camera.positionMm;
                const double depth = glm::dot(toPoint, frame->forward);
                ASSERT_GT(depth, 0.0);
                EXPECT_LE(std::abs(glm::dot(toPoint, frame->up)), depth * tanHalf);
                EXPECT_LE(std::abs(glm::dot(toPoint, frame->right)), depth * tanHalf * aspect);
            }
        }
    }
}

TEST(Camera, RefusesWhatHasNoView) {
    EXPECT_FALSE(basis({.positionMm = {1, 2, 3}, .targetMm = {1, 2, 3}}).ok());
    EXPECT_FALSE(basis({.positionMm = {0, 0, -5}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}}).ok());
    EXPECT_FALSE(basis({.verticalFovDeg = 0.0}).ok());
    EXPECT_FALSE(basis({.verticalFovDeg = 171.0}).ok());
    EXPECT_FALSE(basis({.positionMm = {std::numeric_limits<double>::infinity(), 0, 0}}).ok());
}

constexpr std::array kDirections{
    ViewDirection::anterior, ViewDirection::posterior,    ViewDirection::left,
    ViewDirection::right,    ViewDirection::superior,     ViewDirection::inferior,
    ViewDirection::oblique,  ViewDirection::threeQuarter, ViewDirection::turned};

TEST(Camera, ObliquelyOneLooksFromTheFrontAndAbove) {
    const Box slab{{-170, -170, -280}, {170, 170, -204}};
    const auto axes = basis(frameBox(slab, ViewDirection::oblique, 30, 1.0));
    ASSERT_TRUE(axes.ok());
    EXPECT_GT(axes->forward.y, 0.5) << "to the back";
    EXPECT_LT(axes->forward.z, -0.5) << "and down";
    EXPECT_LT(axes->forward.x, 0.0) << "from the patient's left";
    EXPECT_GT(axes->right.x, 0.5) << "which stays on the right of the picture";
    EXPECT_GT(axes->up.z, 0.5);
}

TEST(Camera, ParallelRaysShowAsMuchOfThePlaneOfTheTarget) {
    const Camera eye{.positionMm = {30, -700, 50}, .targetMm = {10, -20, 30}, .verticalFovDeg = 25};
    const Camera parallel = inParallel(eye);
    EXPECT_TRUE(isParallel(parallel));
    EXPECT_FALSE(isParallel(eye));
    EXPECT_NEAR(heightAtTargetMm(parallel), heightAtTargetMm(eye), 1e-9);
    EXPECT_NEAR(heightAtTargetMm(eye),
                2.0 * glm::distance(eye.positionMm, eye.targetMm) * std::tan(glm::radians(12.5)), 1e-9);
    EXPECT_NEAR(glm::distance(inPerspective(parallel).positionMm, eye.positionMm), 0.0, 1e-9);
    EXPECT_EQ(inPerspective(eye), eye);
    // The place of a parallel camera along its view says nothing about its size.
    Camera moved = parallel;
    moved.positionMm = moved.targetMm + 3.0 * (moved.positionMm - moved.targetMm);
    EXPECT_NEAR(glm::distance(inPerspective(moved).positionMm, eye.positionMm), 0.0, 1e-9);
}

TEST(Camera, ParallelRaysBeginBeforeAllOfABox) {
    for (const glm::dvec3& from : {glm::dvec3(0, -10, 0), glm::dvec3(90, 10, -150), glm::dvec3(0, 5000, 1)}) {
        Camera camera{.positionMm = from, .targetMm = {1, 2, 3}, .up = {0.1, 0.2, 1}};
        camera.parallelHeightMm = 200;
        const Camera before = standingBefore(camera, kBox);
        const CameraBasis axes = *basis(before);
        for (const glm::dvec3& corner : cornersOf(kBox))
            EXPECT_GT(glm::dot(corner - before.positionMm, axes.forward), 0.0);
        // The same rays.
        EXPECT_NEAR(glm::distance(axes.forward, basis(camera)->forward), 0.0, 1e-9);
        EXPECT_NEAR(glm::dot(before.positionMm - camera.positionMm, axes.right), 0.0, 1e-9);
        EXPECT_NEAR(glm::dot(before.positionMm - camera.positionMm, axes.up), 0.0, 1e-9);
        EXPECT_EQ(standingBefore(before, kBox), before);
        camera.parallelHeightMm = 0.0;
        EXPECT_EQ(standingBefore(camera, kBox), camera) << "an eye stays where it is";
    }
}

TEST(Camera, AParallelPictureIsFilledByWhatItIsOf) {
    for (const auto from : kDirections) {
        for (const double aspect : {0.5, 1.0, 2.0}) {
            const auto corners = cornersOf(kBox);
            const Camera camera = frameInParallel(corners, standardBasis(from), 30, aspect);
            const auto axes = basis(camera);
            ASSERT_TRUE(axes.ok());
            glm::dvec2 most(0.0);
            for (const glm::dvec3& corner : corners) {
                const glm::dvec3 v = corner - camera.targetMm;
                most = glm::max(most, glm::abs(glm::dvec2(glm::dot(v, axes->right), glm::dot(v, axes->up))));
            }
            const double half = 0.5 * camera.parallelHeightMm;
            EXPECT_NEAR(std::max(most.x / (half * aspect), most.y / half), kFittedPart, 1e-9);
            EXPECT_EQ(standingBefore(camera, kBox).targetMm, camera.targetMm);
        }
    }
    const glm::dvec3 point(3, -4, 5);
    const Camera one = frameInParallel(std::span(&point, 1), standardBasis(ViewDirection::left), 30, 1.5);
    EXPECT_TRUE(basis(one).ok());
    EXPECT_EQ(one.targetMm, point);
}

TEST(Camera, RefusesParallelPicturesThatAreNone) {
    for (const double wrong : {-300.0, 1e-5, 1e8, std::nan(""), double(INFINITY)}) {
        Camera camera;
        camera.parallelHeightMm = wrong;
        EXPECT_FALSE(basis(camera).ok()) << wrong;
    }
}

}  // namespace
}  // namespace macula
