// The built-in presets: Macula's own and 3D Slicer's.
#pragma once

#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::presets {

// Macula's own presets, then 3D Slicer's, each by number.
Result<std::vector<TransferFunction>> builtInPresets();

// Whether the typed text means this preset: its name in any case ("CT-Bone", "ct-bone"), or its number.
bool isMeant(const TransferFunction& preset, std::string_view typed);

}  // namespace macula::presets
