#include "pictures/state_request.h"

#include <memory>
#include <utility>

#include "pipeline/volume/volume_fit.h"
#include "pipeline/volume/window.h"
#include "scene/camera/camera_file.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/preset_choice.h"
#include "scene/choice/typed_values.h"
#include "scene/presentation/state_of_presentation.h"

namespace macula::pictures {

namespace {

Result<void> setPreset(scene::StudyState& state, const StateRequest& request) {
    if (!request.preset.empty()) {
        MACULA_TRY_VOID(scene::presetToDraw(request.preset, request.fit));
        state.preset.reset();
    } else if (state.preset && request.fit) {
        MACULA_TRY(TransferFunction fitted, withFit(*state.preset));
        state.preset = std::make_shared<const TransferFunction>(std::move(fitted));
    }
    return {};
}

Result<void> setCamera(scene::StudyState& state, const StateRequest& request) {
    if (request.view) state.camera.reset();
    if (!request.camera.empty()) {
        MACULA_TRY(state.camera, scene::readCamera(request.camera));
    }
    if (state.camera && request.fovDeg > 0.0) state.camera->verticalFovDeg = request.fovDeg;
    if (state.camera && request.isParallel) state.camera = inParallel(*state.camera);
    return {};
}

// Applies its clip, unless the options give one, and the unit of its values.
Result<void> applyPresentationState(scene::StudyState& state, const StateRequest& request,
                                    study::LoadedStudy& study) {
    const std::string where = request.presentation.string();
    MACULA_TRY(const dicom::PresentationState read, dicom::readPresentationState(request.presentation));
    MACULA_TRY(scene::PresentedState presented, scene::stateOf(read, {}, where));
    MACULA_TRY_VOID(
        scene::completeFor(presented, read, *study.volume, study.seriesDigest, study.images, where));
    state.seriesDigest = study.seriesDigest;
    if (request.clip.empty()) state.clip = presented.state.clip;
    if (state.preset && presented.state.preset) {
        TransferFunction function = *state.preset;
        function.unit = presented.state.preset->unit;
        function.modalities = presented.state.preset->modalities;
        state.preset = std::make_shared<const TransferFunction>(std::move(function));
    }
    for (const Text& note : presented.notes) {
        study.notes.push_back(note);
        study.warnings.push_back(note);
    }
    return {};
}

}  // namespace

scene::UnaskedTable unaskedTable(const StateRequest& request) {
    const bool isSaid = request.removeTable || request.keepTable || !request.savedView.empty() ||
                        !request.presentation.empty();
    return isSaid ? scene::UnaskedTable::stays : scene::UnaskedTable::goesWhereSure;
}

std::vector<std::filesystem::path> filesOf(const StateRequest& request) {
    return {request.savedView, request.presentation, request.preset, request.clip, request.camera};
}

Result<scene::StudyState> stateOf(const StateRequest& request, scene::StudyState usual) {
    scene::StudyState state = std::move(usual);
    if (!request.savedView.empty()) {
        MACULA_TRY(state, scene::readStudyState(request.savedView));
    }
    if (!request.presentation.empty()) {
        MACULA_TRY(const dicom::PresentationState read, dicom::readPresentationState(request.presentation));
        MACULA_TRY(scene::PresentedState presented,
                   stateOf(read, std::move(state), request.presentation.string()));
        scene::widenFor(presented, request.aspectWidthOverHeight);
        state = std::move(presented.state);
    }
    if (request.look) state.settings.look = *request.look;
    if (request.toneMap) state.settings.toneMap = *request.toneMap;
    for (const auto& [id, value] : request.numbers) scene::parameter(id).set(state.settings, value);
    if (!request.window.empty()) {
        MACULA_TRY(state.windows.at(std::size_t(state.settings.look)), scene::parseWindow(request.window));
    }
    MACULA_TRY_VOID(setPreset(state, request));
    if (!request.clip.empty()) {
        MACULA_TRY(state.clip, scene::chooseClip(request.clip));
        state.cuts = {};
    }
    state.leavesTableOut = (state.leavesTableOut || request.removeTable) && !request.keepTable;
    MACULA_TRY_VOID(setCamera(state, request));
    return state;
}

Result<scene::StudyPreset> completeState(scene::StudyState& state, const StateRequest& request,
                                         study::LoadedStudy& study) {
    if (!request.presentation.empty()) MACULA_TRY_VOID(applyPresentationState(state, request, study));
    MACULA_TRY_VOID(scene::checkSeries(state, study.seriesDigest, *study.volume, request.savedView.string()));
    scene::StudyPreset preset;
    if (state.preset) {
        preset = {.publicName = scene::publicPresetName(*state.preset), .function = *state.preset};
        scene::tellOf({preset.function, {}}, study);
    } else {
        MACULA_TRY(preset, scene::choosePresetFor(study, request.preset, request.fit));
    }
    for (const auto& [id, value] : request.matter) scene::matterParameter(id).set(preset.function, value);
    MACULA_TRY_VOID(validate(preset.function));
    state.preset = std::make_shared<const TransferFunction>(preset.function);
    const trace::Look look = state.settings.look;
    if (trace::isProjection(look) && !request.preset.empty() && request.window.empty())
        state.windows.at(std::size_t(look)) = presetWindow(preset.function, *study.volume);
    return preset;
}

}  // namespace macula::pictures
