#include "pictures/state_wish.h"

#include <memory>
#include <utility>

#include "pipeline/volume/volume_fit.h"
#include "pipeline/volume/window.h"
#include "scene/camera/camera_file.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/preset_choice.h"
#include "scene/choice/typed_values.h"
#include "scene/presentation/state_of_presentation.h"

namespace macula::app {

namespace {

Result<void> setPreset(StudyState& state, const StateWish& wish) {
    if (!wish.preset.empty()) {
        MACULA_TRY_VOID(presetToDraw(wish.preset, wish.fit));
        state.preset.reset();
    } else if (state.preset && wish.fit) {
        MACULA_TRY(TransferFunction fitted, withFit(*state.preset));
        state.preset = std::make_shared<const TransferFunction>(std::move(fitted));
    }
    return {};
}

Result<void> setCamera(StudyState& state, const StateWish& wish) {
    if (wish.view) state.camera.reset();
    if (!wish.camera.empty()) {
        MACULA_TRY(state.camera, readCamera(wish.camera));
    }
    if (state.camera && wish.fovDeg > 0.0) state.camera->verticalFovDeg = wish.fovDeg;
    if (state.camera && wish.isParallel) state.camera = inParallel(*state.camera);
    return {};
}

// The clip, and what the values are, unless something else was given.
Result<void> completePresented(StudyState& state, const StateWish& wish, StudyInput& study) {
    const std::string where = wish.presentation.string();
    MACULA_TRY(const dicom::PresentationState read, dicom::readPresentationState(wish.presentation));
    MACULA_TRY(PresentedState presented, stateOf(read, {}, where));
    MACULA_TRY_VOID(completeFor(presented, read, *study.volume, study.seriesDigest, study.images, where));
    state.seriesDigest = study.seriesDigest;
    if (wish.clip.empty()) state.clip = presented.state.clip;
    if (state.preset && presented.state.preset) {
        TransferFunction function = *state.preset;
        function.unit = presented.state.preset->unit;
        function.modalities = presented.state.preset->modalities;
        state.preset = std::make_shared<const TransferFunction>(std::move(function));
    }
    for (const std::string& note : presented.notes) {
        study.notes.push_back(note);
        study.warnings.push_back(note);
    }
    return {};
}

}  // namespace

UnaskedTable unaskedTable(const StateWish& wish) {
    const bool isSaid =
        wish.removeTable || wish.keepTable || !wish.session.empty() || !wish.presentation.empty();
    return isSaid ? UnaskedTable::stays : UnaskedTable::goesWhereSure;
}

std::vector<std::filesystem::path> filesOf(const StateWish& wish) {
    return {wish.session, wish.presentation, wish.preset, wish.clip, wish.camera};
}

Result<StudyState> stateOf(const StateWish& wish, StudyState usual) {
    StudyState state = std::move(usual);
    if (!wish.session.empty()) {
        MACULA_TRY(state, readStudyState(wish.session));
    }
    if (!wish.presentation.empty()) {
        MACULA_TRY(const dicom::PresentationState read, dicom::readPresentationState(wish.presentation));
        MACULA_TRY(PresentedState presented, stateOf(read, std::move(state), wish.presentation.string()));
        widenFor(presented, wish.aspectWidthOverHeight);
        state = std::move(presented.state);
    }
    if (wish.look) state.settings.look = *wish.look;
    if (wish.toneMap) state.settings.toneMap = *wish.toneMap;
    for (const auto& [id, value] : wish.numbers) parameter(id).set(state.settings, value);
    if (!wish.window.empty()) {
        MACULA_TRY(state.windows.at(std::size_t(state.settings.look)), parseWindow(wish.window));
    }
    MACULA_TRY_VOID(setPreset(state, wish));
    if (!wish.clip.empty()) {
        MACULA_TRY(state.clip, chooseClip(wish.clip));
        state.cuts = {};
    }
    state.leavesTableOut = (state.leavesTableOut || wish.removeTable) && !wish.keepTable;
    MACULA_TRY_VOID(setCamera(state, wish));
    return state;
}

Result<StudyPreset> completeState(StudyState& state, const StateWish& wish, StudyInput& study) {
    if (!wish.presentation.empty()) MACULA_TRY_VOID(completePresented(state, wish, study));
    MACULA_TRY_VOID(checkSeries(state, study.seriesDigest, *study.volume, wish.session.string()));
    StudyPreset preset;
    if (state.preset) {
        preset = {.publicName = publicPresetName(*state.preset), .function = *state.preset};
        tellOf({preset.function, {}}, study);
    } else {
        MACULA_TRY(preset, choosePresetFor(study, wish.preset, wish.fit));
    }
    for (const auto& [id, value] : wish.matter) matterParameter(id).set(preset.function, value);
    MACULA_TRY_VOID(validate(preset.function));
    state.preset = std::make_shared<const TransferFunction>(preset.function);
    const trace::Look look = state.settings.look;
    if (trace::isProjection(look) && !wish.preset.empty() && wish.window.empty())
        state.windows.at(std::size_t(look)) = presetWindow(preset.function, *study.volume);
    return preset;
}

}  // namespace macula::app
