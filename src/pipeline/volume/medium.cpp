#include "pipeline/volume/medium.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/volume/clip_bricks.h"
#include "pipeline/volume/empty_space.h"
#include "pipeline/volume/range_max.h"
#include "pipeline/volume/voxel_blocks.h"

namespace macula {

namespace {

// Interpolating two entries in floating point can come out a few parts in 10^7 above both.
constexpr float kOutward = 1.0f + 1e-6f;

double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

// Calls body(x, y, z) for every brick, rows on all cores.
template <class Body>
void forEachBrick(glm::ivec3 size, const Body& body) {
    parallelFor(std::size_t(size.y) * std::size_t(size.z), [&](std::size_t row) {
        const int y = static_cast<int>(row) % size.y;
        const int z = static_cast<int>(row) / size.y;
        for (int x = 0; x < size.x; ++x) body(x, y, z);
    });
}

}  // namespace

std::size_t Medium::visibleBricks() const {
    return static_cast<std::size_t>(
        std::count_if(bounds.begin(), bounds.end(), [](float b) { return b > 0.0f; }));
}

Medium makeMedium(const Volume& volume, const BrickGrid& grid, const TransferFunction& function,
                  const Clip& clip, const MaskBits* mask) {
    MACULA_CHECK(!usesGradientOpacity(function));
    const EntryMap map = entryMapOf(volume);
    const UnitsFromStored units = volume.unitsFromStored();

    Medium medium;
    medium.anisotropy = static_cast<float>(function.anisotropy);
    medium.extinctionPerMm.resize(map.tableSize());
    medium.albedo.resize(map.tableSize());
    for (std::size_t entry = 0; entry + 1 < map.tableSize(); ++entry) {
        const double value = units(double(map.low) + double(entry));
        const glm::dvec3 colour = colourAt(function, value);
        medium.extinctionPerMm[entry] = static_cast<float>(extinctionPerMm(function, value));
        medium.albedo[entry] =
            glm::vec4(function.albedo * linearFromSrgb(colour.r), function.albedo * linearFromSrgb(colour.g),
                      function.albedo * linearFromSrgb(colour.b), 0.0);
    }
    medium.extinctionPerMm.back() = medium.extinctionPerMm[map.tableSize() - 2];
    medium.albedo.back() = medium.albedo[map.tableSize() - 2];

    const RangeMax largest(medium.extinctionPerMm);
    medium.gridSize = grid.size;
    medium.bounds.resize(grid.ranges.size());
    forEachBrick(grid.size, [&](int x, int y, int z) {
        const std::size_t brick = grid.index(x, y, z);
        medium.bounds[brick] = largest(grid.ranges[brick].low, grid.ranges[brick].high) * kOutward;
    });
    emptyRemovedBricks(clip, volume, grid, medium.bounds);
    if (mask != nullptr && !clip.removedCastsShadow) emptyMaskedBricks(*mask, grid, medium.bounds);
    measureEmptySpace(grid.size, medium.bounds);
    return medium;
}

void coverCoarseBlocks(Medium& medium, const BrickGrid& grid, std::span<const std::uint8_t> levels) {
    MACULA_CHECK_EQ(levels.size(), grid.blockRanges.size());
    const RangeMax largest(medium.extinctionPerMm);
    forEachBrick(grid.size, [&](int x, int y, int z) {
        float& bound = medium.bounds[grid.index(x, y, z)];
        if (!(bound > 0.0f)) return;
        EntryRange range = grid.ranges[grid.index(x, y, z)];
        const glm::ivec3 low = glm::max(glm::ivec3(x, y, z) - 1, glm::ivec3(0));
        const glm::ivec3 high = glm::min(glm::ivec3(x, y, z), grid.blocks - 1);
        for (int k = low.z; k <= high.z; ++k) {
            for (int j = low.y; j <= high.y; ++j) {
                for (int i = low.x; i <= high.x; ++i) {
                    const std::size_t block = grid.blockIndex(i, j, k);
                    if (levels[block] == 0 || levels[block] == kAbsent) continue;
                    range.low = std::min(range.low, grid.blockRanges[block].low);
                    range.high = std::max(range.high, grid.blockRanges[block].high);
                }
            }
        }
        bound = largest(range.low, range.high) * kOutward;
    });
}

}  // namespace macula
