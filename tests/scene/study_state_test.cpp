// A state as a value: what it is written as, and what a change of it makes stale.
#include "scene/state/study_state.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/phantom.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/drawing_of.h"
#include "scene/state/measurements_json.h"
#include "scene/state/slices_json.h"
#include "scene/transfer/own_copy.h"
#include "scene/transfer/same_transfer.h"

namespace macula::scene {
namespace {

using Json = nlohmann::ordered_json;

const Catalogue& catalogue() {
    static const Catalogue all = *builtInCatalogue();
    return all;
}

std::vector<slices::Measurement> oneOfEachKind() {
    const slices::SlicePlane oblique{
        .centreMm = {1.0 / 3.0, -20.0, 30.0}, .right = {0.6, 0.8, 0.0}, .down = {0.0, 0.0, -1.0}};
    return {{.label = "L3, \"höher\"",
             .shape = slices::Distance{{glm::dvec3(0.1, -0.0, 3.0), {4.0, 5.0, 6.0}}},
             .normal = {1.0, 0.0, 0.0}},
            {.shape = slices::Angle{{glm::dvec3(1.0, 2.0, 3.0), {4.0, 5.0, 6.0}, {-7.0, 8.0, 9.0}}},
             .normal = {0.0, -0.6, 0.8}},
            {.label = "liver",
             .shape = slices::Ellipse{.plane = oblique, .radiiMm = {12.5, 1.0 / 7.0}},
             .normal = oblique.normal()},
            {.label = "node",
             .shape = slices::Bidirectional{.firstMm = {{{1.0 / 3.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}},
                                            .secondMm = {{{7.0, 8.0, 9.0}, {-1.0, -2.0, -3.0}}},
                                            .isNode = true}},
            {.shape = slices::Distance{{glm::dvec3(0.0), {1.0, 1.0, 1.0}}}}};
}

// Every field is another than by default.
StudyState everything() {
    StudyState state{.seriesDigest = "0123456789abcdef",
                     .preset = catalogue().presets.at(3),
                     .clip = *catalogue().clips.at(2),
                     .leavesTableOut = true,
                     .lights = catalogue().lights.at(1)};
    state.settings.look = trace::Look::minip;
    state.settings.shading = trace::Shading::none;
    state.settings.filter = trace::Filter::stochastic;
    state.settings.denoising = trace::Denoising::on;
    state.settings.toneMap = trace::ToneMap::hue;
    for (const Parameter& p : parameters()) p.set(state.settings, p.isWhole ? p.high : 0.5 * p.high);
    state.windows.at(std::size_t(trace::Look::minip)) =
        DisplayWindow{.center = -600.5, .width = 1500.0, .explanation = {}, .function = "LINEAR_EXACT"};
    state.camera = Camera{.positionMm = {1.0 / 3.0, -700.0, 12.5},
                          .targetMm = {0.1, 0.2, 0.3},
                          .up = {0.0, 0.0, 1.0},
                          .verticalFovDeg = 42.0,
                          .parallelHeightMm = 1000.0 / 7.0};
    state.showsMarks = false;
    state.background = BackgroundColour(255, 0, 17);
    state.layout = Layout::sagittal;
    state.slices = {
        .window = DisplayWindow{.center = -600.5, .width = 1500.0, .explanation = {}, .function = "SIGMOID"},
        .slab = {.thicknessMm = 7.5, .projection = slices::Projection::minimum},
        .isInverted = true,
        .asAcquired = true,
        .crosshairMm = glm::dvec3(1.0 / 3.0, -2.0, 1e5),
        .turn = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1.0, -2.0, 0.3))),
        .curveMm = {glm::dvec3(0.1, 0.2, 1.0 / 3.0), {-5.0, 6.0, 7.0}},
        .colours = slices::ColourTable::hotIron};
    state.measurements = oneOfEachKind();
    state.cuts.eye = EyeCut{.plane = {.normal = {0.0, 0.6, 0.8}, .offsetMm = -1.0 / 3.0},
                            .fromMiddleMm = 12.5,
                            .followsCamera = true};
    state.cuts.scissors = {{.camera = *state.camera,
                            .outline = {{-0.5, -0.5}, {1.0 / 3.0, -0.5}, {0.0, 0.7}},
                            .removesOutside = true}};
    state.namedClips = {{.name = "lungs, \"höher\"", .clip = *catalogue().clips.at(1), .cuts = state.cuts}};
    state.segmentations = {
        {.digest = std::string(64, 'd'),
         .isShown = true,
         .segments = {{.number = 0, .in3d = In3d::hidden},  // of a label map
                      {.number = 7, .isVisible = false, .opacity = 0.25, .in3d = In3d::alone}}}};
    state.grid =
        SavedGrid{.size = {512, 511, 95},
                  .worldFromVoxel = affine({0.7, 0, 0}, {0, 0.7, 0}, {0, 1.0 / 3.0, 2}, {-179, -171, 4})};
    SecondVolumeState beside;
    beside.seriesDigest = "fedcba";
    beside.volume = 2;
    beside.volumeKey = "abcdef-2";
    beside.pair = "abc123";
    beside.rivalMm = 30.0;
    beside.link = SecondVolumeLink::registered;
    beside.secondFromStudy = affine({0.6, 0.8, 0.0}, {-0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}, {1.0 / 3.0, 7, -80});
    beside.boundMm = 0.7;
    beside.isDoubtful = true;
    beside.view = SecondVolumePlace::over;
    beside.linksWindow = true;
    beside.window = DisplayWindow{.center = 4.0, .width = 8.0, .explanation = {}, .function = "LINEAR_EXACT"};
    beside.opacity = 0.3;
    beside.colours = slices::ColourTable::green;
    beside.in3d = true;
    beside.preset = state.preset;
    state.secondVolume = beside;
    return state;
}

