#include "pipeline/volume/coarsening.h"

#include <algorithm>

#include "base/check.h"
#include "pipeline/volume/range_max.h"

namespace macula {

namespace {

struct Candidate {
    float extinctionSpan = 0.0f;  // per mm
    std::uint16_t valueSpan = 0;
    std::size_t block = 0;

    bool operator<(const Candidate& other) const {
        if (extinctionSpan != other.extinctionSpan) return extinctionSpan < other.extinctionSpan;
        if (valueSpan != other.valueSpan) return valueSpan < other.valueSpan;
        return block < other.block;  // so that the choice is the same everywhere
    }
};

// The slots for `count` blocks of a level; at most one is partly filled.
std::uint64_t slotsFor(std::uint64_t count, std::uint8_t level) {
    const std::uint64_t perSlot = level < kSingle ? kSlotValues / poolValues(level) : 0;
    return perSlot > 0 ? (count + perSlot - 1) / perSlot : 0;
}

// How many of `count` blocks must move from `level` to the next one.
std::uint64_t toLeave(std::uint64_t count, std::uint8_t level, std::uint64_t slots) {
    const auto fits = [&](std::uint64_t leaving) {
        return slotsFor(count - leaving, level) + slotsFor(leaving, level + 1) <= slots;
    };
    std::uint64_t low = 0;
    std::uint64_t high = count;  // all, even if that does not suffice
    while (low < high) {
        const std::uint64_t middle = low + (high - low) / 2;
        if (fits(middle)) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return high;
}

}  // namespace

Coarsening fitBlocks(const BrickGrid& grid, std::span<const std::uint8_t> show,
                     std::span<const float> extinctionPerMm, std::uint64_t slots) {
    MACULA_CHECK_EQ(show.size(), grid.blockRanges.size());
    Coarsening result;
    result.levels.assign(show.size(), kAbsent);
    std::uint64_t count = 0;
    for (std::size_t block = 0; block < show.size(); ++block) {
        if (!show[block]) continue;
        const EntryRange range = grid.blockRanges[block];
        result.levels[block] = range.low == range.high ? kSingle : kFullLevel;
        if (result.levels[block] == kFullLevel) ++count;
    }
    result.slotsWanted = result.slots = count;
    if (count <= slots) return result;

    std::vector<float> negative(extinctionPerMm.begin(), extinctionPerMm.end());
    for (float& value : negative) value = -value;
    const RangeMax largest(extinctionPerMm);
    const RangeMax minusSmallest(negative);
    std::vector<Candidate> candidates;
    candidates.reserve(count);
    for (std::size_t block = 0; block < show.size(); ++block) {
        if (result.levels[block] != kFullLevel) continue;
        const EntryRange range = grid.blockRanges[block];
        candidates.push_back({largest(range.low, range.high) + minusSmallest(range.low, range.high),
                              static_cast<std::uint16_t>(range.high - range.low), block});
    }
    std::sort(candidates.begin(), candidates.end());
    for (std::uint8_t level = kFullLevel; level < kSingle; ++level) {
        const std::uint64_t leaving = toLeave(count, level, slots);
        for (std::uint64_t i = 0; i < leaving; ++i)
            result.levels[candidates[i].block] = static_cast<std::uint8_t>(level + 1);
        result.coarse = std::max<std::size_t>(result.coarse, leaving);
        result.coarsest = static_cast<std::uint8_t>(level + 1);
        result.slots = slotsFor(count - leaving, level) + slotsFor(leaving, level + 1);
        if (result.slots <= slots) break;
    }
    return result;
}

}  // namespace macula
