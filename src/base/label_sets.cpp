#include "base/label_sets.h"

#include <cmath>
#include <new>
#include <optional>

#include "base/available_memory.h"

namespace macula {

namespace {

struct LabelBox {
    glm::ivec3 low{0};
    glm::ivec3 high{-1};
};
using Boxes = std::map<std::uint16_t, LabelBox>;

Error notUsable(Text message) {
    return {ErrorCode::inputNotUsable,
            std::move(message),
            {},
            Text("A label map has the number of a segment in each voxel, and 0 where there is none.")};
}

Error cancelled() {
    return {ErrorCode::cancelled, Text("Stopped."), {}, {}};
}

// Calls visit(number, voxel) for each voxel with another number than 0; false ends it.
template <class Visit>
Result<void> forEachLabel(const Volume& labels, const CancelToken& token, const Visit& visit) {
    const glm::ivec3 size = labels.size();
    constexpr double kMostNumber = 65535.0;
    for (int k = 0; k < size.z; ++k) {
        if (token.cancelled()) return cancelled();
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const double value = labels.value(i, j, k);
                if (value == 0.0) continue;
                if (!(value > 0.0 && value <= kMostNumber) || value != std::floor(value))
                    return notUsable(
                        Text("It has values that are no numbers of segments: whole ones from 0 to 65535."));
                MACULA_TRY_VOID(visit(std::uint16_t(value), glm::ivec3(i, j, k)));
            }
    }
    return {};
}

// Neighbours mostly have the same number: the last one found is kept.
Result<Boxes> boxesOf(const Volume& labels, std::size_t most, const CancelToken& token) {
    Boxes boxes;
    auto last = boxes.end();
    MACULA_TRY_VOID(
        forEachLabel(labels, token, [&](std::uint16_t number, const glm::ivec3& at) -> Result<void> {
            if (last == boxes.end() || last->first != number) {
                last = boxes.try_emplace(number, LabelBox{at, at}).first;
                if (boxes.size() > most) return notUsable(Text("It has more than {} segments.", most));
            }
            last->second.low = glm::min(last->second.low, at);
            last->second.high = glm::max(last->second.high, at);
            return {};
        }));
    return boxes;
}

}  // namespace

Result<std::map<std::uint16_t, VoxelSet>> labelSets(const Volume& labels, std::size_t most,
                                                    const CancelToken& token) try {
    MACULA_TRY(const Boxes boxes, boxesOf(labels, most, token));
    double bytes = 0.0;
    for (const auto& box : boxes) bytes += VoxelSet::bytesFor(box.second.low, box.second.high);
    if (const auto available = availableMemory(); available && bytes > double(*available))
        return notEnoughMemory(std::uint64_t(bytes), *available);
    std::map<std::uint16_t, VoxelSet> sets;
    for (const auto& box : boxes) sets.emplace(box.first, VoxelSet(box.second.low, box.second.high));
    auto last = sets.end();
    MACULA_TRY_VOID(
        forEachLabel(labels, token, [&](std::uint16_t number, const glm::ivec3& at) -> Result<void> {
            if (last == sets.end() || last->first != number) last = sets.find(number);
            last->second.add(at);
            return {};
        }));
    return sets;
} catch (const std::bad_alloc&) {
    return notEnoughMemory(std::uint64_t(labels.voxelCount()) / 8, availableMemory());
}

}  // namespace macula
