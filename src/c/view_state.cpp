// All that was chosen for a view, as the text of a state.
#include <memory>
#include <string>
#include <utility>

#include "c/handles.h"
#include "c/last_error.h"
#include "c/seen_view.h"
#include "c/view.h"
#include "scene/choice/lights_choice.h"
#include "scene/state/study_state.h"

namespace macula::c {

namespace {

Result<std::string> stateText(const macula_view& view) {
    MACULA_TRY(app::StudyState state, stateOf(view));
    if (!view.wish.preset.empty()) {
        app::StudyInput study = view.study;
        MACULA_TRY_VOID(app::completeState(state, view.wish, study));
        if (view.window) state.windows.at(std::size_t(state.settings.look)) = view.window;
    }
    if (!view.lights.empty()) {
        MACULA_TRY(trace::LightRig rig, app::chooseLightRig(view.lights));
        state.lights = std::make_shared<const trace::LightRig>(std::move(rig));
    }
    state.seriesDigest = view.study.seriesDigest;
    state.grid = app::savedGridOf(*view.study.volume);
    return app::toJson(state);
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
        MACULA_TRY(app::StudyState state, app::studyStateFromJson(json, "the state that was given"));
        MACULA_TRY_VOID(
            app::checkSeries(state, of->study.seriesDigest, *of->study.volume, "the state that was given"));
        of->chosen = std::move(state);
        of->wish = {};
        of->lights.clear();
        of->window.reset();
        return {};
    });
}

}  // extern "C"

}  // namespace macula::c
