// A volume under a transfer function, as tables the tracer reads: what light meets at each stored value, and
// a bound on it for every brick.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/transfer_function.h"

namespace macula {

// Positions in the tables: entry 0 is stored value `low`. There is one entry for each stored value, so that
// narrow bands and steps of a curve are kept exactly where voxels can tell them apart.
struct EntryMap {
    std::uint16_t low = 0;
    std::uint16_t high = 0;
    std::uint16_t air = 0;  // what padding becomes
    std::optional<StoredRange> padding;

    // One more than there are stored values: interpolation at the last one reads its neighbour.
    std::size_t tableSize() const { return std::size_t(high - low) + 2; }
    std::uint16_t entryOf(std::uint16_t stored) const {
        return static_cast<std::uint16_t>((padding && padding->contains(stored) ? air : stored) - low);
    }
};

EntryMap entryMapOf(const Volume& volume);
// Writes the entry of each voxel of [first, first + entries.size()). On all cores.
void writeEntries(const Volume& volume, const EntryMap& map, std::size_t first,
                  std::span<std::uint16_t> entries);

struct Medium {
    std::vector<float> extinctionPerMm;  // by entry
    std::vector<glm::vec4> albedo;       // by entry; linear RGB, w unused
    glm::ivec3 gridSize{0};
    // By brick, see shaders/lib/brick_walk.glsl: a bound above the extinction anywhere in the brick, rounded
    // up; or, in an empty brick, minus the Chebyshev distance in bricks to the nearest that is not, at most
    // 255.
    std::vector<float> bounds;
    float anisotropy = 0.0f;

    std::size_t visibleBricks() const;
};

// `function` is used as it is: fit it to the volume before.
Medium makeMedium(const Volume& volume, const BrickGrid& grid, const TransferFunction& function);

}  // namespace macula
