// Converts what the user typed after --preset to a transfer function.
#pragma once

#include <string>

#include "base/result.h"
#include "pipeline/volume/transfer_function.h"
#include "presets/imported_preset.h"

namespace macula::scene {

// A built-in preset by name or number, or a file of any known format, "FILE#NAME" where it holds several.
// usage when it is none of these; inputNotUsable when the file is malformed.
Result<presets::ImportedPreset> choosePreset(const std::string& typed);

// The name to show in a picture or a report: a built-in name, otherwise "custom", because the name of a
// user's file may identify a person.
std::string publicPresetName(const std::string& typed);
// The same for a preset itself; a fit to the volume does not make a built-in one custom.
std::string publicPresetName(const TransferFunction& preset);

}  // namespace macula::scene
