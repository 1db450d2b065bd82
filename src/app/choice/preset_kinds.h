// Which presets are made for what kind of images.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::app {

// For people, by what the preset says of itself: "CT", "µCT", "MR", "DTI", "US", "PT", "CT, MR"; empty where
// it says nothing. Micro-CT calls its modality CT and has raw numbers; diffusion has its name only.
std::string kindOf(const TransferFunction& preset);

// Made for the values and the modality of this volume, as far as both say.
bool isMadeFor(const TransferFunction& preset, const Volume& volume);

using Presets = std::vector<std::shared_ptr<const TransferFunction>>;

// `all` in two, each in the order of `all`. What a volume is shown with when nobody chose counts as fitting.
struct PresetsForVolume {
    Presets fitting;
    Presets others;
};
PresetsForVolume presetsForVolume(const Presets& all, const Volume& volume);

}  // namespace macula::app
