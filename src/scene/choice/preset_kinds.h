// Which presets are made for what kind of images.
#pragma once

#include <string>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::scene {

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
