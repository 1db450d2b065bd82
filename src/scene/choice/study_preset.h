// The preset that a study is drawn with, and the notes on it. All commands that draw use these functions, so
// that they report the same.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "presets/imported_preset.h"
#include "study/open/loaded_study.h"

namespace macula::scene {

// The preset as choosePreset finds it; `fit` stretches its range to the volume. Fails also for an invalid
// preset (validate).
Result<presets::ImportedPreset> presetToDraw(const std::string& typed, bool fit);

// Sentences on what the import changed, on the stretch to the volume, and on a unit other than the volume's.
std::vector<Text> notesOf(const presets::ImportedPreset& preset, const Volume& volume);

// The same for a picture. A unit other than the volume's is also a warning, with presets that suit the
// volume, unless the preset is the volume's default.
struct PresetNotes {
    std::vector<Text> notes;
    std::vector<Text> warnings;  // the notes that affect what is seen
};
PresetNotes notesToDraw(const presets::ImportedPreset& preset, const Volume& volume);
// Adds the notes and warnings of notesToDraw to those of the study.
void tellOf(const presets::ImportedPreset& preset, study::LoadedStudy& study);

struct StudyPreset {
    std::string publicName;     // see publicPresetName
    TransferFunction function;  // not yet stretched: the tracer does that
};

// The preset that was typed, or the volume's default for empty text. Adds its notes to those of the study.
Result<StudyPreset> choosePresetFor(study::LoadedStudy& study, const std::string& typed, bool fit = false);

}  // namespace macula::scene
