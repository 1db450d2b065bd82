// Which blocks are kept coarsely when not all fit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/voxel_blocks.h"

namespace macula {

struct Coarsening {
    std::vector<std::uint8_t> levels;  // by block; kAbsent where nothing is to be shown
    std::uint64_t slots = 0;           // of kSlotValues, that the pool needs for them
    std::uint64_t slotsWanted = 0;     // that it would need if nothing were lost
    std::size_t coarse = 0;            // blocks that lose something
    std::uint8_t coarsest = 0;         // level of any of them
};

// A slot of the pool holds blocks of one level: 1, 8 or 64 of them.
inline constexpr std::uint32_t kSlotValues = poolValues(kFullLevel);

// The levels at which what is to be shown (blocksToShow) fits into `slots`; it always does, single values
// take none.
//
// A block whose voxels are all alike is always kept as a single value, which loses nothing. Otherwise those
// blocks are coarsened first whose extinction varies least, for that is what light can tell apart: within
// opaque or evenly thin matter nothing is lost but shades of colour, so among equals those go first whose
// values vary least. No block goes on to the next level while another has not come to this one: the worst
// that is seen stays as fine as it can be.
Coarsening fitBlocks(const BrickGrid& grid, std::span<const std::uint8_t> show,
                     std::span<const float> extinctionPerMm, std::uint64_t slots);

}  // namespace macula
