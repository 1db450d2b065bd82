// Voxels as they are stored on the device: only in the blocks that light can reach, and coarsely if there is
// too little room. Blocks are those of brick_grid.h; lists by block are x fastest.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/entry_map.h"

namespace macula {

// How a block is stored: 0 every voxel, 1 averages of 2 x 2 x 2, 2 of 4 x 4 x 4, and kSingle one average of
// all.
inline constexpr std::uint8_t kFullLevel = 0;
inline constexpr std::uint8_t kSingle = 3;
inline constexpr std::uint8_t kAbsent = 255;  // not stored: no visible brick touches it

// The number of values that a block takes in the pool, by its level: 512, 64, 8. A single value takes none:
// the table holds it (blockWord).
constexpr std::uint32_t poolValues(std::uint8_t level) {
    return level < kSingle ? 512u >> (3 * level) : 0u;
}

// The word of a block that trace/host.glsl reads: the level in the upper two bits, below them either where
// its values begin in the pool, in units of 8 values, or the single value.
constexpr std::uint32_t blockWord(std::uint8_t level, std::uint32_t unitOrValue) {
    return (std::uint32_t(level) << 30) | unitOrValue;
}

// Marks the blocks to store: 1 if a brick touches the block that is visible (`bounds` above 0) or marked in
// `alsoShown`, else 0. Both are lists by brick; `alsoShown` may be empty. Uses all cores.
std::vector<std::uint8_t> blocksToShow(const BrickGrid& grid, std::span<const float> bounds,
                                       std::span<const std::uint8_t> alsoShown = {});

// Also marks in `alsoShown` (by brick, or empty) the bricks that gradients reach from visible or already
// marked ones. Central differences read one voxel farther on each side (shaders/lib/material.glsl), and so
// reach the next bricks upwards, with corners; downwards a brick touches the blocks anyway.
void addReachOfGradients(const BrickGrid& grid, std::span<const float> bounds,
                         std::vector<std::uint8_t>& alsoShown);

// Writes a block's poolValues(level) entries at a level below kSingle, x fastest. Averages entries, and
// rounds to the nearest. Values beyond the volume are 0, and never read.
void writeBlock(const Volume& volume, const EntryMap& map, glm::ivec3 block, std::uint8_t level,
                std::span<std::uint16_t> values);

// The average of a whole block.
std::uint16_t singleValue(const Volume& volume, const EntryMap& map, glm::ivec3 block);

}  // namespace macula
