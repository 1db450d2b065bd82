// A view that was saved, with what is given besides: what comes out, and what of it may be told.
#include "pictures/state_wish.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/phantom.h"
#include "pipeline/volume/volume_fit.h"
#include "pipeline/volume/window.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/preset_choice.h"
#include "scene/choice/typed_values.h"
#include "scene/transfer/same_transfer.h"
#include "support.h"

namespace macula::app {
namespace {

const Catalogue& catalogue() {
    static const Catalogue all = *builtInCatalogue();
    return all;
}

StudyInput study() {
    StudyInput input{.volume = std::make_shared<const Volume>(phantom::make({.size = glm::ivec3(16)})),
                     .notes = {},
                     .warnings = {},
                     .seriesDigest = "phantom"};
    bringTo16Bits(input);
    return input;
}

class AWish : public ::testing::Test {
  protected:
    // A view in a projection, of the phantom, and the wish to see it.
    StateWish saved() {
        view_.seriesDigest = "phantom";
        view_.preset = catalogue().presets.at(0);
        view_.clip = *catalogue().clips.at(0);
        view_.lights = catalogue().lights.at(1);
        view_.leavesTableOut = true;
        view_.settings.look = trace::Look::mip;
        view_.settings.exposure = 2.0;
        view_.windows.at(std::size_t(trace::Look::mip)) = *parseWindow("300,600");
        view_.camera = Camera{};
        const std::filesystem::path path = folder_ / "view.json";
        std::ofstream(path) << toJson(view_);
        return {.session = path};
    }
    StudyState stateFor(const StateWish& wish) const {
        const auto state = stateOf(wish);
        EXPECT_TRUE(state.ok()) << (state ? "" : state.error().message);
        return state ? *state : StudyState{};
    }

