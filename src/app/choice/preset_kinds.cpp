#include "app/choice/preset_kinds.h"

#include <algorithm>

#include "presets/default_preset.h"

namespace macula::app {

std::string kindOf(const TransferFunction& preset) {
    std::string kind;
    for (const std::string& modality : preset.modalities) {
        const bool isMicro = modality == "CT" && preset.unit == Unit::raw;
        const bool isDiffusion = modality == "MR" && preset.title.starts_with("DTI-");
        kind += (kind.empty() ? "" : ", ") + (isMicro       ? std::string("µCT")
                                              : isDiffusion ? std::string("DTI")
                                                            : modality);
    }
    return kind;
}

bool isMadeFor(const TransferFunction& preset, const Volume& volume) {
    if (!suits(preset, volume.unit())) return false;
    const auto& made = preset.modalities;
    return made.empty() || volume.modality().empty() ||
           std::ranges::find(made, volume.modality()) != made.end();
}

PresetsForVolume presetsForVolume(const Presets& all, const Volume& volume) {
    const std::string usual = presets::defaultTransfer(volume);
    PresetsForVolume divided;
    for (const auto& preset : all) {
        const bool fits = preset->name == usual || isMadeFor(*preset, volume);
        (fits ? divided.fitting : divided.others).push_back(preset);
    }
    return divided;
}

}  // namespace macula::app
