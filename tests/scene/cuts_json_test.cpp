// Cuts and clips under a name as text: what is read is what was written, and what is wrong is told.
#include "scene/state/cuts_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "scene/choice/clip_choice.h"
#include "scene/state/study_state.h"

namespace macula::scene {
namespace {

using Json = nlohmann::ordered_json;

Cuts someCuts() {
    return {
        .eye = EyeCut{.plane = {.normal = {0.0, 0.6, 0.8}, .offsetMm = -1.0 / 3.0},
                      .fromMiddleMm = 12.5,
                      .followsCamera = false},
        .scissors = {{.camera = {.positionMm = {1.0 / 3.0, -700, 12.5}, .targetMm = {0.1, 0.2, 0.3}},
                      .outline = {{-0.5, -0.5}, {1.0 / 3.0, -0.5}, {0.0, 0.7}}},
                     {.camera = {.positionMm = {0, -50, 1}, .parallelHeightMm = 1000.0 / 3.0},
                      .outline = {{0, 0}, {0.5, 0}, {0, 0.5}}},
                     {.camera = {}, .outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .removesOutside = true}}};
}

StudyState someState() {
    StudyState state;
    state.cuts = someCuts();
    state.namedClips = {
        {.name = "nothing"},
        {.name = "left", .clip = *chooseClip("left-half")},
        {.name = "all of it, \"höher\"", .clip = *chooseClip("left-half"), .cuts = someCuts()}};
    return state;
}

StudyState read(const std::string& text) {
    auto state = studyStateFromJson(text, "view.json");
    EXPECT_TRUE(state.ok()) << (state ? ""
                                      : state.error().message.english() + " " + state.error().hint.english());
    return state ? *std::move(state) : StudyState{};
}

TEST(CutsJson, ComesBackFromItsTextAsItWas) {
    const StudyState state = someState();
    EXPECT_EQ(read(toJson(state)), state);
    EXPECT_EQ(toJson(read(toJson(state))), toJson(state));
    const Json usual = Json::parse(toJson(StudyState{}));
    EXPECT_FALSE(usual.contains("cuts"));
    EXPECT_FALSE(usual.contains("namedClips"));
}

TEST(CutsJson, OlderTextsHaveNone) {
    const StudyState state = read(R"({"version": 1, "look": "dvr"})");
    EXPECT_TRUE(state.cuts.isNothing());
    EXPECT_TRUE(state.namedClips.empty());
}

TEST(CutsJson, SaysWhatIsWrong) {
    const Json good = Json::parse(toJson(someState()));
    const auto tells = [&](const std::string& what, const auto& change) {
        Json json = good;
        change(json);
        const auto state = studyStateFromJson(json.dump(), "view.json");
        ASSERT_FALSE(state.ok()) << what;
        EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable);
        EXPECT_EQ(state.error().where, "view.json");
        const std::string told = state.error().message.english() + " " + state.error().hint.english();
        EXPECT_NE(told.find(what), std::string::npos) << told;
    };
    tells("cuts.other is unknown", [](Json& j) { j["cuts"]["other"] = 1; });
    tells("cuts.eye.normal", [](Json& j) { j["cuts"]["eye"]["normal"] = {0.0, 0.0, 0.0}; });
    tells("cuts.eye.offsetMm is missing", [](Json& j) { j["cuts"]["eye"].erase("offsetMm"); });
    tells("cuts.scissors[0].outline", [](Json& j) { j["cuts"]["scissors"][0]["outline"] = {1.0, 2.0}; });
    tells("pairs of numbers", [](Json& j) { j["cuts"]["scissors"][0]["outline"].push_back(1.0); });
    tells("encloses something", [](Json& j) { j["cuts"]["scissors"][1]["outline"] = {0, 0, 1, 0, 2, 0}; });
    tells("cuts.scissors[1].removes", [](Json& j) { j["cuts"]["scissors"][1]["removes"] = "all"; });
    tells("a camera", [](Json& j) {
        j["cuts"]["scissors"][0]["camera"]["positionMm"] = j["cuts"]["scissors"][0]["camera"]["targetMm"];
    });
    tells("namedClips", [](Json& j) { j["namedClips"] = "lungs"; });
    tells("name is missing", [](Json& j) { j["namedClips"][0].erase("name"); });
    tells("name", [](Json& j) { j["namedClips"][0]["name"] = ""; });
    tells("name", [](Json& j) { j["namedClips"][0]["name"] = std::string(201, 'x'); });
    tells("box", [](Json& j) { j["namedClips"][1]["clip"]["box"]["low"] = {2.0, 2.0, 2.0}; });
    tells("an object", [](Json& j) { j["namedClips"][0] = 7; });
}

// A text that cannot be read would lose all that is in it.
TEST(CutsJson, WhatCannotBeReadIsNotWritten) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    StudyState state = someState();
    state.cuts.eye->plane.offsetMm = nan;
    std::vector<glm::dvec2> points = state.cuts.scissors[0].outline;
    points[0].x = nan;
    state.cuts.scissors[0].outline = points;
    state.namedClips[0].name.clear();
    StudyState expected = someState();
    expected.cuts.eye.reset();
    expected.cuts.scissors.erase(expected.cuts.scissors.begin());
    expected.namedClips.erase(expected.namedClips.begin());
    EXPECT_EQ(read(toJson(state)), expected);

    state = {};
    const ScissorCut one = someCuts().scissors[1];
    state.cuts.scissors.assign(kMostScissorCuts + 3, one);
    state.namedClips.assign(kMostNamedClips + 3, NamedClip{.name = std::string(150, 'x') + "\xff\xc3"});
    const StudyState back = read(toJson(state));
    EXPECT_EQ(back.cuts.scissors.size(), kMostScissorCuts);
    EXPECT_EQ(back.namedClips.size(), kMostNamedClips);
    EXPECT_EQ(toJson(read(toJson(back))), toJson(back));
}

}  // namespace
}  // namespace macula::scene