    const dicom::test::TemporaryFolder folder_;
    StudyState view_;
};

TEST_F(AWish, isWhatIsUsualWhereNothingIsGiven) {
    const StudyState usual{.leavesTableOut = true, .settings = {.bounces = 3}};
    EXPECT_EQ(*stateOf({}, usual), usual);
    EXPECT_EQ(stateFor({}), StudyState{});
}

TEST_F(AWish, isTheViewWhereThatIsGiven) {
    const StateWish wish = saved();
    StudyState state = stateFor(wish);
    EXPECT_EQ(toJson(state), toJson(view_));
    EXPECT_EQ(toJson(*stateOf(wish, {.settings = {.bounces = 3}})), toJson(view_));

    StudyInput input = study();
    const auto preset = completeState(state, wish, input);
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(toJson(state), toJson(view_));
    EXPECT_EQ(preset->publicName, view_.preset->name);
    EXPECT_TRUE(isSame(preset->function, *view_.preset));
}

TEST_F(AWish, countsMoreThanTheView) {
    view_.cuts.eye = EyeCut{};
    StateWish wish = saved();
    wish.look = trace::Look::average;
    wish.window = "40,400";
    wish.numbers["exposure"] = 0.5;
    wish.clip = "right-half";
    wish.view = ViewDirection::left;
    const StudyState state = stateFor(wish);
    EXPECT_EQ(state.settings.look, trace::Look::average);
    EXPECT_EQ(state.windows.at(std::size_t(trace::Look::average)), *parseWindow("40,400"));
    EXPECT_EQ(state.windows.at(std::size_t(trace::Look::mip)), *parseWindow("300,600"));
    EXPECT_EQ(state.settings.exposure, 0.5);
    EXPECT_EQ(state.clip->name, "right-half");
    EXPECT_TRUE(state.cuts.isNothing());
    EXPECT_FALSE(state.camera) << "the view of a direction is found when it is drawn";
    EXPECT_TRUE(state.leavesTableOut);
    EXPECT_EQ(*state.lights, *view_.lights);
    wish.keepTable = true;
    EXPECT_FALSE(stateFor(wish).leavesTableOut);
}

// Who says something of the table, or brings a view that does, is asked no more.
TEST_F(AWish, ofNoTableLeavesASureOneOut) {
    EXPECT_EQ(unaskedTable({}), UnaskedTable::goesWhereSure);
    EXPECT_EQ(unaskedTable({.clip = "left-half"}), UnaskedTable::goesWhereSure);
    EXPECT_EQ(unaskedTable({.removeTable = true}), UnaskedTable::stays);
    EXPECT_EQ(unaskedTable({.keepTable = true}), UnaskedTable::stays);
    EXPECT_EQ(unaskedTable({.session = "a.json"}), UnaskedTable::stays);
    EXPECT_EQ(unaskedTable({.presentation = "a.dcm"}), UnaskedTable::stays);
}

// Of the preset of the view as of one that is given, or that nobody chose.
TEST_F(AWish, ofItsMatterChangesWhicheverPreset) {
    view_.preset = *findPreset(catalogue(), "cinematic-bone");
    StateWish ofView = saved();
    StateWish ofName{.preset = "ct-bone"};
    StateWish ofNobody;
    for (StateWish* wish : {&ofView, &ofName, &ofNobody}) {
        StudyInput plainInput = study();
        StudyState plain = stateFor(*wish);
        const auto before = completeState(plain, *wish, plainInput);
        ASSERT_TRUE(before.ok()) << before.error().message;

        wish->matter = {{"surfaceWeight", 0.625}, {"roughness", 0.125}, {"anisotropy", -0.5}};
        StudyInput input = study();
        StudyState state = stateFor(*wish);
        const auto preset = completeState(state, *wish, input);
        ASSERT_TRUE(preset.ok()) << preset.error().message;
        TransferFunction wanted = before->function;
        wanted.surface.weight = 0.625;
        wanted.surface.roughness = 0.125;
        wanted.anisotropy = -0.5;
        EXPECT_EQ(preset->function, wanted);
        EXPECT_EQ(*state.preset, wanted);
        EXPECT_EQ(preset->publicName, before->publicName);
        const auto again = studyStateFromJson(toJson(state), "a view");
        ASSERT_TRUE(again.ok()) << again.error().message;
        EXPECT_TRUE(isSame(*again->preset, wanted)) << "a view that is saved holds them";
    }
}

TEST_F(AWish, ofMatterThatNoPresetMayHaveIsRefused) {
    const StateWish wish{.matter = {{"roughness", 0.0}}};
    StudyInput input = study();
    StudyState state = stateFor(wish);
    const auto refused = completeState(state, wish, input);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::inputNotUsable);
}

TEST_F(AWish, ofAFieldOfViewKeepsTheCamera) {
    StateWish wish = saved();
    wish.fovDeg = 50.0;
    const StudyState state = stateFor(wish);
    ASSERT_TRUE(state.camera);
    EXPECT_EQ(state.camera->positionMm, view_.camera->positionMm);
    EXPECT_EQ(state.camera->verticalFovDeg, 50.0);
}

TEST_F(AWish, ofParallelRaysKeepsWhatIsSeenAtTheTarget) {
    StateWish wish = saved();
    wish.isParallel = true;
    const StudyState state = stateFor(wish);
    ASSERT_TRUE(state.camera);
    EXPECT_EQ(state.camera->positionMm, view_.camera->positionMm);
    EXPECT_EQ(state.camera->parallelHeightMm, heightAtTargetMm(*view_.camera));
}

// In a projection a preset is a window, whatever the one of the view was.
TEST_F(AWish, ofAPresetBringsItsWindow) {
    StateWish wish = saved();
    wish.preset = "ct-bone";
    StudyState state = stateFor(wish);
    StudyInput input = study();
    const auto preset = completeState(state, wish, input);
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(preset->publicName, "ct-bone");
    EXPECT_EQ(state.preset->name, "ct-bone");
    EXPECT_EQ(state.windows.at(std::size_t(trace::Look::mip)), presetWindow(*state.preset, *input.volume));

    wish.window = "40,400";
    state = stateFor(wish);
    ASSERT_TRUE(completeState(state, wish, input));
    EXPECT_EQ(state.windows.at(std::size_t(trace::Look::mip)), *parseWindow("40,400"));
}

TEST_F(AWish, toFitIsOfThePresetOfTheView) {
    StateWish wish = saved();
    wish.fit = true;
    StudyState state = stateFor(wish);
    StudyInput input = study();
    const auto preset = completeState(state, wish, input);
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(preset->function.fitToVolume, withFit(*view_.preset)->fitToVolume);
    EXPECT_EQ(preset->publicName, view_.preset->name);
    ASSERT_EQ(input.notes.size(), 1u);
    EXPECT_TRUE(input.notes[0].starts_with("The preset was stretched")) << input.notes[0];
}

TEST_F(AWish, withoutAPresetIsDrawnWithThatOfTheSeries) {
    StudyState state;
    StudyInput input = study();
    const auto preset = completeState(state, {}, input);
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(preset->publicName, presetFor(catalogue(), *input.volume)->name);
    ASSERT_TRUE(state.preset);
    EXPECT_EQ(state.preset->name, preset->publicName);
}

TEST_F(AWish, ofAnotherSeriesIsRefused) {
    const StateWish wish = saved();
    StudyState state = stateFor(wish);
    StudyInput input = study();
    input.seriesDigest = "another";
    const auto refused = completeState(state, wish, input);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(refused.error().where, wish.session.string());
    state.seriesDigest.clear();
    EXPECT_TRUE(completeState(state, wish, input)) << "a view of no series is of any";
}

// Of the same series, exported anew: camera, clips and measurements would lie elsewhere.
TEST_F(AWish, ofOtherPlacesUnderTheSameUidIsRefused) {
    const StateWish wish = saved();
    StudyState state = stateFor(wish);
    StudyInput input = study();
    state.grid = savedGridOf(*input.volume);
    EXPECT_TRUE(completeState(state, wish, input));
    state.grid->worldFromVoxel[3].z += 4.0;
    const auto refused = completeState(state, wish, input);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::inputNotUsable);
    EXPECT_NE(refused.error().message.find("in other places"), std::string::npos);
    state.grid.reset();
    EXPECT_TRUE(completeState(state, wish, input)) << "a view of before has none";
}

