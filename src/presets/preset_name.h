// The name of a preset, and the modality and unit that it tells.
#pragma once

#include <string>
#include <string_view>

#include "base/text.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::presets {

// The key of a preset, typed after --preset and used as its file name: lower-case letters, digits and
// hyphens. "preset" if nothing is left. "CT-Coronary-Arteries-2" becomes "ct-coronary-arteries-2".
std::string keyFrom(std::string_view title);

// Sets name and title, and the modality and unit with which the title begins, as 3D Slicer's titles do: CT,
// MR, DTI, US, uCT (whose values are not Hounsfield units). False if it begins with none of these: it then
// assumes CT in Hounsfield units, and the caller should note that.
bool nameAfter(TransferFunction& function, std::string_view title);

// The note that nameAfter assumed CT in Hounsfield units.
Text assumedHounsfield();

}  // namespace macula::presets
