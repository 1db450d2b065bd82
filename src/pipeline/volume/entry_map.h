// Positions in the optical tables: entry 0 is stored value `low`. There is one entry for each stored value,
// so that narrow bands and steps of a curve are kept exactly where voxels can tell them apart.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/volume.h"

namespace macula {

struct EntryMap {
    int low = 0;  // may lie below 0, where padding is air that the data cannot hold
    int high = 0;
    int air =
        0;  // what padding becomes, and no voxel that was measured (unless these take all 65536 entries)
    std::optional<StoredRange> padding;

    // One more than there are stored values: interpolation at the last one reads its neighbour.
    std::size_t tableSize() const { return std::size_t(high - low) + 2; }
    std::uint16_t entryOf(std::uint16_t stored) const {
        return static_cast<std::uint16_t>((padding && padding->contains(stored) ? air : int(stored)) - low);
    }
};

EntryMap entryMapOf(const Volume& volume);

// Writes the entry of each voxel of [first, first + entries.size()). On all cores.
void writeEntries(const Volume& volume, const EntryMap& map, std::size_t first,
                  std::span<std::uint16_t> entries);

}  // namespace macula
