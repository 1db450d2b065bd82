#include "presets/default_preset.h"

#include <algorithm>

#include "pipeline/volume/transfer_function.h"
#include "pipeline/volume/window.h"
#include "presets/catalogue.h"
#include "presets/seen_values.h"

namespace macula::presets {

namespace {

// Inflated lung lies between -900 and -700 HU; so do foam and partly filled voxels at the skin, but they are
// few.
constexpr double kLungLowHu = -900.0;
constexpr double kLungHighHu = -700.0;
constexpr double kLeastLungMm3 = 400e3;  // 0.4 litres: one lung of a small adult, or a slab through a chest
constexpr double kLeastFraction = 0.04;

bool hasLungs(const Volume& volume) {
    const auto voxels = volume.voxels();
    const UnitsFromStored hu = volume.unitsFromStored();
    const std::size_t stride =
        std::max<std::size_t>(1, voxels.size() / 200'003);  // a prime: in step with no axis
    std::size_t seen = 0;
    std::size_t lung = 0;
    for (std::size_t i = 0; i < voxels.size(); i += stride) {
        const double value = hu(voxels[i]);
        ++seen;
        lung += value >= kLungLowHu && value <= kLungHighHu ? 1 : 0;
    }
    const double fraction = static_cast<double>(lung) / static_cast<double>(seen);
    const glm::dvec3 spacing = volume.spacingMm();
    const double volumeMm3 =
        fraction * static_cast<double>(voxels.size()) * spacing.x * spacing.y * spacing.z;
    return fraction > kLeastFraction && volumeMm3 > kLeastLungMm3;
}

std::string usualTransfer(const Volume& volume) {
    if (volume.unit() == Unit::hounsfield) return hasLungs(volume) ? "cinematic-chest" : "cinematic-bone";
    const bool isEmission = isActivity(volume) || volume.modality() == "NM";
    return isEmission ? "cinematic-pet" : "cinematic-mr";
}

bool isMadeFor(const TransferFunction& preset, const Volume& volume) {
    const auto& made = preset.modalities;
    return suits(preset, volume.unit()) && (made.empty() || volume.modality().empty() ||
                                            std::ranges::find(made, volume.modality()) != made.end());
}

}  // namespace

std::string defaultTransfer(const Volume& volume) {
    std::string usual = usualTransfer(volume);
    const auto presets = builtInPresets();
    if (!presets) return usual;
    const SeenValues values(volume);
    const auto named = std::ranges::find(*presets, usual, &TransferFunction::name);
    if (named == presets->end() || values.areSeenWith(*named)) return usual;
    const auto next = std::ranges::find_if(*presets, [&](const TransferFunction& preset) {
        return isMadeFor(preset, volume) && validate(preset).ok() && values.areSeenWith(preset);
    });
    return next == presets->end() ? usual : next->name;
}

}  // namespace macula::presets
