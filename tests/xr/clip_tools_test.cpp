// Knife, ball and box in a hand: what they remove, in mm of the patient, and when.
#include "xr/clip_tools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "xr/comfort.h"
#include "xr/placement.h"

namespace macula::xr {
namespace {

const Box kSeen{{-100, -100, -100}, {100, 100, 100}};
const glm::dmat4 kPlaced = stageFromWorldBefore({{0, 1.6, 0}, {1, 0, 0, 0}}, kSeen);

Hand at(const glm::dvec3& positionM, float trigger) {
    Hand hand;
    hand.grip = Pose{positionM, {1, 0, 0, 0}};
    hand.trigger = trigger;
    return hand;
}

TEST(ClipTools, TheKnifeIsAPlaneThroughTheHand) {
    const Pose hand{{0.02, 1.5, -0.5}, glm::angleAxis(glm::radians(30.0), glm::dvec3(0, 0, 1))};
    const auto clip = withTool(nullptr, ClipTool::knife, hand, kPlaced);
    ASSERT_TRUE(clip);
    ASSERT_TRUE(validate(*clip).ok());
    ASSERT_EQ(clip->planes.size(), 1u);
    const glm::dmat4 worldFromStage = glm::inverse(kPlaced);
    // The plane goes through the hand, and 10 mm to its right is 10 mm beyond.
    const glm::dvec3 right = hand.orientation * glm::dvec3(1, 0, 0);
    const auto beyondMm = [&](double metres) {
        const glm::dvec3 mm = transformPoint(worldFromStage, hand.positionM + metres * right);
        return glm::dot(clip->planes[0].normal, mm) - clip->planes[0].offsetMm;
    };
    EXPECT_NEAR(beyondMm(0.0), 0.0, 1e-9);
    EXPECT_NEAR(beyondMm(0.01), -10.0, 1e-9);
    EXPECT_NEAR(beyondMm(-0.01), 10.0, 1e-9);
}

TEST(ClipTools, ThereAreSixCutsAndNoMore) {
    Clip clip;
    for (std::size_t i = 0; i < Clip::kMostPlanes; ++i) {
        const auto next =
            withTool(&clip, ClipTool::knife, {{0.01 * double(i), 1.5, -0.5}, {1, 0, 0, 0}}, kPlaced);
        ASSERT_TRUE(next) << i;
        clip = *next;
    }
    EXPECT_FALSE(withTool(&clip, ClipTool::knife, {{0.5, 1.5, -0.5}, {1, 0, 0, 0}}, kPlaced));
    EXPECT_FALSE(withTool(nullptr, ClipTool::none, {{0.5, 1.5, -0.5}, {1, 0, 0, 0}}, kPlaced));
}

TEST(ClipTools, ABallHasItsSizeInTheRoom) {
    const glm::dmat4 twice = scaledAbout(kPlaced, {0.0, 1.6, -0.5}, 2.0);
    const Pose hand{{0.0, 1.6, -0.4}, {1, 0, 0, 0}};
    Clip before;
    before.ball = Ball{.centreMm = {1, 2, 3}, .radiusMm = 4.0};
    const auto clip = withTool(&before, ClipTool{"ball"}, hand, twice);
    ASSERT_TRUE(clip && clip->ball);
    EXPECT_EQ(clip->ofBall, Keep::outside);
    EXPECT_NEAR(clip->ball->radiusMm, 30.0, 1e-9) << "6 cm of the room, at twice the size";
    const glm::dvec3 centreM = transformPoint(twice, clip->ball->centreMm);
    EXPECT_NEAR(glm::distance(centreM, glm::dvec3(0.0, 1.6, -0.5)), 0.0, 1e-9) << "10 cm ahead of the hand";
}

TEST(ClipTools, ABoxLiesAlongThePatient) {
    const Pose hand{{0.0, 1.6, -0.4}, glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, 2, 3)))};
    const auto clip = withTool(nullptr, ClipTool{"box"}, hand, kPlaced);
    ASSERT_TRUE(clip && clip->box);
    ASSERT_TRUE(validate(*clip).ok());
    EXPECT_EQ(clip->ofBox, Keep::outside);
    EXPECT_EQ(clip->box->axes, glm::dmat3(1.0));
    EXPECT_NEAR(clip->box->halfSizeMm.x, 60.0, 1e-9);
    // Its outline has the six faces of just that box: middle and normal of each.
    for (const OutlinePart& face : outlineOf(ClipTool{"box"}, hand, {0, 1.6, 0}, kPlaced)) {
        const glm::dvec3 middleMm = transformPoint(glm::inverse(kPlaced), face.pose.positionM);
        const glm::dvec3 normal = glm::normalize(
            transformVector(glm::inverse(kPlaced), face.pose.orientation * glm::dvec3(0, 0, 1)));
        EXPECT_NEAR(glm::distance(middleMm, clip->box->centreMm + 60.0 * normal), 0.0, 1e-6);
        EXPECT_NEAR(std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}), 1.0, 1e-9);
    }
    EXPECT_EQ(outlineOf(ClipTool{"box"}, hand, {0, 1.6, 0}, kPlaced).size(), 6u);
    EXPECT_TRUE(outlineOf(ClipTool::none, hand, {0, 1.6, 0}, kPlaced).empty());
}

