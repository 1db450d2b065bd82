#include "pipeline/trace/brick_copies.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

namespace macula::trace {

namespace {

// Three quarters of a megabyte for each thread, which most caches of a core can hold.
constexpr std::size_t kMostCopies = 256;
// A brick has its copy in one of so many places, unless lanes hold all of these.
constexpr std::size_t kPlaces = 4;

}  // namespace

BrickCopies::BrickCopies(const PooledVoxels& voxels, const glm::ivec3& size, int reach)
    : voxels_(voxels), last_(size - 1), reach_(reach) {
    const auto bricks = std::size_t(voxels.grid.x) * std::size_t(voxels.grid.y) * std::size_t(voxels.grid.z);
    const std::size_t copies = std::min(kMostCopies, std::bit_ceil(bricks + kHolders));
    values_ = std::make_unique_for_overwrite<std::uint16_t[]>(copies * std::size_t(kValues));
    // Lanes that hold no copy read the first one.
    std::fill_n(values_.get(), kValues, std::uint16_t(0));
    bricks_.assign(copies, -1);
    holders_.assign(copies, 0);
    std::fill(std::begin(held_), std::end(held_), kNone);
}

std::int32_t BrickCopies::hold(std::size_t lane, const glm::ivec3& brick) {
    const std::int64_t index = (std::int64_t(brick.z) * voxels_.grid.y + brick.y) * voxels_.grid.x + brick.x;
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
        copy(brick, values_.get() + found * std::size_t(kValues));
    }
    ++holders_[found];
    held_[lane] = found;
    return std::int32_t(found) * kValues;
}

BrickCopies::Parts BrickCopies::partsAlong(int brick, int last) const {
    const int first = 8 * brick;
    Parts parts;
    if (brick > 0) parts.before = {brick - 1, 7 - reach_, 1 + reach_, 1 - reach_};
    if (first <= last) parts.within = {brick, 0, std::min(8, last - first + 1), 2};
    if (reach_ > 0 && first + 8 <= last) parts.after = {brick + 1, 0, 1, kEdge - 1};
    return parts;
}

void BrickCopies::copy(const glm::ivec3& brick, std::uint16_t* to) const {
    const Parts x = partsAlong(brick.x, last_.x);
    const Parts y = partsAlong(brick.y, last_.y);
    const Parts z = partsAlong(brick.z, last_.z);
    for (const Part& alongZ : {z.before, z.within, z.after}) {
        if (alongZ.count == 0) continue;
        for (const Part& alongY : {y.before, y.within, y.after}) {
            if (alongY.count == 0) continue;
            copyPart(x.before, alongY, alongZ, to);
            copyPart(x.within, alongY, alongZ, to);
            copyPart(x.after, alongY, alongZ, to);
        }
    }
    repeatOuter(brick.x, last_.x, 1, to);
    repeatOuter(brick.y, last_.y, kRow, to);
    repeatOuter(brick.z, last_.z, kLayer, to);
}

// Repeats the volume's outer voxels along the axis on which neighbours are `stride` values apart. Where
// another axis is still to be repeated, this copies voxels that nobody has set; that axis then sets them.
void BrickCopies::repeatOuter(int brick, int last, int stride, std::uint16_t* to) const {
    const int lowest = brick == 0 ? 2 : 0;
    const int highest = std::min(last - (8 * brick - 2), kEdge - 1);
    if (lowest == 0 && highest == kEdge - 1) return;
    const int a = stride == 1 ? kRow : 1;
    const int b = stride == kLayer ? kRow : kLayer;
    for (int j = 0; j < kEdge; ++j) {
        for (int i = 0; i < kEdge; ++i) {
            std::uint16_t* const line = to + j * b + i * a;
            for (int k = lowest - 1; k >= 0; --k) line[k * stride] = line[lowest * stride];
            for (int k = highest + 1; k < kEdge; ++k) line[k * stride] = line[highest * stride];
        }
    }
}

void BrickCopies::copyPart(const Part& x, const Part& y, const Part& z, std::uint16_t* to) const {
    if (x.count == 0) return;
    const std::uint32_t word = voxels_.wordsOf({x.block, y.block, 0}, z.block)[3];
    const std::uint32_t unitOrValue = word & 0x3fffffffu;
    std::uint16_t* const first = to + z.to * kLayer + y.to * kRow + x.to;
    if (word >> 30 != kFullLevel) {
        for (int k = 0; k < z.count; ++k)
            for (int j = 0; j < y.count; ++j)
                for (int i = 0; i < x.count; ++i)
                    first[k * kLayer + j * kRow + i] =
                        std::uint16_t(voxels_.valueIn(word, {x.first + i, y.first + j, z.first + k}));
        return;
    }
    const std::uint16_t* const from = voxels_.pool + (std::size_t(unitOrValue) << 3) +
                                      std::size_t((z.first << 6) | (y.first << 3) | x.first);
    const auto copyRows = [&](auto bytes) {
        for (int k = 0; k < z.count; ++k)
            for (int j = 0; j < y.count; ++j)
                std::memcpy(first + k * kLayer + j * kRow, from + 64 * k + 8 * j, bytes);
    };
    // Of these lengths almost all rows are, and the compiler knows them.
    if (x.count == 8) return copyRows(std::integral_constant<std::size_t, 16>());
    if (x.count == 1) return copyRows(std::integral_constant<std::size_t, 2>());
    if (x.count == 2) return copyRows(std::integral_constant<std::size_t, 4>());
    copyRows(2 * std::size_t(x.count));
}

}  // namespace macula::trace