StudyState read(const std::string& text) {
    auto state = studyStateFromJson(text, "view.json");
    EXPECT_TRUE(state.ok()) << (state ? ""
                                      : state.error().message.english() + " " + state.error().hint.english());
    return state ? *std::move(state) : StudyState{};
}

std::string whyNot(const std::string& text) {
    const auto state = studyStateFromJson(text, "view.json");
    if (state) return {};
    EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(state.error().where, "view.json");
    return state.error().message.english() + " " + state.error().hint.english();
}

TEST(StudyState, ComesBackFromItsTextAsItWas) {
    EXPECT_EQ(read(toJson(StudyState{})), StudyState{});
    const StudyState state = everything();
    EXPECT_EQ(read(toJson(state)), state);
    EXPECT_EQ(toJson(read(toJson(state))), toJson(state));
}

TEST(SavedGrid, IsOfVoxelsInTheirPlaces) {
    const auto volumeAt = [](const glm::dmat4& worldFromVoxel, const glm::ivec3& size = {8, 7, 6}) {
        return *Volume::create({.size = size, .worldFromVoxel = worldFromVoxel},
                               std::vector<std::uint16_t>(std::size_t(size.x * size.y * size.z)));
    };
    const auto gridAt = [](double x, double z) {
        return affine({0.7, 0, 0}, {0, 0.7, 0}, {0, 0, z}, {x, 20, 30});
    };
    const SavedGrid saved = savedGridOf(volumeAt(gridAt(10.0, 2.0)));
    EXPECT_TRUE(liesAt(volumeAt(gridAt(10.0, 2.0)), saved));
    EXPECT_TRUE(liesAt(volumeAt(gridAt(10.0 + 1e-7, 2.0)), saved)) << "other digits";
    EXPECT_FALSE(liesAt(volumeAt(gridAt(10.5, 2.0)), saved));
    EXPECT_FALSE(liesAt(volumeAt(gridAt(10.0, 2.1)), saved)) << "the last slice is elsewhere";
    EXPECT_FALSE(liesAt(volumeAt(gridAt(10.0, 2.0), {8, 7, 5}), saved));
}

