#include "c/seen_view.h"

#include <utility>

#include "scene/choice/lights_choice.h"

namespace macula::c {

Result<app::StudyState> stateOf(const macula_view& view) {
    MACULA_TRY(app::StudyState state, app::stateOf(view.wish, view.chosen));
    if (view.window) state.windows.at(std::size_t(state.settings.look)) = view.window;
    return state;
}

std::string lightsNamed(const macula_view& view, const app::StudyState& state) {
    return view.lights.empty() ? std::string(app::defaultLightsFor(state.settings.look)) : view.lights;
}

Result<SeenView> seenBy(const macula_view& view, app::StudyState state, Progress& progress) {
    app::StudyInput study = view.study;
    SeenView seen;
    MACULA_TRY(seen.preset, app::completeState(state, view.wish, study));
    // That of a preset must not take its place.
    if (view.window) state.windows.at(std::size_t(state.settings.look)) = view.window;
    MACULA_TRY(seen.shown, app::shownClip(state, *study.volume, progress));
    seen.state = std::move(state);
    seen.notes = std::move(study.notes);
    seen.notes.insert(seen.notes.end(), seen.shown.notes.begin(), seen.shown.notes.end());
    return seen;
}

}  // namespace macula::c
