// What hands do from frame to frame.
#include <gtest/gtest.h>

#include "xr/grasp.h"
#include "xr/placement.h"

namespace macula::xr {
namespace {

const glm::dmat4 kPlaced =
    stageFromWorldBefore({{0, 1.6, 0}, {1, 0, 0, 0}}, {{-100, -100, -100}, {100, 100, 100}});

Hand at(const glm::dvec3& positionM, float squeeze, float trigger = 0.0f) {
    return {.grip = Pose{positionM, {1, 0, 0, 0}}, .squeeze = squeeze, .trigger = trigger};
}

glm::dvec3 shiftOf(const glm::dmat4& now) {
    return glm::dvec3(now[3]) - glm::dvec3(kPlaced[3]);
}

TEST(Grasp, OnlyAHandThatSqueezesTakesItAlong) {
    Grasp grasp;
    glm::dmat4 now = grasp.follow(kPlaced, {at({0, 1, 0}, 0.0f), at({0.2, 1, 0}, 0.5f)});
    now = grasp.follow(now, {at({0, 2, 0}, 0.0f), at({0.4, 1, 0}, 0.5f)});
    EXPECT_EQ(now, kPlaced);
    EXPECT_FALSE(grasp.isHolding());
    now = grasp.follow(now, {Hand{}, at({0.4, 1, 0}, 0.7f)});
    EXPECT_EQ(now, kPlaced) << "it is taken where it is";
    now = grasp.follow(now, {Hand{}, at({0.5, 1.2, 0}, 0.5f)});  // still held: it has not clearly let go
    EXPECT_NEAR(glm::distance(shiftOf(now), glm::dvec3(0.1, 0.2, 0.0)), 0.0, 1e-12);
    now = grasp.follow(now, {Hand{}, at({2.0, 1.2, 0}, 0.3f)});
    EXPECT_NEAR(glm::distance(shiftOf(now), glm::dvec3(0.1, 0.2, 0.0)), 0.0, 1e-12) << "let go";
}

TEST(Grasp, NothingJumpsWhenASecondHandComesOrOneIsLost) {
    Grasp grasp;
    glm::dmat4 now = grasp.follow(kPlaced, {at({0, 1, 0}, 1.0f), Hand{}});
    now = grasp.follow(now, {at({0.1, 1, 0}, 1.0f), Hand{}});
    const glm::dmat4 byOne = now;
    now = grasp.follow(now, {at({0.1, 1, 0}, 1.0f), at({0.5, 1, 0}, 1.0f)});
    EXPECT_EQ(now, byOne);
    now = grasp.follow(now, {at({-0.1, 1, 0}, 1.0f), at({0.7, 1, 0}, 1.0f)});
    EXPECT_NEAR(scaleOf(now), 2.0, 1e-9);
    const glm::dmat4 byTwo = now;
    Hand lost = at({0, 0, 0}, 1.0f);
    lost.grip.reset();
    now = grasp.follow(now, {lost, at({0.7, 1, 0}, 1.0f)});
    EXPECT_EQ(now, byTwo);
    now = grasp.follow(now, {lost, at({0.8, 1, 0}, 1.0f)});
    EXPECT_NEAR(scaleOf(now), 2.0, 1e-9);
    EXPECT_NEAR(glm::distance(glm::dvec3(now[3]) - glm::dvec3(byTwo[3]), glm::dvec3(0.1, 0, 0)), 0.0, 1e-9);
}

TEST(Grasp, WhatWasMovedByAnythingElseIsTakenAnew) {
    Grasp grasp;
    glm::dmat4 now = grasp.follow(kPlaced, {Hand{}, at({0, 1, 0}, 1.0f)});
    now = grasp.follow(now, {Hand{}, at({0.1, 1, 0}, 1.0f)});
    now[3] += glm::dvec4(5.0, 0.0, 0.0, 0.0);
    grasp.takeAnew();
    now = grasp.follow(now, {Hand{}, at({0.1, 1, 0}, 1.0f)});
    now = grasp.follow(now, {Hand{}, at({0.3, 1, 0}, 1.0f)});
    EXPECT_NEAR(glm::distance(shiftOf(now), glm::dvec3(5.3, 0.0, 0.0)), 0.0, 1e-12);
}

}  // namespace
}  // namespace macula::xr