TEST(StudyState, IsAnotherWhenOneThingOfTheSlicesIs) {
    const auto differs = [](const std::function<void(StudyState&)>& change) {
        StudyState state = everything();
        change(state);
        return !(state == everything());
    };
    EXPECT_FALSE(differs([](auto&) {}));
    EXPECT_TRUE(differs([](auto& s) { s.layout = Layout::axial; }));
    EXPECT_TRUE(differs([](auto& s) { s.slices.window.reset(); }));
    EXPECT_TRUE(differs([](auto& s) { s.slices.slab.thicknessMm = 8.0; }));
    EXPECT_TRUE(differs([](auto& s) { s.showsMarks = true; }));
    EXPECT_TRUE(differs([](auto& s) { s.background->b = 16; }));
    EXPECT_TRUE(differs([](auto& s) { s.background.reset(); }));
    EXPECT_TRUE(differs([](auto& s) { s.camera->parallelHeightMm = 0.0; }));
    EXPECT_TRUE(differs([](auto& s) { s.slices.isInverted = false; }));
    EXPECT_TRUE(differs([](auto& s) { s.slices.asAcquired = false; }));
    EXPECT_TRUE(differs([](auto& s) { s.slices.crosshairMm->x += 1e-9; }));
    EXPECT_TRUE(differs([](auto& s) { s.slices.turn->x += 1e-9; }));
    EXPECT_TRUE(differs([](auto& s) { s.slices.curveMm.pop_back(); }));
    EXPECT_TRUE(differs([](auto& s) { s.slices.colours.reset(); }));
    EXPECT_TRUE(differs([](auto& s) { s.measurements[0].label = "L4"; }));
    EXPECT_TRUE(differs([](auto& s) { s.measurements[1].normal = {0.0, 0.0, 1.0}; }));
    EXPECT_TRUE(differs([](auto& s) { s.measurements[2].shape = slices::Distance{}; }));
    EXPECT_TRUE(differs([](auto& s) { s.measurements.pop_back(); }));
    EXPECT_TRUE(differs([](auto& s) { s.cuts.eye->followsCamera = false; }));
    EXPECT_TRUE(differs([](auto& s) {
        std::vector<glm::dvec2> points = s.cuts.scissors[0].outline;
        points[1].x += 1e-9;
        s.cuts.scissors[0].outline = points;
    }));
    EXPECT_TRUE(differs([](auto& s) { s.namedClips[0].name = "lung"; }));
    EXPECT_TRUE(differs([](auto& s) { s.segmentations[0].isShown = false; }));
    EXPECT_TRUE(differs([](auto& s) { s.segmentations[0].segments[1].in3d = In3d::hidden; }));
    EXPECT_TRUE(differs([](auto& s) { s.secondVolume.reset(); }));
    EXPECT_TRUE(differs([](auto& s) { s.secondVolume->opacity = 0.4; }));
    EXPECT_TRUE(differs([](auto& s) { s.secondVolume->in3d = false; }));
    EXPECT_TRUE(differs([](auto& s) { s.secondVolume->preset.reset(); }));
    EXPECT_TRUE(differs([](auto& s) { s.segmentations[0].segments[0].isColouredIn3d = true; }));
    EXPECT_TRUE(differs([](auto& s) { s.segmentations[0].segments[0].opacityIn3d = 0.5; }));
    EXPECT_TRUE(differs([](auto& s) { s.secondVolume->secondFromStudy[3][0] += 1e-6; }));
}

TEST(StudyState, WritesTheKeysThatItSaysItHas) {
    std::vector<std::string> written;
    const Json all = Json::parse(toJson(everything()));
    for (const auto& [key, value] : all.items()) written.push_back(key);
    std::vector<std::string> said = stateKeys();
    std::ranges::sort(written);
    std::ranges::sort(said);
    EXPECT_EQ(written, said);
}

TEST(StudyState, SlicesAreWrittenWhereTheyAreNotAsByDefault) {
    const Json usual = Json::parse(toJson(StudyState{}));
    for (const char* key : {"layout", "slices", "measurements", "beside"})
        EXPECT_FALSE(usual.contains(key)) << key;
    for (const Layout layout : kLayouts) EXPECT_EQ(read(toJson(StudyState{.layout = layout})).layout, layout);

    StudyState state;
    state.slices.slab = {.thicknessMm = 0.0, .projection = slices::Projection::maximum};
    EXPECT_EQ(read(toJson(state)), state);
    EXPECT_EQ(Json::parse(toJson(state))["slices"].size(), 1u);
    state.slices = {};
    for (const char* function : {"", "LINEAR", "LINEAR_EXACT", "SIGMOID"}) {
        state.slices.window =
            DisplayWindow{.center = 40.0, .width = 400.0, .explanation = {}, .function = function};
        EXPECT_EQ(read(toJson(state)), state) << function;
    }
}

