#include "scene/choice/study_preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "pipeline/volume/volume_fit.h"
#include "presets/catalogue.h"
#include "presets/default_preset.h"
#include "scene/choice/preset_choice.h"
#include "scene/choice/preset_kinds.h"

namespace macula::scene {

namespace {

Text otherUnits() {
    return Text("The preset is made for other units than those of the series.");
}

// The default preset of the volume, followed by some of the others that are made for it.
std::vector<std::string> namesFor(const Volume& volume) {
    constexpr std::size_t kMostNames = 6;
    std::vector<std::string> names{presets::defaultTransfer(volume)};
    const auto presets = presets::builtInPresets();
    if (!presets) return names;
    const FitsVolume fits(volume);
    for (const TransferFunction& preset : *presets) {
        if (names.size() == kMostNames) break;
        if (preset.name != names.front() && fits(preset)) names.push_back(preset.name);
    }
    return names;
}

}  // namespace

Result<presets::ImportedPreset> presetToDraw(const std::string& typed, bool fit) {
    MACULA_TRY(presets::ImportedPreset preset, choosePreset(typed));
    MACULA_TRY_VOID(validate(preset.function));
    if (fit) {
        MACULA_TRY(preset.function, withFit(std::move(preset.function)));
    }
    return preset;
}

std::vector<Text> notesOf(const presets::ImportedPreset& preset, const Volume& volume) {
    std::vector<Text> notes = preset.notes;
    if (const std::optional<VolumeFit> fit = fitOf(preset.function, volume))
        notes.push_back(fitMessage(*fit).sentence);
    if (!suits(preset.function, volume.unit())) notes.push_back(otherUnits());
    return notes;
}

PresetNotes notesToDraw(const presets::ImportedPreset& preset, const Volume& volume) {
    PresetNotes told{.notes = notesOf(preset, volume), .warnings = {}};
    for (Text& note : told.notes) {
        if (note != otherUnits()) continue;
        const std::vector<std::string> names = namesFor(volume);
        if (preset.function.name == names.front()) continue;  // it is the default for this volume
        note =
            Text::joined({note, Text("Presets for it: {}.", fmt::format("{}", fmt::join(names, ", ")))}, " ");
        told.warnings.push_back(note);
    }
    return told;
}

void tellOf(const presets::ImportedPreset& preset, study::LoadedStudy& study) {
    PresetNotes told = notesToDraw(preset, *study.volume);
    std::ranges::move(told.notes, std::back_inserter(study.notes));
    std::ranges::move(told.warnings, std::back_inserter(study.warnings));
}

Result<StudyPreset> choosePresetFor(study::LoadedStudy& study, const std::string& typed, bool fit) {
    const std::string name = typed.empty() ? presets::defaultTransfer(*study.volume) : typed;
    MACULA_TRY(presets::ImportedPreset preset, presetToDraw(name, fit));
    tellOf(preset, study);
    return StudyPreset{.publicName = publicPresetName(name), .function = std::move(preset.function)};
}

}  // namespace macula::scene
