#include "pipeline/volume/block_pool.h"

#include "base/check.h"

namespace macula {

namespace {

constexpr std::uint32_t kUnit = 8;  // values
constexpr std::uint32_t kUnitsPerSlot = kSlotValues / kUnit;

// A bit for each block a slot can hold.
std::uint64_t full(std::uint8_t level) {
    const std::uint32_t blocks = kSlotValues / poolValues(level);
    return blocks == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << blocks) - 1;
}

}  // namespace

void BlockPool::grow(std::uint64_t slots) {
    const std::uint64_t before = slots_.size();
    MACULA_CHECK_LE(before, slots);
    MACULA_CHECK_LT(slots * kUnitsPerSlot, std::uint64_t{1} << 30);  // limit of a word of the table
    slots_.resize(slots);
    free_.reserve(free_.size() + slots - before);
    free_.insert(free_.begin(), slots - before, 0);
    for (std::uint64_t i = 0; i < slots - before; ++i)
        free_[i] = static_cast<std::uint32_t>(
            slots - 1 - i);  // the lowest new slot is used first, but after all old ones
}

std::optional<std::uint32_t> BlockPool::allocate(std::uint8_t level) {
    MACULA_CHECK_LT(level, kSingle);
    auto& partial = partial_[level];
    while (!partial.empty() &&
           (slots_[partial.back()].level != level || slots_[partial.back()].used == full(level)))
        partial.pop_back();
    if (partial.empty()) {
        if (free_.empty()) return std::nullopt;
        partial.push_back(free_.back());
        free_.pop_back();
        slots_[partial.back()] = {level, 0};
    }
    const std::uint32_t index = partial.back();
    Slot& slot = slots_[index];
    const auto place = static_cast<std::uint32_t>(std::countr_one(slot.used));
    slot.used |= std::uint64_t{1} << place;
    return index * kUnitsPerSlot + place * (poolValues(level) / kUnit);
}

void BlockPool::release(std::uint8_t level, std::uint32_t unit) {
    const std::uint32_t index = unit / kUnitsPerSlot;
    MACULA_CHECK_LT(index, slots_.size());
    Slot& slot = slots_[index];
    const std::uint64_t bit = std::uint64_t{1} << (unit % kUnitsPerSlot / (poolValues(level) / kUnit));
    MACULA_CHECK_EQ(int(slot.level), int(level));
    MACULA_CHECK((slot.used & bit) != 0);
    if (slot.used == full(level)) partial_[level].push_back(index);
    slot.used &= ~bit;
    if (slot.used == 0) {
        slot.level = kAbsent;
        free_.push_back(index);
    }
}

}  // namespace macula