// A mirrored second volume would be taken for the patient.
TEST(StudyState, ASecondVolumeIsTurnedAndMovedAndNothingElse) {
    const auto with = [](const char* transform) {
        return std::string("{\"version\": 1, \"beside\": {\"series\": \"ab\", \"secondFromStudy\": ") +
               transform + "}}";
    };
    EXPECT_EQ(whyNot(with("[1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1]")), "");
    const StudyState state = read(with("[1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1]"));
    ASSERT_TRUE(state.secondVolume);
    EXPECT_FALSE(state.secondVolume->volume) << "as older versions wrote it";
    EXPECT_FALSE(state.secondVolume->in3d || state.secondVolume->preset) << "likewise";
    EXPECT_EQ(glm::dvec3(state.secondVolume->secondFromStudy[3]), glm::dvec3(5.0, 6.0, 7.0)) << "row by row";
    for (const char* broken :
         {"[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]", "[2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]",
          "[1,0,0,0, 0,1,0,0, 0,0,1,0, 1,0,0,1]", "[1,0,0,0, 0,1,0,0, 0,0,1,0]", "\"no\""})
        EXPECT_NE(whyNot(with(broken)).find("secondFromStudy"), std::string::npos) << broken;
    EXPECT_NE(whyNot("{\"version\": 1, \"beside\": {}}"), "");
    for (const char* volume : {"0", "1.5", "-1", "\"2\""})
        EXPECT_NE(whyNot(std::string("{\"version\": 1, \"beside\": {\"series\": \"ab\", \"volume\": ") +
                         volume + "}}"),
                  "");
    EXPECT_NE(whyNot("{\"version\": 1, \"beside\": {\"series\": \"ab\", \"opacity\": 2}}"), "");

    StudyState unreadable;
    unreadable.secondVolume.emplace();
    unreadable.secondVolume->seriesDigest = "ab";
    unreadable.secondVolume->secondFromStudy[0][0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(read(toJson(unreadable)).secondVolume) << "the rest is not lost with it";
}

// Bound and doubt are of a registration; what somebody linked otherwise has none, and comes back from its
// text as it was.
TEST(StudyState, OnlyARegistrationCanBeDoubtful) {
    for (const char* link : {"byHand", "sameFrame", "registered"}) {
        const StudyState state = read(R"({"version": 1, "beside": {"series": "a", "link": ")" +
                                      std::string(link) + R"(", "boundMm": 0.7, "doubtful": true}})");
        ASSERT_TRUE(state.secondVolume);
        const bool isRegistered = state.secondVolume->link == SecondVolumeLink::registered;
        EXPECT_EQ(state.secondVolume->isDoubtful, isRegistered) << link;
        EXPECT_EQ(state.secondVolume->boundMm, isRegistered ? 0.7 : 0.0) << link;
        EXPECT_EQ(read(toJson(state)), state) << link;
    }
}

// Equal states are no step, and are not kept: whatever tells two apart has to be among what is compared.
TEST(StudyState, AnotherPhaseBesideTheStudyIsAnotherState) {
    SecondVolumeState beside;
    beside.seriesDigest = "ab";
    beside.volumeKey = "of one phase";
    SecondVolumeState other = beside;
    EXPECT_EQ(beside, other);
    other.volumeKey = "of another";
    EXPECT_NE(beside, other);
}

// A text that cannot be read would lose all that is in it.
TEST(StudyState, WhatCannotBeReadIsNotWritten) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    StudyState state{.seriesDigest = "0123456789abcdef"};
    const StudyState usual = state;
    for (const double bad : {nan, infinity, -infinity, 1e300}) {
        state.slices = {.window = DisplayWindow{.center = bad}, .crosshairMm = glm::dvec3(0.0, bad, 0.0)};
        state.slices.slab.thicknessMm = bad;
        state.slices.turn = glm::dquat(bad, 0.0, 0.0, 1.0);
        state.slices.curveMm = {glm::dvec3(0.0), glm::dvec3(0.0, 0.0, bad)};
        const slices::Ellipse good{.radiiMm = {1.0, 1.0}};
        slices::Ellipse wide = good;
        wide.radiiMm.y = bad;
        slices::Ellipse far = good;
        far.plane.centreMm.z = bad;
        state.measurements = {{.shape = slices::Distance{{glm::dvec3(bad, 0.0, 0.0), {}}}},
                              {.shape = wide},
                              {.shape = far},
                              {.shape = good, .normal = {0.0, 0.0, bad}}};
        EXPECT_EQ(read(toJson(state)), usual) << bad;
    }
    // What is no plane; and what is good beside it stays.
    slices::Ellipse skew{.radiiMm = {1.0, 1.0}};
    skew.plane.down = skew.plane.right;
    const slices::Measurement good{.label = "kept", .shape = slices::Distance{}};
    state = usual;
    state.slices.window = DisplayWindow{.center = 0.0, .width = 0.0};
    state.slices.turn = glm::dquat(0.0, 0.0, 0.0, 0.0);
    state.slices.curveMm.assign(kMostCurvePoints + 1, glm::dvec3(0.0));
    state.measurements = {{.shape = skew}, {.shape = slices::Angle{}, .normal = glm::dvec3(0.0)}, good};
    EXPECT_EQ(read(toJson(state)).measurements, std::vector{good});
    EXPECT_EQ(read(toJson(state)).slices, SliceState{});

    // As many and as long as the reader takes.
    state.measurements.assign(kMostMeasurements + 3, good);
    EXPECT_EQ(read(toJson(state)).measurements.size(), kMostMeasurements);
    std::string longLabel;
    for (int i = 0; i < 150; ++i) longLabel += "ß";  // two bytes each
    state.measurements = {{.label = "x" + longLabel}, {.label = std::string(500, '\xff')}};
    const auto labels = read(toJson(state)).measurements;
    ASSERT_EQ(labels.size(), 2u);
    EXPECT_EQ(labels[0].label, ("x" + longLabel).substr(0, 199)) << "cut between two characters";
    EXPECT_LE(labels[1].label.size(), kLongestLabelBytes);
}

