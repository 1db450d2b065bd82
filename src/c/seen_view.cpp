#include "c/seen_view.h"

#include <utility>

#include "scene/choice/lights_choice.h"

namespace macula::c {

Result<scene::StudyState> stateOf(const macula_view& view) {
    MACULA_TRY(scene::StudyState state, pictures::stateOf(view.request, view.chosen));
    if (view.window) state.windows.at(std::size_t(state.settings.look)) = view.window;
    return state;
}

std::string lightsNamed(const macula_view& view, const scene::StudyState& state) {
    return view.lights.empty() ? std::string(scene::defaultLightsFor(state.settings.look)) : view.lights;
}

Result<SeenView> seenBy(const macula_view& view, scene::StudyState state, Progress& progress) {
    study::LoadedStudy study = view.study;
    SeenView seen;
    MACULA_TRY(seen.preset, pictures::completeState(state, view.request, study));
    // The window of a preset must not replace it.
    if (view.window) state.windows.at(std::size_t(state.settings.look)) = view.window;
    MACULA_TRY(seen.shown, scene::shownClip(state, *study.volume, progress));
    seen.state = std::move(state);
    seen.notes = std::move(study.notes);
    seen.notes.insert(seen.notes.end(), seen.shown.notes.begin(), seen.shown.notes.end());
    return seen;
}

}  // namespace macula::c
