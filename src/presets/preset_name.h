// What a preset is called, and what its name says about it.
#pragma once

#include <string>
#include <string_view>

#include "base/text.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::presets {

// The key of a preset, typed after --preset and used as its file name: lower-case letters, digits and
// hyphens. "preset" when nothing is left. "CT-Coronary-Arteries-2" becomes "ct-coronary-arteries-2".
std::string keyFrom(std::string_view title);

// Sets name and title, and the modality and unit that the title begins with, as 3D Slicer's do: CT, MR, DTI,
// US, uCT (whose values are no Hounsfield units). False when it begins with none of these: then CT in
// Hounsfield units is set, and should be said.
bool nameAfter(TransferFunction& function, std::string_view title);

// The note that nameAfter assumed CT in Hounsfield units.
Text assumedHounsfield();

}  // namespace macula::presets