TEST(StudyState, DirectionsBecomeUnitVectors) {
    Json json = Json::parse(toJson(everything()));
    Json& ellipse = json["measurements"][2];
    ellipse["right"] = {3.0, 4.0, 0.0};
    ellipse["down"] = {0.0, 0.001, -2.0};
    ellipse["normal"] = {0.0, 0.0, 5.0};
    const StudyState state = read(json.dump());
    const auto isEllipse = [](const slices::Measurement& each) {
        return std::holds_alternative<slices::Ellipse>(each.shape);
    };
    const auto found = std::ranges::find_if(state.measurements, isEllipse);
    ASSERT_NE(found, state.measurements.end());
    EXPECT_EQ(found->normal, glm::dvec3(0.0, 0.0, 1.0));
    const auto& plane = std::get<slices::Ellipse>(found->shape).plane;
    EXPECT_LT(glm::length(plane.right - glm::dvec3(0.6, 0.8, 0.0)), 1e-12);
    EXPECT_NEAR(glm::length(plane.down), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(plane.right, plane.down), 0.0, 1e-12);
    EXPECT_EQ(read(toJson(state)), state) << "and stay so";
}

TEST(StudyState, EveryBuiltInPresetClipAndRigComesBack) {
    for (const auto& preset : catalogue().presets) {
        const StudyState state = read(toJson(StudyState{.preset = preset}));
        ASSERT_TRUE(state.preset) << preset->name;
        EXPECT_TRUE(isSame(*state.preset, *preset)) << preset->name;
    }
    for (const auto& rig : catalogue().lights) {
        const StudyState state = read(toJson(StudyState{.lights = rig}));
        ASSERT_TRUE(state.lights) << rig->name;
        EXPECT_EQ(*state.lights, *rig) << rig->name;
    }
    for (const auto& clip : catalogue().clips) {
        // Low and high of a box are kept as centre and half size: the last bit may differ, and only once.
        const std::string once = toJson(StudyState{.clip = *clip});
        const StudyState state = read(once);
        ASSERT_TRUE(state.clip) << clip->name;
        EXPECT_EQ(toJson(state), once) << clip->name;
        const Volume volume = phantom::make({.size = glm::ivec3(16)});
        const Clip before = clipFor(*clip, volume);
        const Clip after = clipFor(*state.clip, volume);
        ASSERT_EQ(before.planes.size(), after.planes.size());
        for (std::size_t i = 0; i < before.planes.size(); ++i)
            EXPECT_NEAR(before.planes[i].offsetMm, after.planes[i].offsetMm, 1e-9) << clip->name;
        ASSERT_EQ(before.box.has_value(), after.box.has_value());
        if (before.box) {
            EXPECT_LT(glm::length(before.box->halfSizeMm - after.box->halfSizeMm), 1e-9);
        }
        EXPECT_EQ(before.cut, after.cut) << clip->name;
        EXPECT_EQ(before.ball, after.ball) << clip->name;
        EXPECT_EQ(before.greyFaces, after.greyFaces) << clip->name;
        EXPECT_EQ(before.facesBelowWindowAreBlack, after.facesBelowWindowAreBlack) << clip->name;
    }
}

