// Indices into the optical tables: entry 0 belongs to the stored value `low`. There is one entry for each
// stored value, so that narrow bands and steps of a curve are as exact as voxels can show.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/volume.h"

namespace macula {

struct EntryMap {
    int low = 0;  // may lie below 0, for padding as air that cannot be stored
    int high = 0;
    int air = 0;  // value of padding; no measured voxel has it, unless these take all 65536 entries
    std::optional<StoredRange> padding;

    // One more than the stored values: interpolation at the last one reads its neighbour.
    std::size_t tableSize() const { return std::size_t(high - low) + 2; }
    std::uint16_t entryOf(std::uint16_t stored) const {
        return static_cast<std::uint16_t>((padding && padding->contains(stored) ? air : int(stored)) - low);
    }
};

EntryMap entryMapOf(const Volume& volume);

// Writes the entries of voxels [first, first + entries.size()). Uses all cores.
void writeEntries(const Volume& volume, const EntryMap& map, std::size_t first,
                  std::span<std::uint16_t> entries);

}  // namespace macula
