#include "pipeline/volume/brick_grid.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/volume/entry_map.h"

namespace macula {

namespace {

// The empty range: a join with it gives the other range.
constexpr EntryRange kNone{0xffff, 0};

EntryRange join(EntryRange a, EntryRange b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

// The range over the voxels of a box, both corners included; kNone when it is empty.
EntryRange rangeOf(const Volume& volume, const EntryMap& map, glm::ivec3 low, glm::ivec3 high) {
    const glm::ivec3 size = volume.size();
    const auto voxels = volume.voxels();
    EntryRange range = kNone;
    for (int k = low.z; k <= high.z; ++k) {
        for (int j = low.y; j <= high.y; ++j) {
            const std::size_t row =
                (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x);
            for (int i = low.x; i <= high.x; ++i) {
                const std::uint16_t entry = map.entryOf(voxels[row + std::size_t(i)]);
                range = join(range, {entry, entry});
            }
        }
    }
    return range;
}

// The same for a whole block without padding: eight columns side by side, so that compilers vectorise.
EntryRange rangeOfWhole(const Volume& volume, const EntryMap& map, glm::ivec3 low) {
    const glm::ivec3 size = volume.size();
    std::array<std::uint16_t, kBrickVoxels> least{};
    std::array<std::uint16_t, kBrickVoxels> most{};
    least.fill(0xffff);
    for (int k = low.z; k < low.z + kBrickVoxels; ++k) {
        for (int j = low.y; j < low.y + kBrickVoxels; ++j) {
            const std::uint16_t* row =
                volume.voxels().data() +
                (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x) +
                std::size_t(low.x);
            for (std::size_t i = 0; i < kBrickVoxels; ++i) {
                least[i] = std::min(least[i], row[i]);
                most[i] = std::max(most[i], row[i]);
            }
        }
    }
    return {map.entryOf(*std::min_element(least.begin(), least.end())),
            map.entryOf(*std::max_element(most.begin(), most.end()))};
}

EntryRange blockRange(const Volume& volume, const EntryMap& map, glm::ivec3 block) {
    const glm::ivec3 low = block * kBrickVoxels;
    const glm::ivec3 high = low + kBrickVoxels - 1;
    if (!map.padding && glm::all(glm::lessThan(high, volume.size()))) return rangeOfWhole(volume, map, low);
    return rangeOf(volume, map, low, glm::min(high, volume.size() - 1));
}

// Joins the range of the brick's own block with those of the layers of voxels that it reaches below and above
// along each axis.
EntryRange brickRange(const Volume& volume, const EntryMap& map, const BrickGrid& grid, glm::ivec3 brick) {
    const glm::ivec3 first = brick * kBrickVoxels;
    const glm::ivec3 last = glm::min(first + kBrickVoxels - 1, volume.size() - 1);
    const glm::ivec3 low = glm::max(first - 1 - grid.reach, glm::ivec3(0));
    const glm::ivec3 high = glm::min(first + kBrickVoxels - 1 + grid.reach, volume.size() - 1);
    EntryRange range = kNone;
    if (glm::all(glm::lessThan(brick, grid.blocks)))
        range = grid.blockRanges[grid.blockIndex(brick.x, brick.y, brick.z)];
    const auto add = [&](const glm::ivec3& from, const glm::ivec3& to) {
        range = join(range, rangeOf(volume, map, from, to));
    };
    add(low, {first.x - 1, high.y, high.z});
    add({last.x + 1, low.y, low.z}, high);
    add({first.x, low.y, low.z}, {last.x, first.y - 1, high.z});
    add({first.x, last.y + 1, low.z}, {last.x, high.y, high.z});
    add({first.x, first.y, low.z}, {last.x, last.y, first.z - 1});
    add({first.x, first.y, last.z + 1}, {last.x, last.y, high.z});
    return range;
}

}  // namespace

glm::ivec3 brickCount(glm::ivec3 voxels) {
    return voxels / kBrickVoxels + 1;
}

glm::ivec3 blockCount(glm::ivec3 voxels) {
    return (voxels + glm::ivec3(kBrickVoxels - 1)) / kBrickVoxels;
}

BrickGrid makeBrickGrid(const Volume& volume, int reach) {
    MACULA_CHECK(reach == 0 || reach == 1);
    const EntryMap map = entryMapOf(volume);
    BrickGrid grid;
    grid.reach = reach;
    grid.size = brickCount(volume.size());
    grid.blocks = blockCount(volume.size());
    grid.ranges.resize(grid.index(0, 0, grid.size.z));
    grid.blockRanges.resize(grid.blockIndex(0, 0, grid.blocks.z));
    parallelFor(std::size_t(grid.blocks.z) * std::size_t(grid.blocks.y), [&](std::size_t row) {
        const int z = static_cast<int>(row) / grid.blocks.y;
        const int y = static_cast<int>(row) % grid.blocks.y;
        for (int x = 0; x < grid.blocks.x; ++x)
            grid.blockRanges[grid.blockIndex(x, y, z)] = blockRange(volume, map, {x, y, z});
    });
    parallelFor(std::size_t(grid.size.z) * std::size_t(grid.size.y), [&](std::size_t row) {
        const int z = static_cast<int>(row) / grid.size.y;
        const int y = static_cast<int>(row) % grid.size.y;
        for (int x = 0; x < grid.size.x; ++x)
            grid.ranges[grid.index(x, y, z)] = brickRange(volume, map, grid, {x, y, z});
    });
    return grid;
}

}  // namespace macula
