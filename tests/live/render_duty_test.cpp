// What is owed to the screen, by what happened.
#include "live/frame/render_duty.h"

#include <gtest/gtest.h>

namespace macula::live {
namespace {

using Work = RenderDuty::Work;

Work workOf(const RenderDuty& duty, bool isComplete = true, bool courseGoesOn = true) {
    return duty.work(isComplete, [&] { return courseGoesOn; });
}

TEST(RenderDuty, FollowsTheCourseOnceTheSceneIsApplied) {
    RenderDuty duty;
    duty.otherPicture();
    EXPECT_EQ(workOf(duty), Work::scene);
    duty.appliedScene();
    EXPECT_EQ(workOf(duty), Work::course);
    EXPECT_EQ(workOf(duty, true, false), Work::nothing);
}

TEST(RenderDuty, ABackgroundIsLessThanAnotherPicture) {
    RenderDuty duty;
    duty.otherBackground();
    EXPECT_EQ(workOf(duty), Work::background);
    duty.otherPicture();
    duty.otherBackground();
    EXPECT_EQ(workOf(duty), Work::scene) << "it is drawn over the new one anyway";
    duty.appliedScene();
    EXPECT_EQ(workOf(duty), Work::course);
}

TEST(RenderDuty, WithoutAStudyTheWindowIsClearedOnce) {
    RenderDuty duty;
    duty.otherStudy();
    EXPECT_TRUE(duty.isForeign());
    EXPECT_EQ(workOf(duty, false), Work::clear);
    duty.appliedScene();
    duty.showedOurs();
    EXPECT_FALSE(duty.isForeign());
    EXPECT_EQ(workOf(duty, false), Work::nothing);
}

TEST(RenderDuty, WhatIsPlayedStaysUntilTheNextInput) {
    RenderDuty duty;
    duty.otherPicture();
    duty.played();
    EXPECT_EQ(workOf(duty), Work::nothing);
    duty.otherBackground();
    EXPECT_EQ(workOf(duty), Work::nothing) << "the input with the background follows";
    duty.otherInput();
    EXPECT_EQ(workOf(duty), Work::scene) << "its scene is not on the device";
    duty.appliedScene();
    duty.otherInput();
    EXPECT_EQ(workOf(duty), Work::course);
}

TEST(RenderDuty, AfterAFailureNothingIsDoneUntilSomethingChanges) {
    RenderDuty duty;
    duty.failed();
    EXPECT_TRUE(duty.isForeign());
    EXPECT_EQ(workOf(duty), Work::nothing);
    duty.otherBackground();
    duty.beginAnew();
    EXPECT_EQ(workOf(duty), Work::nothing);
    duty.otherSizeOnly();
    EXPECT_EQ(workOf(duty), Work::scene);
}

TEST(RenderDuty, WhoHasGivenUpDoesNotTryAgainForAnotherSize) {
    RenderDuty duty;
    duty.lostTooOften();
    duty.failed();
    duty.otherSizeOnly();
    EXPECT_TRUE(duty.isHalted());
    duty.otherPicture();
    EXPECT_FALSE(duty.isHalted());
    EXPECT_EQ(workOf(duty), Work::scene);
}

TEST(RenderDuty, ALossThatIsMadeGoodGoesOn) {
    RenderDuty duty;
    duty.failed();
    duty.startedAgain();
    EXPECT_FALSE(duty.isHalted());
}

}  // namespace
}  // namespace macula::live
