// Converts what the user typed after --preset to a transfer function, and says which presets are made for
// what kind of images.
#pragma once

#include <string>

#include "base/result.h"
#include "base/volume.h"
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

// The kind of images, for display, from the preset's modalities: "CT", "µCT", "MR", "DTI", "US", "PT", "CT,
// MR"; empty without any. CT with raw values is micro-CT; MR titled "DTI-..." is DTI.
std::string kindOf(const TransferFunction& preset);

// Whether a preset is made for the unit and the modality of a volume, where both state them. The volume's
// default preset always fits; the constructor finds it from the voxels.
class FitsVolume {
  public:
    explicit FitsVolume(const Volume& volume);
    bool operator()(const TransferFunction& preset) const;

  private:
    Unit unit_;
    std::string modality_;
    std::string usual_;
};

}  // namespace macula::scene