TEST(StudyState, KeepsWhatANewerMaculaHasWritten) {
    Json json = Json::parse(toJson(everything()));
    json["bookmarks"] = {{{"name", "lesion"}}};
    const StudyState state = read(json.dump());
    EXPECT_EQ(Json::parse(toJson(state)).at("bookmarks"), json["bookmarks"]);
    EXPECT_FALSE(state == everything());
    // Also when something else is changed meanwhile.
    StudyState changed = state;
    changed.settings.exposure = 2.0;
    EXPECT_EQ(Json::parse(toJson(read(toJson(changed)))).at("bookmarks"), json["bookmarks"]);
}

TEST(StudyState, SaysWhatIsWrongWithAText) {
    EXPECT_NE(whyNot("not JSON"), "");
    EXPECT_NE(whyNot("[]"), "");
    EXPECT_NE(whyNot("{}").find("version"), std::string::npos);
    EXPECT_NE(whyNot(R"({"version": 2})").find("newer"), std::string::npos);
    EXPECT_NE(whyNot(R"({"version": 1, "look": "oil"})").find("\"cinematic\""), std::string::npos);
    EXPECT_NE(whyNot(R"({"version": 1, "bounces": 2.5})").find("whole"), std::string::npos);
    EXPECT_NE(whyNot(R"({"version": 1, "bounces": 0})").find("bounces"), std::string::npos);
    EXPECT_NE(whyNot(R"({"version": 1, "exposure": 1e999})"), "");
    EXPECT_NE(whyNot(R"({"version": 1, "windows": {"mip": {"center": 0, "width": 0}}})").find("width"),
              std::string::npos);
    EXPECT_NE(whyNot(R"({"version": 1, "preset": {}})"), "");
    EXPECT_NE(whyNot(R"({"version": 1, "clip": 7})"), "");
    // An eye that stands in its target is no camera.
    Json json = Json::parse(toJson(everything()));
    json["camera"]["positionMm"] = json["camera"]["targetMm"];
    EXPECT_NE(whyNot(json.dump()).find("camera"), std::string::npos);
}

