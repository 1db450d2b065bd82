#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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
    for (const auto from : {ViewDirection::anterior, ViewDirection::posterior, ViewDirection::left,
                            ViewDirection::right, ViewDirection::superior, ViewDirection::inferior}) {
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

}  // namespace
}  // namespace macula
