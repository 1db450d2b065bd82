// Which blocks are stored coarsely if not all fit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/voxel_blocks.h"

namespace macula {

struct Coarsening {
    std::vector<std::uint8_t> levels;  // by block; kAbsent for blocks not to be shown
    std::uint64_t slots = 0;           // of kSlotValues each, which the pool needs
    std::uint64_t slotsWanted = 0;     // which it would need without loss
    std::size_t coarse = 0;            // blocks that lose detail
    std::uint8_t coarsest = 0;         // the coarsest level
};

// A slot of the pool holds blocks of one level: 1, 8 or 64 of them.
inline constexpr std::uint32_t kSlotValues = poolValues(kFullLevel);

// The levels at which the blocks of `show` (blocksToShow) fit into `slots`. They always do, because single
// values take no slot.
//
// A block whose voxels are equal is always stored as a single value, without loss. Otherwise the blocks whose
// extinction varies least are coarsened first, because extinction is what a picture shows: within opaque or
// evenly thin matter only shades of colour are lost. Among equals those whose values vary least come first.
// No block moves on to the next level before all others have reached this one, so that the coarsest visible
// block is as fine as possible.
Coarsening fitBlocks(const BrickGrid& grid, std::span<const std::uint8_t> show,
                     std::span<const float> extinctionPerMm, std::uint64_t slots);

}  // namespace macula