TEST_F(AWish, namesTheFileThatCannotBeRead) {
    const std::filesystem::path path = folder_ / "broken.json";
    std::ofstream(path) << "{";
    for (const std::filesystem::path& file : {path, folder_ / "none.json"}) {
        const auto state = stateOf({.session = file});
        ASSERT_FALSE(state);
        EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable);
        EXPECT_EQ(state.error().where, file.string());
    }
}

// Also when it has been written and read: the name of what is somebody's own may say whose it is.
TEST(PublicName, ofWhatIsBuiltInIsItsNameAndOfAllElseCustom) {
    for (const auto& preset : catalogue().presets) {
        const auto read = studyStateFromJson(toJson(StudyState{.preset = preset}), "view.json");
        ASSERT_TRUE(read) << preset->name;
        EXPECT_EQ(publicPresetName(*read->preset), preset->name);
        TransferFunction own = *read->preset;
        own.density *= 2.0;
        EXPECT_EQ(publicPresetName(own), "custom");
    }
    for (const auto& rig : catalogue().lights) {
        EXPECT_EQ(publicLightsName(*rig), rig->name);
        trace::LightRig own = *rig;
        own.ambientZenith += 1.0;
        EXPECT_EQ(publicLightsName(own), "custom");
    }
    for (const auto& clip : catalogue().clips) {
        const auto read = studyStateFromJson(toJson(StudyState{.clip = *clip}), "view.json");
        ASSERT_TRUE(read) << clip->name;
        EXPECT_EQ(publicClipName(*read->clip), clip->name);
        ClipPreset own = *read->clip;
        own.name = "doe-john";
        EXPECT_EQ(publicClipName(own), "custom");
    }
    EXPECT_EQ(publicClipName(ClipPreset{}), "none");
}

}  // namespace
}  // namespace macula::app
