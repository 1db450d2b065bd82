#include "pipeline/trace/brick_copies.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace macula::trace {

namespace {

// One and a half megabytes for each thread, which most caches of a core can hold.
constexpr std::size_t kMostCopies = 512;
// A brick has its copy in one of so many places, unless lanes hold all of these.
constexpr std::size_t kPlaces = 4;

}  // namespace

BrickCopies::BrickCopies(const PooledVoxels& voxels, const glm::ivec3& size, int reach)
    : voxels_(voxels), last_(size - 1), reach_(reach) {
    const auto bricks = std::size_t(voxels.grid.x) * std::size_t(voxels.grid.y) * std::size_t(voxels.grid.z);
    const std::size_t copies = std::min(kMostCopies, std::bit_ceil(bricks + kHolders));
    values_.resize(copies * std::size_t(kValues));
    bricks_.assign(copies, -1);
    holders_.assign(copies, 0);
    std::fill(std::begin(held_), std::end(held_), kNone);
}

std::int32_t BrickCopies::hold(std::size_t lane, const glm::ivec3& brick) {
    const std::int64_t index =
        (std::int64_t(brick.z) * voxels_.grid.y + brick.y) * voxels_.grid.x + brick.x;
    if (held_[lane] != kNone) {
        if (bricks_[held_[lane]] == index) return std::int32_t(held_[lane]) * kValues;
        --holders_[held_[lane]];
    }
    const std::size_t mask = bricks_.size() - 1;
    // The lower bits of each coordinate, so that bricks near each other have different places.
    const std::size_t place = std::size_t(brick.x * 1 + brick.y * 11 + brick.z * 123);
    std::size_t free = kNone;
    std::size_t found = kNone;
    for (std::size_t i = 0; (i < kPlaces || free == kNone) && found == kNone; ++i) {
        const std::size_t at = (place + i) & mask;
        if (bricks_[at] == index) found = at;
        if (free == kNone && holders_[at] == 0) free = at;
    }
    if (found == kNone) {
        found = free;
        bricks_[found] = index;
        copy(brick, values_.data() + found * std::size_t(kValues));
    }
    ++holders_[found];
    held_[lane] = found;
    return std::int32_t(found) * kValues;
}

void BrickCopies::copy(const glm::ivec3& brick, std::uint16_t* to) const {
    const glm::ivec3 first = 8 * brick - 2;
    for (int k = 1 - reach_; k < kEdge - 1 + reach_; ++k) {
        const int z = std::clamp(first.z + k, 0, last_.z);
        for (int j = 1 - reach_; j < kEdge - 1 + reach_; ++j) {
            const int y = std::clamp(first.y + j, 0, last_.y);
            copyRow({voxels_.wordsOf({0, y >> 3, 0}, z >> 3), y & 7, z & 7}, brick.x,
                    to + k * kLayer + j * kRow);
        }
    }
}

void BrickCopies::copyRow(const Row& row, int brickX, std::uint16_t* to) const {
    const int first = 8 * brickX - 2;
    if (brickX > 0) copyBlockRow(row, brickX - 1, 6, 2, to);
    if (8 * brickX <= last_.x) copyBlockRow(row, brickX, 0, 8, to + 2);
    if (reach_ > 0 && 8 * brickX + 8 <= last_.x) copyBlockRow(row, brickX + 1, 0, 1, to + kEdge - 1);
    if (brickX == 0) to[0] = to[1] = to[2];
    for (int i = std::max(last_.x - first, 0) + 1; i < kEdge; ++i) to[i] = to[i - 1];
}

// Copies `count` voxels from the voxel `first` of a block's row on.
void BrickCopies::copyBlockRow(const Row& row, int block, int first, int count, std::uint16_t* to) const {
    const std::uint32_t word = row.words[4 * std::size_t(block) + 3];
    const std::uint32_t level = word >> 30;
    const std::uint32_t unitOrValue = word & 0x3fffffffu;
    if (level == kFullLevel) {
        const std::uint16_t* const from =
            voxels_.pool + (std::size_t(unitOrValue) << 3) + std::size_t((row.z << 6) | (row.y << 3) | first);
        if (count == 8) {
            std::memcpy(to, from, 8 * sizeof(std::uint16_t));
        } else {
            for (int i = 0; i < count; ++i) to[i] = from[i];
        }
        return;
    }
    for (int i = 0; i < count; ++i)
        to[i] = std::uint16_t(voxels_.valueIn(word, {first + i, row.y, row.z}));
}

}  // namespace macula::trace
