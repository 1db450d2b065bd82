#include "pipeline/volume/brick_grid.h"

#include <algorithm>

#include "base/parallel.h"
#include "pipeline/volume/entry_map.h"

namespace macula {

namespace {

// Over the voxels of a box, both corners included.
EntryRange rangeOf(const Volume& volume, const EntryMap& map, glm::ivec3 low, glm::ivec3 high) {
    const glm::ivec3 size = volume.size();
    const auto voxels = volume.voxels();
    EntryRange range{0xffff, 0};
    for (int k = low.z; k <= high.z; ++k) {
        for (int j = low.y; j <= high.y; ++j) {
            const std::size_t row =
                (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x);
            for (int i = low.x; i <= high.x; ++i) {
                const std::uint16_t entry = map.entryOf(voxels[row + std::size_t(i)]);
                range.low = std::min(range.low, entry);
                range.high = std::max(range.high, entry);
            }
        }
    }
    return range;
}

}  // namespace

BrickGrid makeBrickGrid(const Volume& volume) {
    const glm::ivec3 voxels = volume.size();
    const EntryMap map = entryMapOf(volume);
    BrickGrid grid;
    grid.size = (voxels + glm::ivec3(kBrickVoxels - 1)) / kBrickVoxels;
    grid.ranges.resize(std::size_t(grid.size.x) * std::size_t(grid.size.y) * std::size_t(grid.size.z));
    parallelFor(std::size_t(grid.size.z) * std::size_t(grid.size.y), [&](std::size_t row) {
        const int z = static_cast<int>(row) / grid.size.y;
        const int y = static_cast<int>(row) % grid.size.y;
        for (int x = 0; x < grid.size.x; ++x) {
            const glm::ivec3 low = glm::max(glm::ivec3(x, y, z) * kBrickVoxels - 1, glm::ivec3(0));
            const glm::ivec3 high = glm::min((glm::ivec3(x, y, z) + 1) * kBrickVoxels, voxels - 1);
            grid.ranges[grid.index(x, y, z)] = rangeOf(volume, map, low, high);
        }
    });
    return grid;
}

}  // namespace macula
