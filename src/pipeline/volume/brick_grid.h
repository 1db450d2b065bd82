// The volume cut into bricks of 8 x 8 x 8 voxels, with the range of values that can be met in each.
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
};

struct BrickGrid {
    glm::ivec3 size{0};  // bricks
    std::vector<EntryRange>
        ranges;  // x fastest; over the brick and one voxel around it: what interpolation can reach

    std::size_t index(int x, int y, int z) const {
        return (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x) + std::size_t(x);
    }
};

// Padding counts as air. On all cores.
BrickGrid makeBrickGrid(const Volume& volume);

}  // namespace macula
