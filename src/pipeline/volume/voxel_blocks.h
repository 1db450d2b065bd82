// Voxels as they are kept on the device: only in the blocks that light can reach, and coarsely where there is
// no room. Blocks are those of brick_grid.h; lists by block are x fastest.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/entry_map.h"

namespace macula {

// How a block is kept: 0 every voxel, 1 averages of 2 x 2 x 2, 2 of 4 x 4 x 4, and kSingle one average of
// all.
inline constexpr std::uint8_t kFullLevel = 0;
inline constexpr std::uint8_t kSingle = 3;
inline constexpr std::uint8_t kAbsent = 255;  // not kept: no visible brick touches it

// The number of values that a block takes in the pool, by its level: 512, 64, 8. A single value takes none:
// it lies in the table (see blockWord).
constexpr std::uint32_t poolValues(std::uint8_t level) {
    return level < kSingle ? 512u >> (3 * level) : 0u;
}

// What the shaders read of a block, in trace/host.glsl: the level above, below either where its values begin
// in the pool, in units of 8 values, or the single value.
constexpr std::uint32_t blockWord(std::uint8_t level, std::uint32_t unitOrValue) {
    return (std::uint32_t(level) << 30) | unitOrValue;
}

// Marks the blocks to keep: 1 where a brick touches the block that is visible (`bounds` above 0) or marked in
// `alsoShown`, 0 elsewhere. Both are lists by brick; `alsoShown` may be empty. On all cores.
std::vector<std::uint8_t> blocksToShow(const BrickGrid& grid, std::span<const float> bounds,
                                       std::span<const std::uint8_t> alsoShown = {});

// Gradients take differences to a voxel on either side, also across (shaders/lib/material.glsl), and so reach
// into the next bricks up, corners as well (what they reach below, a brick touches itself): these are marked
// in `alsoShown` (by brick, or empty: none), for the visible bricks and for those that are marked already.
void addReachOfGradients(const BrickGrid& grid, std::span<const float> bounds,
                         std::vector<std::uint8_t>& alsoShown);

// Writes a block's entries at a level below kSingle, x fastest, poolValues(level) of them. Averages are of
// entries, rounded to the nearest. Beyond the volume values are 0, and never read.
void writeBlock(const Volume& volume, const EntryMap& map, glm::ivec3 block, std::uint8_t level,
                std::span<std::uint16_t> values);

// The average of a whole block.
std::uint16_t singleValue(const Volume& volume, const EntryMap& map, glm::ivec3 block);

}  // namespace macula
