// Light rigs that a hand changes.
#include "scene/lights/edited_rig.h"

#include <gtest/gtest.h>

#include <limits>

#include "pipeline/trace/light_rig_json.h"
#include "scene/choice/lights_choice.h"

namespace macula::scene {
namespace {

using trace::LightFrame;
using trace::LightRig;
using trace::SoftLight;

LightRig studio() {
    return *chooseLightRig("studio");
}

// What comes out can be written, and is the same when it is read.
void expectInFile(const Result<LightRig>& rig) {
    ASSERT_TRUE(rig.ok()) << rig.error().message;
    const Result<LightRig> read = trace::lightRigFromJson(toJson(*rig), "test");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(*read, *rig);
    EXPECT_EQ(rig->name, kOwnLightsName);
}

TEST(EditedRig, TakesOneLightForAnother) {
    SoftLight light = studio().lights[1];
    light.azimuthDeg = 12.5;
    const Result<LightRig> rig = withLight(studio(), 1, light);
    expectInFile(rig);
    EXPECT_EQ(rig->lights[1], light);
    EXPECT_EQ(rig->lights[0], studio().lights[0]);
    EXPECT_EQ(withLight(studio(), studio().lights.size(), light).error().code, ErrorCode::usage);
}

TEST(EditedRig, NumbersBeyondTheirRangeAreItsEnds) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double wild : {kNan, kInfinity, -kInfinity, 1e300, -1e300, 5e-324}) {
        const Result<LightRig> rig = withLight(studio(), 0,
                                               {.azimuthDeg = wild,
                                                .elevationDeg = wild,
                                                .angularRadiusDeg = wild,
                                                .colour = glm::dvec3(wild),
                                                .radiance = wild});
        expectInFile(rig);
    }
    EXPECT_EQ(withLight(studio(), 0, {.angularRadiusDeg = 0.0})->lights[0].angularRadiusDeg,
              trace::kLeastLightRadiusDeg);
}

TEST(EditedRig, HoldsAsManyLightsAsAFile) {
    LightRig rig = studio();
    while (rig.lights.size() < trace::kMostLights) rig = *withLightAdded(rig, {});
    expectInFile(rig);
    EXPECT_EQ(withLightAdded(rig, {}).error().code, ErrorCode::usage);
}

TEST(EditedRig, IsNeverBlack) {
    LightRig rig = *withSky(studio(), 0.0);
    EXPECT_EQ(skyOf(rig), 0.0);
    while (rig.lights.size() > 1) rig = *withoutLight(rig, 1);
    EXPECT_EQ(withoutLight(rig, 0).error().code, ErrorCode::usage);
    SoftLight dark = rig.lights[0];
    dark.radiance = 0.0;
    EXPECT_EQ(withLight(rig, 0, dark).error().code, ErrorCode::usage);
    EXPECT_EQ(withoutLight(rig, 1).error().code, ErrorCode::usage);
}

TEST(EditedRig, TheSkyIsTheMeanOverAllDirections) {
    LightRig rig = studio();
    rig.lights.clear();
    EXPECT_NEAR(skyOf(rig), trace::Environment::fromRig(rig).meanLuminance(), 1e-4);
    const Result<LightRig> brighter = withSky(studio(), 2.0);
    expectInFile(brighter);
    EXPECT_NEAR(skyOf(*brighter), 2.0, 1e-12);
    // In the same colours.
    EXPECT_NEAR(brighter->ambientZenith.r / brighter->ambientZenith.b,
                studio().ambientZenith.r / studio().ambientZenith.b, 1e-12);
    EXPECT_NEAR(skyOf(*withSky(*withSky(studio(), 0.0), 0.5)), 0.5, 1e-12);
}

TEST(EditedRig, LightsStayWhereTheyAreWhenTheirFrameChanges) {
    const CameraBasis eye = *basis({.positionMm = {300, -200, 150}, .targetMm = {0, 0, 0}, .up = {0, 0, 1}});
    const LightStand before{LightFrame::patient, eye, 25.0};
    const LightStand after{LightFrame::camera, eye, 25.0};
    const Result<LightRig> rig = keptTo(studio(), LightFrame::camera, before);
    expectInFile(rig);
    EXPECT_EQ(rig->frame, LightFrame::camera);
    for (std::size_t i = 0; i < rig->lights.size(); ++i)
        EXPECT_LT(glm::length(directionTo(rig->lights[i], after) - directionTo(studio().lights[i], before)),
                  1e-9);
}

}  // namespace
}  // namespace macula::scene
