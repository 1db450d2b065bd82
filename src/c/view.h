// What a macula_view is: a volume, and all that was chosen of how it is drawn.
#pragma once

#include <macula.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/volume.h"
#include "c/kept_scene.h"
#include "pictures/state_request.h"
#include "scene/state/study_state.h"
#include "study/open/loaded_study.h"

namespace macula::c {

// Unlike the viewer, a picture shades no ray cast by itself: as `macula render`.
inline scene::StudyState usualState() {
    scene::StudyState state;
    state.settings = {};
    return state;
}

}  // namespace macula::c

struct macula_view {
    macula::study::LoadedStudy study;  // 16 bits; without notes
    // What was chosen by a state, and by what is no name. What was chosen by name counts more.
    macula::scene::StudyState chosen = macula::c::usualState();
    macula::pictures::StateRequest request;  // preset, look, table and direction
    std::string lights;                      // by name or file; empty: those of the state, or for the look
    std::optional<macula::DisplayWindow> window;  // of the look that it is drawn in

    std::string state;  // that was asked for

    // Of the last picture.
    std::vector<std::string> notes;
    std::string preset;
    std::string device;
    std::string record;  // JSON
    std::optional<macula::Camera> drawnFrom;
    std::shared_ptr<macula::c::KeptScene> scene = std::make_shared<macula::c::KeptScene>();
};
