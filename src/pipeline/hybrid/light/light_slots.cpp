#include "pipeline/hybrid/light/light_slots.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "base/parallel.h"

namespace macula::hybrid {

namespace {

using shared::LightSlot;

constexpr std::size_t kTables = LightInSpace::kTables;
// Parts of the slots, each filled by one core. A power of two.
constexpr std::size_t kParts = 16;
constexpr LightSlot kFree{.low = 0, .high = shared::kFreeSlot, .cell = 0};

// Where the search for the key of a slot begins.
std::size_t homeOf(const LightSlot& slot, std::size_t slots) {
    return LightInSpace::hashOf(std::uint64_t(slot.high) << 32 | slot.low) & (slots - 1);
}

using ByPart = std::array<std::vector<LightSlot>, kParts>;

// The slots of a table of the cache, by the part that they belong into. Its cells begin at `firstCell`.
ByPart sortedByPart(const LightInSpace& light, std::size_t table, std::size_t firstCell, std::size_t slots) {
    ByPart sorted;
    light.forEachKeyOf(table, [&](std::uint64_t key, std::size_t cell) {
        const LightSlot slot{.low = static_cast<std::uint32_t>(key),
                             .high = static_cast<std::uint32_t>(key >> 32),
                             .cell = static_cast<std::uint32_t>(firstCell + cell)};
        sorted[homeOf(slot, slots) * kParts / slots].push_back(slot);
    });
    return sorted;
}

void copyCells(std::span<const LightInSpace::Cell> from, glm::vec4* to) {
    for (const LightInSpace::Cell& cell : from)
        for (const glm::vec4& mean : cell)
            *to++ = glm::vec4(glm::vec3(mean), float(LightInSpace::trust(mean.w)));
}

// Fills one part of the slots, and returns the slots that found no place in it.
std::vector<LightSlot> fillPart(const std::array<ByPart, kTables>& sorted, std::size_t part,
                                std::span<LightSlot> all) {
    const std::size_t begin = part * all.size() / kParts;
    const std::size_t end = (part + 1) * all.size() / kParts;
    std::fill(all.begin() + std::ptrdiff_t(begin), all.begin() + std::ptrdiff_t(end), kFree);
    std::vector<LightSlot> beyond;
    for (const ByPart& ofTable : sorted) {
        for (const LightSlot& slot : ofTable[part]) {
            std::size_t at = homeOf(slot, all.size());
            while (at < end && all[at].high != shared::kFreeSlot) ++at;
            if (at < end) {
                all[at] = slot;
            } else {
                beyond.push_back(slot);
            }
        }
    }
    return beyond;
}

}  // namespace

LightSlots::LightSlots(const LightInSpace& light)
    : slotCount_(std::max(std::bit_ceil(2 * light.cells() + 1), kParts)),
      cellCount_(std::max<std::size_t>(6 * light.cells(), 6)) {
    slots_ = std::make_unique_for_overwrite<LightSlot[]>(slotCount_);
    cells_ = std::make_unique_for_overwrite<glm::vec4[]>(cellCount_);
    if (light.cells() == 0) std::fill_n(cells_.get(), cellCount_, glm::vec4(0.0f));  // no slot points here
    std::array<std::size_t, kTables + 1> firstCell{};
    for (std::size_t t = 0; t < kTables; ++t) firstCell[t + 1] = firstCell[t] + light.cellsOf(t).size();

    std::array<ByPart, kTables> sorted;
    parallelFor(kTables, [&](std::size_t t) {
        copyCells(light.cellsOf(t), cells_.get() + 6 * firstCell[t]);
        sorted[t] = sortedByPart(light, t, firstCell[t], slotCount_);
    });
    const std::span<LightSlot> all(slots_.get(), slotCount_);
    std::array<std::vector<LightSlot>, kParts> beyond;
    parallelFor(kParts, [&](std::size_t part) { beyond[part] = fillPart(sorted, part, all); });
    // A search finds these too: there is no free slot from their home to the end of their part.
    for (const std::vector<LightSlot>& ofPart : beyond) {
        for (const LightSlot& slot : ofPart) {
            std::size_t at = homeOf(slot, slotCount_);
            while (all[at].high != shared::kFreeSlot) at = (at + 1) & (slotCount_ - 1);
            all[at] = slot;
        }
    }
}

}  // namespace macula::hybrid
