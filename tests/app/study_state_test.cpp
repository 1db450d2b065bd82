// A state as a value: what it is written as, and what a change of it makes stale.
#include "app/state/study_state.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/choice/catalogue.h"
#include "app/state/drawing_of.h"
#include "base/paths.h"
#include "base/phantom.h"

namespace macula::app {
namespace {

using Json = nlohmann::ordered_json;

const Catalogue& catalogue() {
    static const Catalogue all = *builtInCatalogue();
    return all;
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
    for (const Parameter& p : parameters()) p.set(state.settings, p.isWhole ? p.high : 0.5 * p.high);
    state.windows.at(std::size_t(trace::Look::minip)) =
        DisplayWindow{.center = -600.5, .width = 1500.0, .explanation = {}, .function = "LINEAR_EXACT"};
    state.camera = Camera{.positionMm = {1.0 / 3.0, -700.0, 12.5},
                          .targetMm = {0.1, 0.2, 0.3},
                          .up = {0.0, 0.0, 1.0},
                          .verticalFovDeg = 42.0};
    return state;
}

StudyState read(const std::string& text) {
    auto state = studyStateFromJson(text, "view.json");
    EXPECT_TRUE(state.ok()) << (state ? "" : state.error().message + " " + state.error().hint);
    return state ? *std::move(state) : StudyState{};
}

std::string whyNot(const std::string& text) {
    const auto state = studyStateFromJson(text, "view.json");
    if (state) return {};
    EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(state.error().where, "view.json");
    return state.error().message + " " + state.error().hint;
}

TEST(StudyState, ComesBackFromItsTextAsItWas) {
    EXPECT_EQ(read(toJson(StudyState{})), StudyState{});
    const StudyState state = everything();
    EXPECT_EQ(read(toJson(state)), state);
    EXPECT_EQ(toJson(read(toJson(state))), toJson(state));
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
    EXPECT_EQ(after([](auto& s) { s.settings.exposure = 2.0; }), Stale::display);
    EXPECT_EQ(after([](auto& s) { s.windows = {}; }), Stale::display);
    EXPECT_EQ(after([](auto& s) { s.camera->verticalFovDeg = 20.0; }), Stale::camera);
    EXPECT_EQ(after([](auto& s) { s.settings.bounces = 3; }), Stale::light);
    EXPECT_EQ(after([](auto& s) { s.settings.look = trace::Look::clear; }), Stale::light);
    EXPECT_EQ(after([](auto& s) { s.lights = nullptr; }), Stale::light);
    EXPECT_EQ(after([](auto& s) { s.preset = catalogue().presets.at(4); }), Stale::matter);
    EXPECT_EQ(after([](auto& s) { s.clip.reset(); }), Stale::matter);
    EXPECT_EQ(after([](auto& s) { s.leavesTableOut = false; }), Stale::matter);
    EXPECT_EQ(after([](auto& s) { s.seriesDigest = "another"; }), Stale::volume);
    // The most of all that changed.
    EXPECT_EQ(after([](auto& s) {
                  s.settings.exposure = 2.0;
                  s.clip.reset();
              }),
              Stale::matter);
}

TEST(Parameters, FallBackToWhatTheTracerHasAndTakeWhatTheyAllow) {
    for (const Parameter& p : parameters()) {
        EXPECT_GE(p.fallback(), p.low) << p.id;
        EXPECT_LE(p.fallback(), p.high) << p.id;
        for (const double value : {p.low, p.high}) {
            trace::Settings settings;
            p.set(settings, value);
            EXPECT_EQ(p.get(settings), value) << p.id;
        }
        EXPECT_EQ(&parameter(p.id), &p);
    }
}

TEST(Parameters, AreThoseOfThePage) {
    constexpr std::array kStale{"nothing", "display", "camera", "light", "matter", "volume"};
    std::string table;
    for (const Parameter& p : parameters())
        table += fmt::format("| {} | `{}` | {:g} | {:g} | {:g} |{} | {} | {} |\n", p.id, p.option, p.low,
                             p.high, p.fallback(), p.unit.empty() ? "" : fmt::format(" {}", p.unit), p.does,
                             kStale.at(std::size_t(p.stale)));
    std::ifstream page(test::projectFolder() / "docs/parameters.md");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    EXPECT_NE(text.find(table), std::string::npos) << "docs/parameters.md should say:\n" << table;
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

}  // namespace
}  // namespace macula::app
