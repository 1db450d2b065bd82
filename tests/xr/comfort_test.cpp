// Turns in steps, darkness where the headset is lost, sizes.
#include "xr/comfort.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "xr/placement.h"

namespace macula::xr {
namespace {

const glm::dmat4 kPlaced =
    stageFromWorldBefore({{0, 1.6, 0}, {1, 0, 0, 0}}, {{-100, -100, -100}, {100, 100, 100}});

TwoHands pushed(float left, float right) {
    TwoHands hands;
    hands[0].turn = left;
    hands[1].turn = right;
    return hands;
}

TEST(SnapTurns, APushIsOneStepOf30Degrees) {
    SnapTurns turns;
    EXPECT_EQ(turns.follow(pushed(0.0f, 0.5f)), 0.0);
    EXPECT_EQ(turns.follow(pushed(0.0f, 0.9f)), 30.0);
    EXPECT_EQ(turns.follow(pushed(0.0f, 1.0f)), 0.0) << "it is still pushed";
    EXPECT_EQ(turns.follow(pushed(0.0f, 0.5f)), 0.0) << "and not back";
    EXPECT_EQ(turns.follow(pushed(0.0f, 0.1f)), 0.0);
    EXPECT_EQ(turns.follow(pushed(-0.8f, 0.0f)), -30.0);
    EXPECT_EQ(turns.follow(pushed(0.0f, 0.0f)), 0.0);
    EXPECT_EQ(turns.follow(pushed(std::numeric_limits<float>::quiet_NaN(), 0.0f)), 0.0);
}

TEST(SnapTurns, WhoTurnsToTheRightSeesWhatWasAtTheRightAhead) {
    const Pose head{{0.3, 1.7, -0.2}, glm::angleAxis(glm::radians(-20.0), glm::dvec3(1, 0, 0))};
    const glm::dmat4 after = turnedAround(kPlaced, head, 30.0);
    EXPECT_NEAR(scaleOf(after), 1.0, 1e-9);
    // What was 30 degrees to the right of straight ahead, a metre away and at some height, is straight ahead.
    const glm::dvec3 right(std::sin(glm::radians(30.0)), 0.2, -std::cos(glm::radians(30.0)));
    const glm::dvec3 pointMm = transformPoint(glm::inverse(kPlaced), head.positionM + right);
    EXPECT_NEAR(glm::distance(transformPoint(after, pointMm), head.positionM + glm::dvec3(0.0, 0.2, -1.0)),
                0.0, 1e-9);
    glm::dmat4 around = kPlaced;
    for (int i = 0; i < 12; ++i) around = turnedAround(around, head, kSnapTurnDeg);
    for (int column = 0; column < 4; ++column)
        EXPECT_NEAR(glm::distance(around[column], kPlaced[column]), 0.0, 1e-9)
            << "twelve steps are all around";
}

TEST(Comfort, RealSizeIsAboutAPoint) {
    const glm::dvec3 middleM(0.1, 1.5, -0.6);
    const glm::dmat4 large = scaledAbout(kPlaced, middleM, 3.0);
    EXPECT_NEAR(scaleOf(large), 3.0, 1e-9);
    const glm::dvec3 middleMm = transformPoint(glm::inverse(large), middleM);
    const glm::dmat4 real = scaledAbout(large, middleM, 1.0);
    EXPECT_NEAR(scaleOf(real), 1.0, 1e-9);
    EXPECT_NEAR(glm::distance(transformPoint(real, middleMm), middleM), 0.0, 1e-9);
    EXPECT_NEAR(scaleOf(scaledAbout(kPlaced, middleM, 1000.0)), kMostScale, 1e-9);
}

TEST(Fade, GoesDarkWhileThePlaceIsLostAndComesBack) {
    Fade fade;
    EXPECT_EQ(fade.follow(1.0, true), 1.0);
    EXPECT_NEAR(fade.follow(1.1, false), 1.0 - 0.1 / Fade::kSeconds, 1e-9);
    EXPECT_TRUE(fade.isLost());
    EXPECT_EQ(fade.follow(2.0, false), 0.0);
    EXPECT_NEAR(fade.follow(2.15, true), 0.5, 1e-9);
    EXPECT_FALSE(fade.isLost());
    EXPECT_EQ(fade.follow(3.0, true), 1.0);
    fade.goDark(3.1);
    EXPECT_EQ(fade.light(), 0.0);
    EXPECT_NEAR(fade.follow(3.25, true), 0.5, 1e-9);
    // A new session has its own time.
    EXPECT_NEAR(fade.follow(0.0, true), 0.5, 1e-9);
}

TEST(Fade, AHeadsetThatOnlyTurnsIsNotLost) {
    Fade fade;
    for (int i = 0; i < 50; ++i) EXPECT_EQ(fade.follow(0.1 * i, false), 1.0);
    EXPECT_FALSE(fade.isLost());
}

}  // namespace
}  // namespace macula::xr