TEST(StudyState, SaysWhatIsWrongWithSlicesAndMeasurements) {
    const auto why = [](const std::function<void(Json&)>& spoil) {
        Json json = Json::parse(toJson(everything()));
        spoil(json);
        return whyNot(json.dump());
    };
    const auto tells = [&](const std::string& words, const std::function<void(Json&)>& spoil) {
        const std::string told = why(spoil);
        EXPECT_NE(told.find(words), std::string::npos) << "told: " << told << ", expected: " << words;
    };
    EXPECT_EQ(why([](Json&) {}), "");
    tells("\"fourPanes\"", [](Json& j) { j["layout"] = "sixPanes"; });
    tells("layout", [](Json& j) { j["layout"] = 3; });
    tells("slices", [](Json& j) { j["slices"] = "all"; });
    tells("slices.zoom is unknown", [](Json& j) { j["slices"]["zoom"] = 2; });
    tells("slices.window.width", [](Json& j) { j["slices"]["window"]["width"] = 0; });
    tells("slices.window.center", [](Json& j) { j["slices"]["window"].erase("center"); });
    tells("\"SIGMOID\"", [](Json& j) { j["slices"]["window"]["function"] = "CUBIC"; });
    tells("slices.window.name is unknown", [](Json& j) { j["slices"]["window"]["name"] = "LUNG"; });
    tells("slices.slab.thicknessMm", [](Json& j) { j["slices"]["slab"]["thicknessMm"] = -1.0; });
    tells("slices.slab.thicknessMm", [](Json& j) { j["slices"]["slab"]["thicknessMm"] = 2e4; });
    tells("\"maximum\"", [](Json& j) { j["slices"]["slab"]["projection"] = "median"; });
    tells("slices.inverted", [](Json& j) { j["slices"]["inverted"] = 1; });
    tells("slices.asAcquired", [](Json& j) { j["slices"]["asAcquired"] = "yes"; });
    tells("a list of 3", [](Json& j) { j["slices"]["crosshairMm"] = {1.0, 2.0}; });
    tells("slices.turn", [](Json& j) { j["slices"]["turn"] = {0.0, 0.0, 0.0, 0.0}; });
    tells("slices.turn", [](Json& j) { j["slices"]["turn"] = {2.0, 0.0, 0.0, 0.0}; });
    tells("slices.curveMm", [](Json& j) { j["slices"]["curveMm"] = {{1.0, 2.0}}; });
    tells("\"hotIron\"", [](Json& j) { j["slices"]["colours"] = "rainbow"; });
    tells("slices.crosshairMm[1]", [](Json& j) { j["slices"]["crosshairMm"] = {1.0, 1e7, 2.0}; });

    tells("a list of 0 to 1000", [](Json& j) { j["measurements"] = Json::object(); });
    tells("a list of 0 to 1000", [](Json& j) {
        const Json one = j["measurements"][0];
        j["measurements"] = Json::array();
        for (std::size_t i = 0; i <= kMostMeasurements; ++i) j["measurements"].push_back(one);
    });
    tells("measurements[1]", [](Json& j) { j["measurements"][1] = 7; });
    tells("\"ellipse\"", [](Json& j) { j["measurements"][0]["kind"] = "volume"; });
    tells("measurements[0].kind", [](Json& j) { j["measurements"][0].erase("kind"); });
    tells("measurements[0].by is unknown", [](Json& j) { j["measurements"][0]["by"] = "me"; });
    tells("a text in quotes", [](Json& j) { j["measurements"][0]["label"] = 5; });
    tells("200", [](Json& j) { j["measurements"][0]["label"] = std::string(201, 'a'); });
    tells("a list of 2", [](Json& j) { j["measurements"][0]["pointsMm"].push_back({1.0, 2.0, 3.0}); });
    tells("a list of 3", [](Json& j) { j["measurements"][0]["pointsMm"][0] = {1.0, 2.0}; });
    tells("pointsMm[0][2]", [](Json& j) { j["measurements"][0]["pointsMm"][0] = {1.0, 2.0, "3"}; });
    tells("pointsMm[0][2]", [](Json& j) { j["measurements"][0]["pointsMm"][0] = {1.0, 2.0, -1e7}; });
    tells("measurements[1].pointsMm", [](Json& j) { j["measurements"][1].erase("pointsMm"); });
    tells("all zeros", [](Json& j) { j["measurements"][0]["normal"] = {0.0, 0.0, 0.0}; });
    tells("measurements[2].pointsMm", [](Json& j) { j["measurements"][2]["pointsMm"] = {}; });
    tells("measurements[2].centreMm", [](Json& j) { j["measurements"][2]["centreMm"] = nullptr; });
    tells("perpendicular", [](Json& j) { j["measurements"][2]["down"] = {1.0, 0.0, -1.0}; });
    tells("all zeros", [](Json& j) { j["measurements"][2]["right"] = {0.0, 0.0, 0.0}; });
    tells("radiiMm[1]", [](Json& j) { j["measurements"][2]["radiiMm"] = {1.0, -1.0}; });
}

TEST(StudyState, AChangeMakesNoMoreStaleThanItMust) {
    const StudyState before = everything();
    const auto after = [&](const std::function<void(StudyState&)>& change) {
        StudyState state = before;
        change(state);
        return staleAfter(before, state);
    };
    EXPECT_EQ(staleAfter(before, before), Stale::nothing);
    // Another pointer to the same preset is the same preset.
    EXPECT_EQ(after([](auto& s) { s.preset = std::make_shared<const TransferFunction>(*s.preset); }),
              Stale::nothing);
    EXPECT_EQ(after([](auto& s) { s.settings.seed = 7; }), Stale::nothing);
    // Slices are not in the picture in 3D.
    EXPECT_EQ(after([](auto& s) { s.layout = Layout::volume; }), Stale::nothing);
    EXPECT_EQ(after([](auto& s) { s.slices = {}; }), Stale::nothing);
    EXPECT_EQ(after([](auto& s) { s.measurements.clear(); }), Stale::nothing);
    EXPECT_EQ(after([](auto& s) { s.settings.exposure = 2.0; }), Stale::display);
    EXPECT_EQ(after([](auto& s) { s.settings.toneMap = trace::ToneMap::neutral; }), Stale::display);
    EXPECT_EQ(after([](auto& s) { s.windows = {}; }), Stale::display);
    EXPECT_EQ(after([](auto& s) { s.background.reset(); }), Stale::display);
    EXPECT_EQ(after([](auto& s) { s.camera->verticalFovDeg = 20.0; }), Stale::camera);
    EXPECT_EQ(after([](auto& s) { s.settings.bounces = 3; }), Stale::light);
    EXPECT_EQ(after([](auto& s) { s.settings.look = trace::Look::clear; }), Stale::light);
    EXPECT_EQ(after([](auto& s) { s.lights = nullptr; }), Stale::light);
    EXPECT_EQ(after([](auto& s) { s.preset = catalogue().presets.at(4); }), Stale::matter);
    EXPECT_EQ(after([](auto& s) { s.clip.reset(); }), Stale::matter);
    EXPECT_EQ(after([](auto& s) { s.leavesTableOut = false; }), Stale::matter);
    EXPECT_EQ(after([](auto& s) { s.cuts.eye.reset(); }), Stale::matter);
    EXPECT_EQ(after([](auto& s) { s.cuts.scissors.clear(); }), Stale::matter);
    EXPECT_EQ(after([](auto& s) { s.namedClips.clear(); }), Stale::nothing);
    EXPECT_EQ(after([](auto& s) { s.seriesDigest = "another"; }), Stale::volume);
    // The most of all that changed.
    EXPECT_EQ(after([](auto& s) {
                  s.settings.exposure = 2.0;
                  s.clip.reset();
              }),
              Stale::matter);
}

