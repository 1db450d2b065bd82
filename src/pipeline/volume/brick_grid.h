// Two divisions of a volume, with the range of values in each part: bricks of 8 x 8 x 8 cells between voxel
// centres, which light crosses, and blocks of 8 x 8 x 8 voxels, which are stored.
//
// Brick b covers [8b - 1, 8b + 7) along each axis, in voxel coordinates with integers at centres. So
// interpolation inside it needs only voxels 8b - 1 to 8b + 7: block b, and the last layer of block b - 1. If
// it reads values up to `reach` voxels farther away (0 or 1), it needs as many more at both ends, and so the
// first layer of block b + 1.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/volume.h"

namespace macula {

inline constexpr int kBrickVoxels = 8;  // BRICK in shaders/lib

// Closed interval of entries (entry_map.h).
struct EntryRange {
    std::uint16_t low = 0;
    std::uint16_t high = 0;

    bool operator==(const EntryRange&) const = default;
};

struct BrickGrid {
    int reach = 0;                        // voxels
    glm::ivec3 size{0};                   // bricks
    std::vector<EntryRange> ranges;       // by brick, x fastest: of all voxels that interpolation needs
    glm::ivec3 blocks{0};                 // along each axis as many as bricks, or one fewer
    std::vector<EntryRange> blockRanges;  // by block, x fastest

    std::size_t index(int x, int y, int z) const {
        return (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x) + std::size_t(x);
    }
    std::size_t blockIndex(int x, int y, int z) const {
        return (std::size_t(z) * std::size_t(blocks.y) + std::size_t(y)) * std::size_t(blocks.x) +
               std::size_t(x);
    }
    // The first and last block that a brick needs; the first and last brick that needs a block.
    glm::ivec3 firstBlockOf(glm::ivec3 brick) const { return glm::max(brick - 1, glm::ivec3(0)); }
    glm::ivec3 lastBlockOf(glm::ivec3 brick) const { return glm::min(brick + reach, blocks - 1); }
    glm::ivec3 firstBrickOf(glm::ivec3 block) const { return glm::max(block - reach, glm::ivec3(0)); }
    glm::ivec3 lastBrickOf(glm::ivec3 block) const { return glm::min(block + 1, size - 1); }

    // The brick that holds a point within the volume, given with integers at voxel faces.
    glm::ivec3 brickAt(const glm::dvec3& point) const {
        return glm::ivec3(glm::floor((point + 0.5) / double(kBrickVoxels)));
    }
};

// Bricks and blocks of a volume of `voxels`.
glm::ivec3 brickCount(glm::ivec3 voxels);
glm::ivec3 blockCount(glm::ivec3 voxels);

// Padding counts as air. Uses all cores.
BrickGrid makeBrickGrid(const Volume& volume, int reach = 0);

}  // namespace macula
