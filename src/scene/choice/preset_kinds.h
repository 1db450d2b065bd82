// Which presets are made for what kind of images.
#pragma once

#include <string>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::app {

// For people, by what the preset says of itself: "CT", "µCT", "MR", "DTI", "US", "PT", "CT, MR"; empty where
// it says nothing. Micro-CT calls its modality CT and has raw numbers; diffusion has its name only.
std::string kindOf(const TransferFunction& preset);

// Tells which presets are made for the values and the modality of a volume, as far as both say. What it is
// shown with when nobody chose counts as one of them; that is asked of the voxels, once.
class FitsVolume {
  public:
    explicit FitsVolume(const Volume& volume);
    bool operator()(const TransferFunction& preset) const;

  private:
    Unit unit_;
    std::string modality_;
    std::string usual_;
};

}  // namespace macula::app
