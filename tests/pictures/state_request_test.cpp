// A view that was saved, with what is given besides: what comes out, and what of it may be told.
#include "pictures/state_request.h"

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

namespace macula::pictures {
namespace {

const scene::Catalogue& catalogue() {
    static const scene::Catalogue all = *scene::builtInCatalogue();
    return all;
}

study::LoadedStudy study() {
    study::LoadedStudy input{
        .volume = std::make_shared<const Volume>(phantom::make({.size = glm::ivec3(16)})),
        .notes = {},
        .warnings = {},
        .seriesDigest = "phantom"};
    study::bringTo16Bits(input);
    return input;
}

class ARequest : public ::testing::Test {
  protected:
    // A view in a projection, of the phantom, and the request to see it.
    StateRequest saved() {
        view_.seriesDigest = "phantom";
        view_.preset = catalogue().presets.at(0);
        view_.clip = *catalogue().clips.at(0);
        view_.lights = catalogue().lights.at(1);
        view_.leavesTableOut = true;
        view_.settings.look = trace::Look::mip;
        view_.settings.exposure = 2.0;
        view_.windows.at(std::size_t(trace::Look::mip)) = *scene::parseWindow("300,600");
        view_.camera = Camera{};
        const std::filesystem::path path = folder_ / "view.json";
        std::ofstream(path) << toJson(view_);
        return {.savedView = path};
    }
    scene::StudyState stateFor(const StateRequest& request) const {
        const auto state = stateOf(request);
        EXPECT_TRUE(state.ok()) << (state ? "" : state.error().message.english());
        return state ? *state : scene::StudyState{};
    }

