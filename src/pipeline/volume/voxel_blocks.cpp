#include "pipeline/volume/voxel_blocks.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/parallel.h"

namespace macula {

namespace {

// The row of voxels along x that begins at a voxel.
const std::uint16_t* rowAt(const Volume& volume, glm::ivec3 voxel) {
    const glm::ivec3 size = volume.size();
    return volume.voxels().data() +
           (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) * std::size_t(size.x) +
           std::size_t(voxel.x);
}

// The average over those voxels of a cube that lie within the volume; 0 if there are none.
std::uint16_t average(const Volume& volume, const EntryMap& map, glm::ivec3 low, int edge) {
    const glm::ivec3 end = glm::min(low + edge, volume.size());
    std::uint64_t sum = 0;
    std::uint64_t count = 0;
    for (int k = low.z; k < end.z; ++k) {
        for (int j = low.y; j < end.y; ++j) {
            const std::uint16_t* row = rowAt(volume, {low.x, j, k});
            for (int i = 0; i < end.x - low.x; ++i) sum += map.entryOf(row[i]);
            count += static_cast<std::uint64_t>(std::max(end.x - low.x, 0));
        }
    }
    return count > 0 ? static_cast<std::uint16_t>((sum + count / 2) / count) : std::uint16_t(0);
}

void writeFull(const Volume& volume, const EntryMap& map, glm::ivec3 low, std::span<std::uint16_t> values) {
    const glm::ivec3 end = glm::min(low + kBrickVoxels, volume.size());
    if (end != low + kBrickVoxels) std::fill(values.begin(), values.end(), std::uint16_t(0));
    for (int k = low.z; k < end.z; ++k) {
        for (int j = low.y; j < end.y; ++j) {
            const std::uint16_t* row = rowAt(volume, {low.x, j, k});
            std::uint16_t* to = values.data() + ((k - low.z) * kBrickVoxels + (j - low.y)) * kBrickVoxels;
            for (int i = 0; i < end.x - low.x; ++i) to[i] = map.entryOf(row[i]);
        }
    }
}

}  // namespace

std::vector<std::uint8_t> blocksToShow(const BrickGrid& grid, std::span<const float> bounds,
                                       std::span<const std::uint8_t> alsoShown) {
    MACULA_CHECK_EQ(bounds.size(), grid.ranges.size());
    MACULA_CHECK(alsoShown.empty() || alsoShown.size() == bounds.size());
    std::vector<std::uint8_t> show(grid.blockRanges.size());
    parallelFor(std::size_t(grid.blocks.y) * std::size_t(grid.blocks.z), [&](std::size_t row) {
        const int y = static_cast<int>(row) % grid.blocks.y;
        const int z = static_cast<int>(row) / grid.blocks.y;
        for (int x = 0; x < grid.blocks.x; ++x) {
            const glm::ivec3 first = grid.firstBrickOf({x, y, z});
            const glm::ivec3 last = grid.lastBrickOf({x, y, z});
            bool touched = false;
            for (int k = first.z; k <= last.z; ++k) {
                for (int j = first.y; j <= last.y; ++j) {
                    for (int i = first.x; i <= last.x; ++i) {
                        const std::size_t brick = grid.index(i, j, k);
                        touched |= bounds[brick] > 0.0f || (!alsoShown.empty() && alsoShown[brick]);
                    }
                }
            }
            show[grid.blockIndex(x, y, z)] = touched ? 1 : 0;
        }
    });
    return show;
}

void addReachOfGradients(const BrickGrid& grid, std::span<const float> bounds,
                         std::vector<std::uint8_t>& alsoShown) {
    MACULA_CHECK_EQ(bounds.size(), grid.ranges.size());
    MACULA_CHECK(alsoShown.empty() || alsoShown.size() == bounds.size());
    const std::vector<std::uint8_t> marked = std::move(alsoShown);
    alsoShown.assign(bounds.size(), 0);
    const auto needed = [&](std::size_t brick) {
        return bounds[brick] > 0.0f || (!marked.empty() && marked[brick]);
    };
    parallelFor(std::size_t(grid.size.y) * std::size_t(grid.size.z), [&](std::size_t row) {
        const int y = static_cast<int>(row) % grid.size.y;
        const int z = static_cast<int>(row) / grid.size.y;
        for (int x = 0; x < grid.size.x; ++x) {
            const std::size_t brick = grid.index(x, y, z);
            bool reached = false;
            for (int below = 0; below < 8; ++below) {
                const glm::ivec3 from =
                    glm::ivec3(x, y, z) - glm::ivec3(below & 1, below >> 1 & 1, below >> 2);
                reached |= glm::all(glm::greaterThanEqual(from, glm::ivec3(0))) &&
                           needed(grid.index(from.x, from.y, from.z));
            }
            alsoShown[brick] = reached ? 1 : 0;
        }
    });
}

void writeBlock(const Volume& volume, const EntryMap& map, glm::ivec3 block, std::uint8_t level,
                std::span<std::uint16_t> values) {
    MACULA_CHECK_LT(level, kSingle);
    MACULA_CHECK_EQ(values.size(), std::size_t(poolValues(level)));
    const glm::ivec3 low = block * kBrickVoxels;
    if (level == kFullLevel) return writeFull(volume, map, low, values);
    const int edge = 1 << level;
    const int side = kBrickVoxels >> level;
    std::size_t at = 0;
    for (int k = 0; k < side; ++k) {
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i)
                values[at++] = average(volume, map, low + glm::ivec3(i, j, k) * edge, edge);
        }
    }
}

std::uint16_t singleValue(const Volume& volume, const EntryMap& map, glm::ivec3 block) {
    return average(volume, map, block * kBrickVoxels, kBrickVoxels);
}

}  // namespace macula
