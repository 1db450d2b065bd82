#include "app/study/study_preset.h"

#include <utility>

#include "app/choice/preset_choice.h"
#include "pipeline/volume/volume_fit.h"
#include "presets/default_preset.h"

namespace macula::app {

Result<presets::ImportedPreset> presetToDraw(const std::string& typed, bool fit) {
    MACULA_TRY(presets::ImportedPreset preset, choosePreset(typed));
    MACULA_TRY_VOID(validate(preset.function));
    if (fit) {
        MACULA_TRY(preset.function, withFit(std::move(preset.function)));
    }
    return preset;
}

std::vector<std::string> notesOf(const presets::ImportedPreset& preset, const Volume& volume) {
    std::vector<std::string> notes = preset.notes;
    if (const std::optional<VolumeFit> fit = fitOf(preset.function, volume))
        notes.push_back(fitMessage(*fit).sentence);
    if (!suits(preset.function, volume.unit()))
        notes.emplace_back("The preset is made for other units than those of the series.");
    return notes;
}

Result<StudyPreset> choosePresetFor(StudyInput& study, const std::string& typed, bool fit) {
    const std::string name = typed.empty() ? presets::defaultTransfer(*study.volume) : typed;
    MACULA_TRY(presets::ImportedPreset preset, presetToDraw(name, fit));
    for (std::string& note : notesOf(preset, *study.volume)) study.notes.push_back(std::move(note));
    return StudyPreset{.publicName = publicPresetName(name), .function = std::move(preset.function)};
}

}  // namespace macula::app
