// The allocator of the pool of voxels. It only keeps account of which part is free; the voxels are on the
// device.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/volume/coarsening.h"

namespace macula {

// A slab allocator for blocks of voxels: a row of slots, each free or divided into blocks of one level. So
// the pool is never compacted, and a slot that has become empty takes blocks of any level again.
class BlockPool {
  public:
    std::uint64_t slots() const { return slots_.size(); }
    std::uint64_t freeSlots() const { return free_.size(); }

    // Adds slots behind the others.
    void grow(std::uint64_t slots);

    // Where the block begins, in units of 8 values; nothing when there is no room. `level` below kSingle.
    std::optional<std::uint32_t> allocate(std::uint8_t level);
    // Frees what allocate() gave for that level.
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
