// The preset that a study is drawn with, and what there is to say about it. All verbs that draw ask here, so
// that none of them keeps quiet about what another tells.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "presets/imported_preset.h"
#include "study/open/study_input.h"

namespace macula::app {

// The preset as choosePreset finds it; `fit` stretches its range to the volume. Fails for a preset that could
// only be drawn as something else.
Result<presets::ImportedPreset> presetToDraw(const std::string& typed, bool fit);

// What was changed when it was read, whether it is stretched to the volume, and whether it is made for it.
std::vector<std::string> notesOf(const presets::ImportedPreset& preset, const Volume& volume);

// The same to tell of a picture: that it is made for other units is a warning then, with presets that are
// not.
struct PresetNotes {
    std::vector<std::string> notes;
    std::vector<std::string> warnings;  // those of them that change what is seen
};
PresetNotes notesToDraw(const presets::ImportedPreset& preset, const Volume& volume);
// Adds them to those of the study.
void tellOf(const presets::ImportedPreset& preset, StudyInput& study);

struct StudyPreset {
    std::string publicName;     // see publicPresetName
    TransferFunction function;  // not yet stretched: the tracer does that
};

// The preset that was typed, or when nothing was the one for what the series shows. Its notes join those of
// the study.
Result<StudyPreset> choosePresetFor(StudyInput& study, const std::string& typed, bool fit = false);

}  // namespace macula::app
