// Finds out whether a preset shows anything of a volume.
#pragma once

#include <cstdint>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::presets {

// Counts the stored values of an evenly spaced sample of the voxels of a volume, large enough to find what a
// thousandth of them hold. The volume must be stored16, and outlive this object.
class SeenValues {
  public:
    explicit SeenValues(const Volume& volume);

    // Whether more than a thousandth of the voxels holds matter that would be visible at the thickness of a
    // hand's breadth. False for a volume that is all padding.
    bool areSeenWith(const TransferFunction& preset) const;

  private:
    const Volume& volume_;
    std::vector<std::uint32_t> counts_;  // by stored value
    std::uint64_t all_ = 0;
};

}  // namespace macula::presets
