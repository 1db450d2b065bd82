// A view, said as a presentation state and read again: the same view where Macula's own words are there, and
// what the standard's say of curve, clip, camera, window and shading where they are not.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "base/sha256.h"
#include "pictures/state_request.h"
#include "pipeline/volume/window.h"
#include "presentation_fixture.h"
#include "scene/choice/catalogue.h"
#include "scene/clip/eye_cut.h"
#include "scene/presentation/cropping_clip.h"
#include "scene/presentation/palette_of_transfer.h"
#include "scene/presentation/presentation_file.h"
#include "scene/presentation/presentation_of_state.h"
#include "scene/presentation/state_of_presentation.h"
#include "study/open/found_volumes.h"
#include "study/open/loaded_study.h"
#include "support.h"
#include "synthetic.h"
#include "synthetic_pet.h"

namespace macula::scene {
namespace {

constexpr double kLevels = 3.0 / 65535.0;

TEST_F(APresentation, InMaculasOwnWordsIsTheSameView) {
    state_.seriesDigest = sha256Hex(kSeries);
    state_.clip = clip("corner-open");
    state_.lights = catalogue().lights.at(1);
    state_.leavesTableOut = true;
    state_.cuts.eye = *eyeCut(*state_.camera, 1.5, true, *straight_);
    state_.cuts.scissors = {{.camera = inParallel(*state_.camera), .outline = {{0, 0}, {0.5, 0}, {0, 0.5}}}};
    state_.namedClips = {{.name = "mine", .clip = clip("left-half"), .cuts = state_.cuts}};
    state_.settings.look = trace::Look::cinematic;
    state_.settings.exposure = 1.0 / 3.0;
    state_.camera->positionMm.x += 1.0 / 3.0;
    const PresentedState presented = again(said(*straight_, true), *straight_);
    EXPECT_TRUE(presented.isOwn);
    EXPECT_TRUE(presented.notes.empty());
    EXPECT_EQ(presented.state, state_);
    EXPECT_FALSE(leftOut_.empty()) << "others have neither path tracing nor corners";
}

TEST_F(APresentation, TheCurveIsTheSameAtEachValue) {
    for (const auto& each : catalogue().presets) {
        if (each->fitToVolume) continue;
        const TransferFunction& function = *each;
        const double layerMm = layerMmOf(function);
        const TransferFunction steep = usesSteepCurves(function) ? withCurvesSwapped(function) : function;
        const TransferFunction read = transferOf(paletteOf(function), layerMm);
        ASSERT_TRUE(validate(read).ok()) << function.name;
        const double low = std::floor(function.opacity.front().value);
        const double high = std::ceil(function.opacity.back().value);
        for (double value = low - 50.0; value <= high + 50.0; value += 7.0) {
            // Others get what is halfway between flat and steep matter.
            const double perMm = 0.5 * (extinctionPerMm(function, value) + extinctionPerMm(steep, value));
            EXPECT_NEAR(extinctionPerMm(read, value), perMm, 0.01 * perMm + 1e-4 / layerMm)
                << function.name << " at " << value;
            if (function.albedo != 1.0) continue;
            EXPECT_LT(distance(colourAt(read, value), colourAt(function, value)), 0.01)
                << function.name << " at " << value;
        }
    }
}

TEST_F(APresentation, ACurveOfLinesHasItsPointsAgain) {
    TransferFunction function;
    function.unitDistanceMm = 2.0;
    function.opacity = {{.value = -100.0, .opacity = 0.0}, {.value = 300.0, .opacity = 0.8}};
    function.colour = {{.value = -100.0, .colour = {1.0, 0.0, 0.0}},
                       {.value = 300.0, .colour = {0.0, 1.0, 0.5}}};
    const TransferFunction read = transferOf(paletteOf(function), 2.0);
    EXPECT_EQ(read.opacity.size(), 2u);
    EXPECT_EQ(read.colour.size(), 2u);
    EXPECT_EQ(read.unitDistanceMm, 2.0);
    for (double value = -200.0; value <= 400.0; value += 3.3) {
        EXPECT_NEAR(opacityAt(read, value), opacityAt(function, value), kLevels);
        EXPECT_LT(distance(colourAt(read, value), colourAt(function, value)), kLevels);
    }
    // A step, and a curve of one point.
    function.opacity = {{.value = 0.0, .opacity = 0.0},
                        {.value = 100.0, .opacity = 0.0},
                        {.value = 100.0, .opacity = 1.0},
                        {.value = 200.0, .opacity = 1.0}};
    const TransferFunction stepped = transferOf(paletteOf(function), 2.0);
    EXPECT_EQ(opacityAt(stepped, 98.9), 0.0);
    EXPECT_EQ(opacityAt(stepped, 100.0), 1.0);
    function.opacity = {{.value = 5.0, .opacity = 0.5}};
    function.colour = {{.value = 5.0, .colour = glm::dvec3(0.25)}};
    const TransferFunction flat = transferOf(paletteOf(function), 2.0);
    EXPECT_NEAR(opacityAt(flat, -1e6), 0.5, kLevels);
    EXPECT_NEAR(colourAt(flat, 1e6).g, 0.25, kLevels);
    // Denser matter, whose points are as far apart as values of a PET are.
    function.opacity = {{.value = 0.0, .opacity = 0.0}, {.value = 2.5, .opacity = 0.5}};
    function.density = 3.0;
    EXPECT_NEAR(extinctionPerMm(transferOf(paletteOf(function), layerMmOf(function)), 2.5),
                extinctionPerMm(function, 2.5), 1e-3);
    function.density = 0.0;
    EXPECT_EQ(extinctionPerMm(transferOf(paletteOf(function), layerMmOf(function)), 2.5), 0.0);
}

// Others know one pair of curves.
TEST_F(APresentation, OfFlatAndSteepMatterIsWhatIsHalfwayBetween) {
    TransferFunction function;
    function.unitDistanceMm = 2.0;
    function.opacity = {{.value = 0.0, .opacity = 0.0}, {.value = 300.0, .opacity = 0.6}};
    function.colour = {{.value = 0.0, .colour = {1.0, 0.0, 0.0}}};
    function.steep = {.opacity = {{.value = 100.0, .opacity = 0.2}, {.value = 500.0, .opacity = 0.9}},
                      .colour = {{.value = 0.0, .colour = {0.0, 0.0, 1.0}}},
                      .gradientPerMm = 100.0};
    const TransferFunction read = transferOf(paletteOf(function), layerMmOf(function));
    const TransferFunction steep = withCurvesSwapped(function);
    for (double value = -50.0; value <= 600.0; value += 7.0) {
        const double flat = extinctionPerMm(function, value);
        const double other = extinctionPerMm(steep, value);
        EXPECT_NEAR(extinctionPerMm(read, value), 0.5 * (flat + other), 0.01 * (flat + other)) << value;
        const double red = flat / (flat + other);
        const double linear = std::pow((colourAt(read, value).r + 0.055) / 1.055, 2.4);
        if (red > 0.05) {
            EXPECT_NEAR(linear, red, 0.02) << value;
        }
    }
    // The same opacities, and so the mean of both colours' light.
    function.steep.opacity = function.opacity;
    const glm::dvec3 mean = colourAt(transferOf(paletteOf(function), 2.0), 200.0);
    EXPECT_NEAR(mean.r, 0.735, 0.002);
    EXPECT_NEAR(mean.b, 0.735, 0.002);
}

TEST_F(APresentation, TheCameraIsTheSame) {
    const Camera before = *state_.camera;
    const PresentedState presented = again(said(*straight_, false), *straight_);
    ASSERT_TRUE(presented.state.camera);
    EXPECT_FALSE(presented.isOwn);
    EXPECT_EQ(presented.state.camera->positionMm, before.positionMm);
    EXPECT_EQ(presented.state.camera->targetMm, before.targetMm);
    EXPECT_EQ(presented.state.camera->up, before.up);
    EXPECT_NEAR(presented.state.camera->verticalFovDeg, before.verticalFovDeg, 1e-10);
    EXPECT_TRUE(presented.notes.empty()) << presented.notes.front();
    EXPECT_EQ(presented.state.seriesDigest, sha256Hex(kSeries));
    ASSERT_TRUE(presented.state.preset);
    EXPECT_EQ(presented.state.preset->unit, Unit::hounsfield);
    EXPECT_EQ(presented.state.settings.look, trace::Look::dvr);
}

TEST_F(APresentation, TheCutFromTheEyeIsAPlaneAndTheScissorsAreTold) {
    state_.cuts.eye = *eyeCut(*state_.camera, 1.5, true, *straight_);
    const auto eyeAlone = said(*straight_, false);
    ASSERT_EQ(eyeAlone.presentation.cropping.planes.size(), 1u);
    EXPECT_EQ(eyeAlone.presentation.cropping.planes[0].outward, -state_.cuts.eye->plane.normal);
    EXPECT_TRUE(leftOut_.empty());
    const PresentedState presented = again(eyeAlone, *straight_);
    ASSERT_TRUE(presented.state.clip);
    const Clip after = clipFor(*presented.state.clip, *straight_);
    ASSERT_EQ(after.planes.size(), 1u);
    EXPECT_NEAR(after.planes[0].offsetMm, state_.cuts.eye->plane.offsetMm, 1e-9);
    EXPECT_TRUE(presented.state.cuts.isNothing());
    state_.cuts.scissors = {{.camera = *state_.camera, .outline = {{0, 0}, {0.5, 0}, {0, 0.5}}}};
    said(*straight_, false);
    EXPECT_EQ(leftOut_.size(), 1u);
}

TEST_F(APresentation, WithoutNamesHasNoClipsThatAPersonHasNamed) {
    state_.namedClips = {{.name = "Müller", .clip = clip("left-half"), .cuts = {}}};
    EXPECT_NE(said(*straight_, true).presentation.ownState.find("namedClips"), std::string::npos);
    EXPECT_EQ(said(*straight_, true, true).presentation.ownState.find("namedClips"), std::string::npos);
}

TEST_F(APresentation, AParallelCameraIsTheSame) {
    for (const bool isInside : {false, true}) {
        Camera before = inParallel(frameBox(straight_->worldBox(), ViewDirection::left, 25.0, 1.5));
        if (isInside) before.positionMm = before.targetMm - 0.1 * (before.targetMm - before.positionMm);
        state_.camera = before;
        const dicom::PresentationState read = said(*straight_, false);
        EXPECT_EQ(read.presentation.view.projection, dicom::Projection::orthographic);
        EXPECT_GT(read.presentation.view.field.nearMm, 0.0);
        const PresentedState presented = again(read, *straight_);
        ASSERT_TRUE(presented.state.camera);
        const Camera& after = *presented.state.camera;
        EXPECT_EQ(after.parallelHeightMm, before.parallelHeightMm);
        EXPECT_EQ(after.targetMm, before.targetMm);
        EXPECT_EQ(after.up, before.up);
        // Where it stands too, but for one that stands in the volume: that has no near plane to be said.
        const Camera stands = standingBefore(before, straight_->worldBox());
        EXPECT_EQ(after.positionMm, stands.positionMm);
        EXPECT_EQ(stands.positionMm == before.positionMm, !isInside);
        EXPECT_TRUE(presented.notes.empty()) << presented.notes.front();
    }
}

TEST_F(APresentation, AParallelProjectionHasItsMiddleAndHeight) {
    dicom::PresentationState read = said(*straight_, false);
    read.presentation.view.projection = dicom::Projection::orthographic;
    read.presentation.view.field = {-30.0, 10.0, 25.0, -15.0, 1.0, 5000.0};
    const PresentedState presented = again(read, *straight_);
    const Camera& camera = *presented.state.camera;
    const auto axes = basis(camera);
    ASSERT_TRUE(axes);
    const glm::dvec3& looksAt = read.presentation.view.lookAtMm;
    EXPECT_LT(distance(camera.targetMm, looksAt - 10.0 * axes->right + 5.0 * axes->up), 1e-9);
    EXPECT_LT(
        distance(camera.positionMm, read.presentation.view.positionMm - 10.0 * axes->right + 5.0 * axes->up),
        1e-9);
    EXPECT_EQ(camera.parallelHeightMm, 40.0);
    EXPECT_TRUE(presented.notes.empty()) << presented.notes.front();
    read.presentation.view.field.topMm = 2e6;
    EXPECT_FALSE(stateOf(read, StudyState{}, "a.dcm").ok()) << "higher than a picture can be";
}

TEST_F(APresentation, IsSeenAsWideAsItIsInANarrowerPicture) {
    dicom::PresentationState read = said(*straight_, false);  // for a picture of 3:2
    PresentedState presented = again(read, *straight_);
    EXPECT_NEAR(presented.widthOverHeight, 1.5, 1e-9);
    const double half = std::tan(glm::radians(0.5 * presented.state.camera->verticalFovDeg));
    const Camera before = *presented.state.camera;
    for (const double wideEnough : {1.5, 2.5, 0.0, std::nan("")}) {
        widenFor(presented, wideEnough);
        EXPECT_EQ(*presented.state.camera, before);
    }
    widenFor(presented, 0.75);
    EXPECT_NEAR(std::tan(glm::radians(0.5 * presented.state.camera->verticalFovDeg)), 2.0 * half, 1e-9);
    read.presentation.view.projection = dicom::Projection::orthographic;
    read.presentation.view.field = {-60.0, 60.0, 20.0, -20.0, 1.0, 5000.0};
    presented = again(read, *straight_);
    widenFor(presented, 1.0);
    EXPECT_NEAR(presented.state.camera->parallelHeightMm, 120.0, 1e-9);
    presented = again(said(*straight_, true), *straight_);
    widenFor(presented, 0.1);
    EXPECT_EQ(*presented.state.camera, *state_.camera) << "Macula's own picture";
}

TEST_F(APresentation, TheWindowOfAProjectionIsTheSame) {
    for (const trace::Look look : {trace::Look::mip, trace::Look::minip}) {
        state_.settings.look = look;
        state_.windows.at(std::size_t(look)) =
            DisplayWindow{.center = 300.0, .width = 600.0, .explanation = {}, .function = "LINEAR_EXACT"};
        const PresentedState presented = again(said(*straight_, false), *straight_);
        EXPECT_EQ(presented.state.settings.look, look);
        EXPECT_EQ(presented.state.windows, state_.windows);
        state_.windows = {};
    }
}

TEST_F(APresentation, BoxesAndPlanesAreTheSame) {
    for (const std::string name : {"left-half", "front-open"}) {
        state_.clip = clip(name);
        for (const auto& volume : {straight_, oblique_}) {
            const Clip before = clipFor(*state_.clip, *volume);
            if (before.cut || before.ball || before.ofBox == Keep::outside) continue;
            const PresentedState presented = again(said(*volume, false), *volume);
            ASSERT_TRUE(presented.state.clip) << name;
            const Clip after = clipFor(*presented.state.clip, *volume);
            EXPECT_TRUE(validate(after).ok());
            const Box all = volume->worldBox();
            int shown = 0;
            for (int i = 0; i < 1000; ++i) {
                const glm::dvec3 part(i % 10, i / 10 % 10, i / 100);
                const glm::dvec3 point = all.low + (part + 0.51) / 10.0 * (all.high - all.low);
                EXPECT_EQ(shows(after, point), shows(before, point)) << name << " " << i;
                shown += shows(after, point) ? 1 : 0;
            }
            EXPECT_GT(shown, 100);
            EXPECT_LT(shown, 1000);
        }
    }
}

TEST_F(APresentation, ABoxOfTurnedVoxelsIsAlongThem) {
    const glm::dvec3 last = glm::dvec3(oblique_->size()) - 1.0;
    const auto at = [&](const glm::dvec3& voxel) {
        return transformPoint(oblique_->worldFromVoxel(), voxel);
    };
    dicom::Cropping cropping;
    cropping.boxes = {{at({0.5, -0.5, -0.5}), at(last + 0.5)}};
    const auto read = clipOf(cropping, *oblique_, "a.dcm");
    ASSERT_TRUE(read.ok()) << read.error().message;
    ASSERT_TRUE(*read);
    EXPECT_EQ((*read)->clip.planes.size(), 1u) << "the others cut nothing off";
    const Clip clip = clipFor(**read, *oblique_);
    EXPECT_FALSE(shows(clip, at({0.0, 1.0, 1.0})));
    EXPECT_TRUE(shows(clip, at({1.0, 1.0, 1.0})));
    EXPECT_TRUE(shows(clip, at(last)));

    // An oblique plane of a flat volume, as a text that can be read again.
    dicom::Cropping ofFlat;
    const glm::dvec3 aslant = glm::normalize(glm::dvec3(1.0, 0.0, 1.0));
    auto flat = Volume::create(
        {.size = {40, 40, 1}, .worldFromVoxel = affine({10, 0, 0}, {0, 10, 0}, {0, 0, 1}, {-195, -195, 0})},
        std::vector<std::uint16_t>(1600, 1));
    ASSERT_TRUE(flat.ok());
    ofFlat.planes = {{aslant, 120.0}};
    const auto cut = clipOf(ofFlat, *flat, "a.dcm");
    ASSERT_TRUE(cut.ok() && *cut);
    const auto reread = clipPresetFromJson(toJson(**cut), "a.dcm");
    ASSERT_TRUE(reread.ok()) << reread.error().message;
    EXPECT_NEAR(clipFor(*reread, *flat).planes.at(0).offsetMm, -120.0, 1e-6);

    // All of it, and nothing of it.
    cropping.boxes = {{at({-0.5, -0.5, -0.5}), at(last + 0.5)}};
    const auto whole = clipOf(cropping, *oblique_, {});
    ASSERT_TRUE(whole.ok());
    EXPECT_FALSE(*whole);
    cropping.boxes = {{at({-9.0, -0.5, -0.5}), at({-8.0, 2.0, 2.0})}};
    EXPECT_FALSE(clipOf(cropping, *oblique_, {}).ok());
    cropping.boxes = {{{0, 0, 0}, {-500, -500, -500}}};
    EXPECT_FALSE(clipOf(cropping, *straight_, {}).ok());
    // More planes than there is room for.
    cropping = {};
    const glm::dvec3 middle = straight_->worldBox().centre();
    for (int i = 0; i < 7; ++i) {
        const glm::dvec3 outward = glm::normalize(glm::dvec3(1.0, 0.1 * i, 0.0));
        cropping.planes.push_back({outward, glm::dot(outward, middle)});
    }
    EXPECT_FALSE(clipOf(cropping, *straight_, {}).ok());
}

TEST_F(APresentation, ShadingIsTheSameAndLightIsTold) {
    const PresentedState shaded = again(said(*straight_, false), *straight_);
    EXPECT_EQ(shaded.state.settings.shading, trace::Shading::headlight);
    ASSERT_TRUE(shaded.state.preset);
    EXPECT_EQ(shaded.state.preset->lighting.ambient, state_.preset->lighting.ambient);
    EXPECT_EQ(shaded.state.preset->lighting.diffuse, state_.preset->lighting.diffuse);
    state_.settings.shading = trace::Shading::none;
    EXPECT_EQ(again(said(*straight_, false), *straight_).state.settings.shading, trace::Shading::none);

    // Of lights the strongest, in its direction.
    state_.settings.look = trace::Look::cinematic;
    auto lights = std::make_shared<trace::LightRig>();
    lights->ambientHorizon = lights->ambientZenith = lights->ambientNadir = glm::dvec3(0.1);
    lights->lights = {{.azimuthDeg = 90.0, .elevationDeg = 0.0, .angularRadiusDeg = 20.0, .radiance = 10.0},
                      {.azimuthDeg = 0.0, .elevationDeg = 90.0, .angularRadiusDeg = 20.0, .radiance = 1.0}};
    state_.lights = lights;
    dicom::PresentationState read = said(*straight_, false);
    ASSERT_TRUE(read.presentation.shading);
    EXPECT_LT(distance(read.presentation.shading->lightDirection, {-1.0, 0.0, 0.0}), 1e-12)
        << "from the left";
    EXPECT_GT(read.presentation.shading->diffuse, 0.5);
    EXPECT_NEAR(read.presentation.shading->diffuse + read.presentation.shading->ambient, 1.0, 1e-12);
    state_.settings.lightRotationDeg = 90.0;
    read = said(*straight_, false);
    EXPECT_LT(distance(read.presentation.shading->lightDirection, {0.0, -1.0, 0.0}), 1e-12);
    EXPECT_FALSE(again(read, *straight_).notes.empty()) << "light comes from another side";
    lights = std::make_shared<trace::LightRig>();
    state_.lights = lights;
    EXPECT_EQ(said(*straight_, false).presentation.shading->ambient, 1.0);
}

TEST_F(APresentation, OfAnotherProgramHidesNothingThatIsHiddenNow) {
    const std::string digest(64, 'd');
    StudyState now;
    now.leavesTableOut = true;
    now.segmentations = {{.digest = digest,
                          .isShown = true,
                          .segments = {{.number = 1, .opacity = 0.7, .in3d = In3d::alone},
                                       {.number = 2, .in3d = In3d::hidden}}}};
    const auto foreign = stateOf(said(*straight_, false), now, "a.dcm");
    ASSERT_TRUE(foreign.ok());
    EXPECT_FALSE(foreign->state.leavesTableOut);
    EXPECT_TRUE(in3dOf(foreign->state.segmentations).empty());
    EXPECT_EQ(choiceOf(choiceOf(foreign->state.segmentations, digest), 1).opacity, 0.7) << "on slices";
    // Macula's own words say otherwise.
    state_.leavesTableOut = true;
    state_.segmentations = now.segmentations;
    const auto own = stateOf(said(*straight_, true), StudyState{}, "a.dcm");
    ASSERT_TRUE(own.ok());
    EXPECT_TRUE(own->state.leavesTableOut);
    EXPECT_EQ(own->state.segmentations, now.segmentations);
}

TEST_F(APresentation, OfAnotherSeriesIsRefused) {
    const dicom::PresentationState read = said(*straight_, true);
    auto presented = stateOf(read, StudyState{}, "a.dcm");
    ASSERT_TRUE(presented.ok());
    const auto done = completeFor(*presented, read, *straight_, sha256Hex("2.25.4712"), {}, "a.dcm");
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, ErrorCode::inputNotUsable);
    EXPECT_NE(done.error().message.english().find("another series"), std::string::npos);
}

TEST_F(APresentation, WhatIsNoCameraIsRefused) {
    dicom::PresentationState read = said(*straight_, false);
    read.presentation.view.up = read.presentation.view.lookAtMm - read.presentation.view.positionMm;
    EXPECT_FALSE(stateOf(read, StudyState{}, "a.dcm").ok());
    state_.camera.reset();
    EXPECT_EQ(presentationOf(state_, *straight_, 1.0).error().code, ErrorCode::usage);
    state_.camera = Camera{};
    state_.camera->targetMm = state_.camera->positionMm;
    EXPECT_FALSE(presentationOf(state_, *straight_, 1.0).ok());
    state_.camera = Camera{};
    state_.preset.reset();
    EXPECT_FALSE(presentationOf(state_, *straight_, 1.0).ok());
}

TEST_F(APresentation, DeidentifiedHasNoWordsOfAPerson) {
    TransferFunction named = *state_.preset;
    named.name = "doe-jane";
    named.title = "Doe, Jane";
    named.opacity.front().opacity = 0.5;
    state_.preset = std::make_shared<const TransferFunction>(named);
    state_.secondVolume.emplace();
    state_.secondVolume->seriesDigest = "ab";
    state_.secondVolume->preset = state_.preset;
    state_.clip = clip("left-half");
    state_.clip->name = state_.clip->title = "Doe, Jane";
    state_.otherKeys = R"({"bookmark": "Doe, Jane"})";
    slices::Measurement measurement;
    measurement.label = "Doe, Jane";
    measurement.shape = slices::Distance{{glm::dvec3(0.0), glm::dvec3(10.0, 0.0, 0.0)}};
    state_.measurements = {measurement};
    EXPECT_NE(said(*straight_, true).presentation.ownState.find("Jane"), std::string::npos);
    const dicom::PresentationState read = said(*straight_, true, true);
    EXPECT_EQ(read.presentation.ownState.find("Jane"), std::string::npos);
    EXPECT_EQ(read.presentation.ownState.find("jane"), std::string::npos);
    const PresentedState presented = again(read, *straight_);
    EXPECT_TRUE(presented.isOwn);
    EXPECT_EQ(presented.state.preset->opacity, named.opacity);
    ASSERT_TRUE(presented.state.secondVolume && presented.state.secondVolume->preset);
    EXPECT_EQ(presented.state.secondVolume->preset->opacity, named.opacity);
    EXPECT_EQ(presented.state.clip->clip, state_.clip->clip);
}

// UIDs can be guessed: a digest that anybody can make of one leads to the study.
TEST_F(APresentation, DeidentifiedHasNoDigestsOfUids) {
    state_.seriesDigest = sha256Hex(kSeries);
    state_.secondVolume.emplace().seriesDigest = sha256Hex("1.2.3");
    state_.segmentations = {{.digest = sha256Hex("1.2.4"), .isShown = true}};
    const std::string named = said(*straight_, true).presentation.ownState;
    const std::string ofNobody = said(*straight_, true, true).presentation.ownState;
    EXPECT_FALSE(leftOut_.empty()) << "that they are not found again is told";
    for (const std::string& digest : {sha256Hex(kSeries), sha256Hex("1.2.3"), sha256Hex("1.2.4")}) {
        EXPECT_NE(named.find(digest), std::string::npos) << "with the patient";
        EXPECT_EQ(ofNobody.find(digest), std::string::npos) << digest;
    }
}

}  // namespace
}  // namespace macula::scene
