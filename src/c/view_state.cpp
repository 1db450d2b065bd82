// Everything that was chosen for a view, as the text of a state.
#include <memory>
#include <string>
#include <utility>

#include "c/handles.h"
#include "c/last_error.h"
#include "c/view.h"
#include "scene/choice/lights_choice.h"
#include "scene/state/study_state.h"

namespace macula::c {

namespace {

Result<std::string> stateText(const macula_view& view) {
    MACULA_TRY(scene::StudyState state, stateOf(view));
    if (!view.request.preset.empty()) {
        study::LoadedStudy study = view.study;
        MACULA_TRY_VOID(pictures::completeState(state, view.request, study));
        if (view.window) state.windows.at(std::size_t(state.settings.look)) = view.window;
    }
    if (!view.lights.empty()) {
        MACULA_TRY(trace::LightRig rig, scene::chooseLightRig(view.lights));
        state.lights = std::make_shared<const trace::LightRig>(std::move(rig));
    }
    state.seriesDigest = view.study.seriesDigest;
    state.grid = scene::savedGridOf(*view.study.volume);
    return toJson(state);
}

}  // namespace

extern "C" {

macula_status macula_view_state(macula_view* view, const char** json) {
    if (json != nullptr) *json = nullptr;
    return guarded([&]() -> Result<void> {
        if (json == nullptr) return nullHandle();
        MACULA_TRY(const Held<macula_view> of, changing(view));
        MACULA_TRY(of->state, stateText(*of));
        *json = of->state.c_str();
        return {};
    });
}

macula_status macula_view_set_state(macula_view* view, const char* json) {
    return guarded([&]() -> Result<void> {
        if (json == nullptr) return nullHandle();
        MACULA_TRY(const Held<macula_view> of, changing(view));
        MACULA_TRY(scene::StudyState state, scene::studyStateFromJson(json, "the state that was given"));
        MACULA_TRY_VOID(
            scene::checkSeries(state, of->study.seriesDigest, *of->study.volume, "the state that was given"));
        of->chosen = std::move(state);
        of->request = {};
        of->lights.clear();
        of->window.reset();
        return {};
    });
}

}  // extern "C"

}  // namespace macula::c
