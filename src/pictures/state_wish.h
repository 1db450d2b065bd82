// How a study is to be shown, as somebody asks for it who has no window: a view that was saved, and what is
// given besides, which counts more.
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
#include "study/open/study_input.h"

namespace macula::app {

// Empty: not given.
struct StateWish {
    std::filesystem::path session = {};  // a view that was saved: readStudyState
    // A DICOM presentation state, which takes the place of a view: dicom::readPresentationState.
    std::filesystem::path presentation = {};
    std::string preset = {};   // as choosePreset
    bool fit = false;          // the preset's range is stretched to the volume
    std::string clip = {};     // as chooseClip; in the place of the cuts of a view too
    bool removeTable = false;  // leave it out
    bool keepTable = false;    // show it, also where a view leaves it out
    std::optional<trace::Look> look = {};
    std::optional<trace::ToneMap> toneMap = {};
    std::string window = {};                          // of projections: parseWindow
    std::map<std::string_view, double> numbers = {};  // by Parameter::id
    std::map<std::string_view, double> matter = {};   // by MatterParameter::id; of whichever preset
    std::optional<ViewDirection> view = {};           // what is seen fills the picture, from there
    std::filesystem::path camera = {};                // camera_file.h
    double fovDeg = 0.0;                              // 0: not given; of whichever camera
    bool isParallel = false;                          // rays are parallel, whichever the camera
    // Of the picture, so that all of the view of a presentation state is seen in it; 0: not known.
    double aspectWidthOverHeight = 0.0;
};

// What becomes of a table of which neither the wish nor a view says anything.
UnaskedTable unaskedTable(const StateWish& wish);

// What may be a file among what is given, for OutputFiles::read.
std::vector<std::filesystem::path> filesOf(const StateWish& wish);

// `usual`, or the view that was saved, with what is given besides. All that can be wrong about it is told
// now, the study not yet read. A preset that is given is not in it yet: what it is like may depend on the
// study.
Result<StudyState> stateOf(const StateWish& wish, StudyState usual = {});

// The same for a study that is read and in 16 bits. The state gets the preset that is drawn, with the numbers
// that are given of its matter; its name is that of the preset they were given for. The range of one
// that was given becomes the window of a projection, as in the viewer. What there is to say of the preset
// joins the notes of the study, and so does what a presentation state has that is shown otherwise.
// inputNotUsable for a view or a presentation state of another series.
Result<StudyPreset> completeState(StudyState& state, const StateWish& wish, StudyInput& study);

}  // namespace macula::app
