// What a view shows of its volume.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "c/view.h"
#include "scene/choice/study_preset.h"
#include "scene/drawing/shown_clip.h"
#include "scene/state/study_state.h"

namespace macula::c {

// Everything that was chosen, as one state, except lights by name. Fails as pictures::stateOf.
Result<scene::StudyState> stateOf(const macula_view& view);
// The lights that were chosen by name, otherwise those for the look.
std::string lightsNamed(const macula_view& view, const scene::StudyState& state);

struct SeenView {
    scene::StudyState state;  // with its preset
    scene::StudyPreset preset;
    scene::ShownClip shown;
    std::vector<Text> notes;
};
// For a state of stateOf(view), perhaps with other settings.
Result<SeenView> seenBy(const macula_view& view, scene::StudyState state, Progress& progress);

}  // namespace macula::c
