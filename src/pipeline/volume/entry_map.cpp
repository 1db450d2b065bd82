#include "pipeline/volume/entry_map.h"

#include <algorithm>

#include "base/parallel.h"

namespace macula {

namespace {
constexpr int kMostEntries = 65536;  // an entry is stored in 16 bits
}

EntryMap entryMapOf(const Volume& volume) {
    const StoredRange range = volume.storedRange();
    EntryMap map{range.low, range.high, range.low, volume.padding()};
    if (map.padding) {
        // Padding becomes air, but below all measured values, to be distinguishable from air in the scan. If
        // the data fill all entries, it shares the lowest one.
        map.air = std::max(std::min(volume.airStored(), int(range.low) - 1), map.high - (kMostEntries - 1));
        map.low = std::min(map.low, map.air);
    }
    return map;
}

void writeEntries(const Volume& volume, const EntryMap& map, std::size_t first,
                  std::span<std::uint16_t> entries) {
    const auto voxels = volume.voxels().subspan(first, entries.size());
    inChunks(entries.size(), [&](std::size_t begin, std::size_t count) {
        for (std::size_t i = begin; i < begin + count; ++i) entries[i] = map.entryOf(voxels[i]);
    });
}

}  // namespace macula
