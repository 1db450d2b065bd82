// The state to show a study in, from the options of a command or of the C API: a saved view, and options
// that override it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/frames.h"
#include "base/result.h"
#include "pipeline/trace/look.h"
#include "scene/choice/study_preset.h"
#include "scene/drawing/shown_clip.h"
#include "scene/state/study_state.h"
#include "study/open/loaded_study.h"

namespace macula::pictures {

// Empty fields: not given.
struct StateRequest {
    std::filesystem::path savedView = {};  // a saved view: readStudyState
    // A DICOM presentation state, applied over `savedView`: dicom::readPresentationState.
    std::filesystem::path presentation = {};
    std::string preset = {};   // as choosePreset takes it
    bool fit = false;          // stretch the range of the preset to the volume
    std::string clip = {};     // as chooseClip takes it; also replaces the cuts of a view
    bool removeTable = false;  // hide the table
    bool keepTable = false;    // show the table, even if a view hides it
    std::optional<trace::Look> look = {};
    std::optional<trace::ToneMap> toneMap = {};
    std::string window = {};                          // for projections: parseWindow
    std::map<std::string_view, double> numbers = {};  // by Parameter::id
    std::map<std::string_view, double> matter = {};   // by MatterParameter::id; for any preset
    std::optional<ViewDirection> view = {};           // fits what is visible, seen from there
    std::filesystem::path camera = {};                // camera_file.h
    double fovDeg = 0.0;                              // 0: not given; for any camera
    bool isParallel = false;                          // makes any camera parallel
    // Of the picture, so that the whole view of a presentation state fits in it; 0: unknown.
    double aspectWidthOverHeight = 0.0;
};

// What to do with a table if neither the options nor a view say.
scene::UnaskedTable unaskedTable(const StateRequest& request);

// Options that may name a file, for OutputFiles::read.
std::vector<std::filesystem::path> filesOf(const StateRequest& request);

// `usual`, or the saved view, with the options applied. Checks the options before the study is read. The
// state does not hold a preset given by name yet, because that may depend on the study.
Result<scene::StudyState> stateOf(const StateRequest& request, scene::StudyState usual = {});

// Completes the state for a study that is read and in 16 bits. The state gets the preset to draw, with the
// given matter values; its name stays that of the original preset. For a projection without a window, the
// range of a given preset becomes the window, as in the viewer. Adds to the notes of the study those on the
// preset and on what a presentation state shows differently. inputNotUsable for a view or a presentation
// state of another series.
Result<scene::StudyPreset> completeState(scene::StudyState& state, const StateRequest& request,
                                         study::LoadedStudy& study);

}  // namespace macula::pictures