TEST(DrawingOf, TakesWhatIsNotChosenFromCatalogueAndSeriesAndSaysWhatIsHidden) {
    const auto volume = std::make_shared<const Volume>(phantom::make({.size = glm::ivec3(16)}));
    const SeriesWindows windows;
    StudyState state{.preset = presetFor(catalogue(), *volume)};
    Drawing drawing = drawingOf(state, catalogue(), windows, volume, nullptr);
    EXPECT_EQ(drawing.lights->name, "studio");
    EXPECT_EQ(drawing.remarks, "");
    EXPECT_EQ(drawing.settings.shading, trace::Shading::none) << "light paths have lights";

    state.settings.look = trace::Look::clear;
    EXPECT_EQ(drawingOf(state, catalogue(), windows, volume, nullptr).lights->name, "even");
    state.lights = catalogue().lights.at(0);
    EXPECT_EQ(drawingOf(state, catalogue(), windows, volume, nullptr).lights, state.lights);

    state.settings.look = trace::Look::average;
    EXPECT_EQ(drawingOf(state, catalogue(), windows, volume, nullptr).settings.window,
              windows.of(trace::Look::average, *volume));
    state.windows.at(std::size_t(trace::Look::average)) =
        DisplayWindow{.center = 40.0, .width = 400.0, .explanation = {}, .function = {}};
    state.clip = *catalogue().clips.at(0);
    const auto clip = clipOf(state, *volume, std::nullopt);
    ASSERT_TRUE(clip);
    drawing = drawingOf(state, catalogue(), windows, volume, clip);
    EXPECT_EQ(drawing.remarks, "W 400 L 40 HU, clipped");
    EXPECT_EQ(clipOf(StudyState{}, *volume, std::nullopt), nullptr);
}

TEST(DrawingOf, SaysWhichNumbersAreNotWhatTheyAreByDefault) {
    const auto volume = std::make_shared<const Volume>(phantom::make({.size = glm::ivec3(16)}));
    StudyState state{.preset = presetFor(catalogue(), *volume)};
    state.settings.exposure = 3.0;
    state.settings.lightRotationDeg = -45.0;
    EXPECT_EQ(drawingOf(state, catalogue(), SeriesWindows(), volume, nullptr).remarks,
              "exposure 3, light rotation -45 degrees");
}

TEST(DrawingOf, SaysWhatOfTheMatterSomebodyHasChanged) {
    const auto volume = std::make_shared<const Volume>(phantom::make({.size = glm::ivec3(16)}));
    const auto bone = *findPreset(catalogue(), "cinematic-bone");
    StudyState state{.preset = bone};
    const auto remarks = [&] {
        return drawingOf(state, catalogue(), SeriesWindows(), volume, nullptr).remarks;
    };
    EXPECT_EQ(remarks(), "") << "what a preset has by itself is nothing to be told";
    TransferFunction copy = ownCopy(*bone, {});
    copy.surface.roughness = 0.25;
    copy.anisotropy = -0.5;
    state.preset = std::make_shared<const TransferFunction>(copy);
    EXPECT_EQ(remarks(), "roughness 0.25, anisotropy -0.5");
    state.settings.look = trace::Look::mip;
    EXPECT_EQ(remarks().english().find("roughness"), std::string::npos) << "a projection has no surfaces";
}

}  // namespace
}  // namespace macula::scene