TEST(ClipTools, TheRingOfABallFacesTheEyes) {
    const Pose hand{{0.2, 1.4, -0.4}, {1, 0, 0, 0}};
    for (const glm::dvec3 head :
         {glm::dvec3(0, 1.6, 0), glm::dvec3(0.2, 3.0, -0.5), glm::dvec3(0.2, 1.4, -0.5)}) {
        const auto ring = outlineOf(ClipTool{"ball"}, hand, head, kPlaced);
        ASSERT_EQ(ring.size(), 1u);
        EXPECT_TRUE(ring[0].isRound);
        EXPECT_NEAR(glm::length(ring[0].pose.orientation), 1.0, 1e-9);
        const glm::dvec3 towards = head - ring[0].pose.positionM;
        if (glm::length(towards) < 1e-6) continue;  // the eyes are in its middle
        EXPECT_NEAR(glm::dot(ring[0].pose.orientation * glm::dvec3(0, 0, 1), glm::normalize(towards)), 1.0,
                    1e-9);
    }
}

TEST(HeldTool, StaysCutOnceWhenTheTriggerIsLetGo) {
    HeldTool tool;
    using Event = HeldTool::Event;
    EXPECT_EQ(tool.follow(0.0, at({0, 1.6, -0.5}, 0.0f)), Event::nothing);
    EXPECT_EQ(tool.follow(0.1, at({0, 1.6, -0.5}, 0.9f)), Event::begun);
    EXPECT_EQ(tool.follow(0.2, at({0, 1.6, -0.5}, 0.5f)), Event::nothing) << "it is still held";
    EXPECT_EQ(tool.follow(0.4, at({0, 1.6, -0.5}, 0.5f)), Event::rested);
    EXPECT_EQ(tool.follow(0.8, at({0, 1.6, -0.5}, 0.5f)), Event::nothing) << "once";
    EXPECT_EQ(tool.follow(0.9, at({0.1, 1.6, -0.5}, 0.5f)), Event::nothing) << "it moves";
    EXPECT_EQ(tool.follow(1.2, at({0.1, 1.6, -0.5}, 0.5f)), Event::rested);
    EXPECT_EQ(tool.follow(1.3, at({0.1, 1.6, -0.5}, 0.1f)), Event::letGo);
    EXPECT_EQ(tool.follow(1.4, at({0.1, 1.6, -0.5}, 0.0f)), Event::nothing);
}

TEST(HeldTool, AHandThatIsLostDoesNotCutWhereNobodyKnows) {
    HeldTool tool;
    using Event = HeldTool::Event;
    EXPECT_EQ(tool.follow(0.0, at({0, 1.6, -0.5}, 0.9f)), Event::begun);
    Hand lost = at({0, 0, 0}, 0.9f);
    lost.grip.reset();
    EXPECT_EQ(tool.follow(0.1, lost), Event::abandoned);
    EXPECT_EQ(tool.follow(0.2, at({0, 1.6, -0.5}, 0.0f)), Event::nothing);
    EXPECT_EQ(tool.follow(0.3, at({0, 1.6, -0.5}, std::numeric_limits<float>::quiet_NaN())), Event::nothing);
    tool.waitForRelease();
    EXPECT_EQ(tool.follow(0.4, at({0, 1.6, -0.5}, 1.0f)), Event::nothing)
        << "pulled before, for something else";
    EXPECT_EQ(tool.follow(0.5, at({0, 1.6, -0.5}, 0.0f)), Event::nothing);
    EXPECT_EQ(tool.follow(0.6, at({0, 1.6, -0.5}, 1.0f)), Event::begun);
}

TEST(HeldTool, WhatNobodySawTheEndOfIsNoCut) {
    using Event = HeldTool::Event;
    for (const float trigger : {0.0f, 1.0f}) {
        HeldTool tool;
        EXPECT_EQ(tool.follow(0.0, at({0, 1.6, -0.5}, 1.0f)), Event::begun);
        tool.waitForRelease();
        EXPECT_EQ(tool.follow(5.0, at({0.4, 1.6, -0.5}, trigger)), Event::abandoned) << trigger;
        EXPECT_FALSE(tool.isHeld());
        EXPECT_EQ(tool.follow(5.1, at({0.4, 1.6, -0.5}, 0.0f)), Event::nothing);
        EXPECT_EQ(tool.follow(5.2, at({0.4, 1.6, -0.5}, 1.0f)), Event::begun);
        EXPECT_EQ(tool.follow(5.3, at({0.4, 1.6, -0.5}, 0.0f)), Event::letGo);
    }
}

}  // namespace
}  // namespace macula::xr
