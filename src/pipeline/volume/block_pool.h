// The allocator of the pool of voxels. It only records which parts are free; the voxels are on the device.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/volume/coarsening.h"

namespace macula {

// A slab allocator for blocks of voxels: a row of slots, each free or divided into blocks of one level. An
// empty slot takes blocks of any level again, so the pool never needs compaction.
class BlockPool {
  public:
    std::uint64_t slots() const { return slots_.size(); }
    std::uint64_t freeSlots() const { return free_.size(); }

    // Adds slots at the end, up to `slots` in all.
    void grow(std::uint64_t slots);

    // Returns where the block begins, in units of 8 values; nothing if there is no room. `level` below
    // kSingle.
    std::optional<std::uint32_t> allocate(std::uint8_t level);
    // Frees a block that allocate() returned for that level.
    void release(std::uint8_t level, std::uint32_t unit);

  private:
    struct Slot {
        std::uint8_t level = kAbsent;  // kAbsent: free
        std::uint64_t used = 0;        // a bit for each block
    };

    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;  // the last is used next
    // Slots that may have room, by level. Entries may be stale: allocate() checks each.
    std::array<std::vector<std::uint32_t>, kSingle> partial_;
};

}  // namespace macula