    const dicom::test::TemporaryFolder folder_;
    scene::StudyState view_;
};

TEST_F(ARequest, IsWhatIsUsualWhereNothingIsGiven) {
    const scene::StudyState usual{.leavesTableOut = true, .settings = {.bounces = 3}};
    EXPECT_EQ(*stateOf({}, usual), usual);
    EXPECT_EQ(stateFor({}), scene::StudyState{});
}

TEST_F(ARequest, IsTheViewWhereThatIsGiven) {
    const StateRequest request = saved();
    scene::StudyState state = stateFor(request);
    EXPECT_EQ(toJson(state), toJson(view_));
    EXPECT_EQ(toJson(*stateOf(request, {.settings = {.bounces = 3}})), toJson(view_));

    study::LoadedStudy input = study();
    const auto preset = completeState(state, request, input);
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(toJson(state), toJson(view_));
    EXPECT_EQ(preset->publicName, view_.preset->name);
    EXPECT_TRUE(scene::isSame(preset->function, *view_.preset));
}

TEST_F(ARequest, CountsMoreThanTheView) {
    view_.cuts.eye = scene::EyeCut{};
    StateRequest request = saved();
    request.look = trace::Look::average;
    request.window = "40,400";
    request.numbers["exposure"] = 0.5;
    request.clip = "right-half";
    request.view = ViewDirection::left;
    const scene::StudyState state = stateFor(request);
    EXPECT_EQ(state.settings.look, trace::Look::average);
    EXPECT_EQ(state.windows.at(std::size_t(trace::Look::average)), *scene::parseWindow("40,400"));
    EXPECT_EQ(state.windows.at(std::size_t(trace::Look::mip)), *scene::parseWindow("300,600"));
    EXPECT_EQ(state.settings.exposure, 0.5);
    EXPECT_EQ(state.clip->name, "right-half");
    EXPECT_TRUE(state.cuts.isNothing());
    EXPECT_FALSE(state.camera) << "the view of a direction is found when it is drawn";
    EXPECT_TRUE(state.leavesTableOut);
    EXPECT_EQ(*state.lights, *view_.lights);
    request.keepTable = true;
    EXPECT_FALSE(stateFor(request).leavesTableOut);
}

// Who says something of the table, or brings a view that does, is asked no more.
TEST_F(ARequest, OfNoTableLeavesASureOneOut) {
    EXPECT_EQ(unaskedTable({}), scene::UnaskedTable::goesWhereSure);
    EXPECT_EQ(unaskedTable({.clip = "left-half"}), scene::UnaskedTable::goesWhereSure);
    EXPECT_EQ(unaskedTable({.removeTable = true}), scene::UnaskedTable::stays);
    EXPECT_EQ(unaskedTable({.keepTable = true}), scene::UnaskedTable::stays);
    EXPECT_EQ(unaskedTable({.savedView = "a.json"}), scene::UnaskedTable::stays);
    EXPECT_EQ(unaskedTable({.presentation = "a.dcm"}), scene::UnaskedTable::stays);
}

// Of the preset of the view as of one that is given, or that nobody chose.
TEST_F(ARequest, OfItsMatterChangesWhicheverPreset) {
    view_.preset = *scene::findPreset(catalogue(), "cinematic-bone");
    StateRequest ofView = saved();
    StateRequest ofName{.preset = "ct-bone"};
    StateRequest ofNobody;
    for (StateRequest* request : {&ofView, &ofName, &ofNobody}) {
        study::LoadedStudy plainInput = study();
        scene::StudyState plain = stateFor(*request);
        const auto before = completeState(plain, *request, plainInput);
        ASSERT_TRUE(before.ok()) << before.error().message;

        request->matter = {{"surfaceWeight", 0.625}, {"roughness", 0.125}, {"anisotropy", -0.5}};
        study::LoadedStudy input = study();
        scene::StudyState state = stateFor(*request);
        const auto preset = completeState(state, *request, input);
        ASSERT_TRUE(preset.ok()) << preset.error().message;
        TransferFunction wanted = before->function;
        wanted.surface.weight = 0.625;
        wanted.surface.roughness = 0.125;
        wanted.anisotropy = -0.5;
        EXPECT_EQ(preset->function, wanted);
        EXPECT_EQ(*state.preset, wanted);
        EXPECT_EQ(preset->publicName, before->publicName);
        const auto again = scene::studyStateFromJson(toJson(state), "a view");
        ASSERT_TRUE(again.ok()) << again.error().message;
        EXPECT_TRUE(scene::isSame(*again->preset, wanted)) << "a view that is saved holds them";
    }
}

TEST_F(ARequest, OfMatterThatNoPresetMayHaveIsRefused) {
    const StateRequest request{.matter = {{"roughness", 0.0}}};
    study::LoadedStudy input = study();
    scene::StudyState state = stateFor(request);
    const auto refused = completeState(state, request, input);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::inputNotUsable);
}

TEST_F(ARequest, OfAFieldOfViewKeepsTheCamera) {
    StateRequest request = saved();
    request.fovDeg = 50.0;
    const scene::StudyState state = stateFor(request);
    ASSERT_TRUE(state.camera);
    EXPECT_EQ(state.camera->positionMm, view_.camera->positionMm);
    EXPECT_EQ(state.camera->verticalFovDeg, 50.0);
}

TEST_F(ARequest, OfParallelRaysKeepsWhatIsSeenAtTheTarget) {
    StateRequest request = saved();
    request.isParallel = true;
    const scene::StudyState state = stateFor(request);
    ASSERT_TRUE(state.camera);
    EXPECT_EQ(state.camera->positionMm, view_.camera->positionMm);
    EXPECT_EQ(state.camera->parallelHeightMm, heightAtTargetMm(*view_.camera));
}

// In a projection a preset is a window, whatever the one of the view was.
TEST_F(ARequest, OfAPresetBringsItsWindow) {
    StateRequest request = saved();
    request.preset = "ct-bone";
    scene::StudyState state = stateFor(request);
    study::LoadedStudy input = study();
    const auto preset = completeState(state, request, input);
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(preset->publicName, "ct-bone");
    EXPECT_EQ(state.preset->name, "ct-bone");
    EXPECT_EQ(state.windows.at(std::size_t(trace::Look::mip)), presetWindow(*state.preset, *input.volume));

    request.window = "40,400";
    state = stateFor(request);
    ASSERT_TRUE(completeState(state, request, input));
    EXPECT_EQ(state.windows.at(std::size_t(trace::Look::mip)), *scene::parseWindow("40,400"));
}

TEST_F(ARequest, ToFitIsOfThePresetOfTheView) {
    StateRequest request = saved();
    request.fit = true;
    scene::StudyState state = stateFor(request);
    study::LoadedStudy input = study();
    const auto preset = completeState(state, request, input);
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(preset->function.fitToVolume, withFit(*view_.preset)->fitToVolume);
    EXPECT_EQ(preset->publicName, view_.preset->name);
    ASSERT_EQ(input.notes.size(), 1u);
    EXPECT_TRUE(input.notes[0].english().starts_with("The preset was stretched")) << input.notes[0];
}

TEST_F(ARequest, WithoutAPresetIsDrawnWithThatOfTheSeries) {
    scene::StudyState state;
    study::LoadedStudy input = study();
    const auto preset = completeState(state, {}, input);
    ASSERT_TRUE(preset) << preset.error().message;
    EXPECT_EQ(preset->publicName, scene::presetFor(catalogue(), *input.volume)->name);
    ASSERT_TRUE(state.preset);
    EXPECT_EQ(state.preset->name, preset->publicName);
}

TEST_F(ARequest, OfAnotherSeriesIsRefused) {
    const StateRequest request = saved();
    scene::StudyState state = stateFor(request);
    study::LoadedStudy input = study();
    input.seriesDigest = "another";
    const auto refused = completeState(state, request, input);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(refused.error().where, request.savedView.string());
    state.seriesDigest.clear();
    EXPECT_TRUE(completeState(state, request, input)) << "a view of no series is of any";
}

// Of the same series, exported anew: camera, clips and measurements would lie elsewhere.
TEST_F(ARequest, OfOtherPlacesUnderTheSameUidIsRefused) {
    const StateRequest request = saved();
    scene::StudyState state = stateFor(request);
    study::LoadedStudy input = study();
    state.grid = scene::savedGridOf(*input.volume);
    EXPECT_TRUE(completeState(state, request, input));
    state.grid->worldFromVoxel[3].z += 4.0;
    const auto refused = completeState(state, request, input);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::inputNotUsable);
    EXPECT_NE(refused.error().message.english().find("in other places"), std::string::npos);
    state.grid.reset();
    EXPECT_TRUE(completeState(state, request, input)) << "a view of before has none";
}

