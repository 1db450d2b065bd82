// What a macula_view is: a volume, and everything that was chosen about how it is drawn.
#pragma once

#include <macula.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "c/kept_scene.h"
#include "pictures/state_request.h"
#include "scene/choice/study_preset.h"
#include "scene/drawing/shown_clip.h"
#include "scene/state/study_state.h"
#include "study/open/loaded_study.h"

namespace macula::c {

// Unlike the viewer, and like `macula render`, a picture does not shade ray casts unless a state asks for it.
inline scene::StudyState usualState() {
    scene::StudyState state;
    state.settings = {};
    return state;
}

// Everything that was chosen, as one state, except lights by name. Fails as pictures::stateOf.
Result<scene::StudyState> stateOf(const macula_view& view);
// The lights that were chosen by name, otherwise those for the look.
std::string lightsNamed(const macula_view& view, const scene::StudyState& state);

// What a view shows of its volume.
struct SeenView {
    scene::StudyState state;  // with its preset
    scene::StudyPreset preset;
    scene::ShownClip shown;
    std::vector<Text> notes;
};
// For a state of stateOf(view), perhaps with other settings.
Result<SeenView> seenBy(const macula_view& view, scene::StudyState state, Progress& progress);

}  // namespace macula::c

struct macula_view {
    macula::study::LoadedStudy study;  // 16 bits; without notes
    // What was chosen by a state, and what has no name, such as a camera. Names below override it.
    macula::scene::StudyState chosen = macula::c::usualState();
    macula::pictures::StateRequest request;  // preset, look and direction
    std::string lights;                      // by name or file; empty: those of the state, or for the look
    std::optional<macula::DisplayWindow> window;  // for the look that it is drawn in

    std::string state;  // the JSON of macula_view_state

    // Of the last picture.
    std::vector<std::string> notes;
    std::string preset;
    std::string device;
    std::string record;  // JSON
    std::optional<macula::Camera> drawnFrom;
    std::shared_ptr<macula::c::KeptScene> scene = std::make_shared<macula::c::KeptScene>();
};
