#include "scene/choice/preset_kinds.h"

#include <algorithm>

#include "presets/default_preset.h"

namespace macula::scene {

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

FitsVolume::FitsVolume(const Volume& volume)
    : unit_(volume.unit()), modality_(volume.modality()), usual_(presets::defaultTransfer(volume)) {}

bool FitsVolume::operator()(const TransferFunction& preset) const {
    if (preset.name == usual_) return true;
    if (!suits(preset, unit_)) return false;
    const auto& made = preset.modalities;
    return made.empty() || modality_.empty() || std::ranges::find(made, modality_) != made.end();
}

}  // namespace macula::scene