TEST_F(ARequest, NamesTheFileThatCannotBeRead) {
    const std::filesystem::path path = folder_ / "broken.json";
    std::ofstream(path) << "{";
    for (const std::filesystem::path& file : {path, folder_ / "none.json"}) {
        const auto state = stateOf({.savedView = file});
        ASSERT_FALSE(state);
        EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable);
        EXPECT_EQ(state.error().where, file.string());
    }
}

// Also when it has been written and read: the name of what is somebody's own may say whose it is.
TEST(PublicName, OfWhatIsBuiltInIsItsNameAndOfAllElseCustom) {
    for (const auto& preset : catalogue().presets) {
        const auto read = scene::studyStateFromJson(toJson(scene::StudyState{.preset = preset}), "view.json");
        ASSERT_TRUE(read) << preset->name;
        EXPECT_EQ(scene::publicPresetName(*read->preset), preset->name);
        TransferFunction own = *read->preset;
        own.density *= 2.0;
        EXPECT_EQ(scene::publicPresetName(own), "custom");
    }
    for (const auto& rig : catalogue().lights) {
        EXPECT_EQ(scene::publicLightsName(*rig), rig->name);
        trace::LightRig own = *rig;
        own.ambientZenith += 1.0;
        EXPECT_EQ(scene::publicLightsName(own), "custom");
    }
    for (const auto& clip : catalogue().clips) {
        const auto read = scene::studyStateFromJson(toJson(scene::StudyState{.clip = *clip}), "view.json");
        ASSERT_TRUE(read) << clip->name;
        EXPECT_EQ(scene::publicClipName(*read->clip), clip->name);
        ClipPreset own = *read->clip;
        own.name = "doe-john";
        EXPECT_EQ(scene::publicClipName(own), "custom");
    }
    EXPECT_EQ(scene::publicClipName(ClipPreset{}), "none");
}

}  // namespace
}  // namespace macula::pictures
