#include "segment/components.h"

#include <algorithm>
#include <limits>

#include "segment/itk_filters.h"

namespace macula::segment {

Result<Parts> partsOf(const Grid& grid, const Mask& mask, bool corners, const std::vector<float>& depthMm) {
    MACULA_TRY(Labels labels, connectedParts(grid, mask, corners));
    Parts found{std::move(labels.ofBlock), {}};
    found.parts.resize(labels.count,
                       {.low = glm::ivec3(std::numeric_limits<int>::max()), .high = glm::ivec3(-1)});
    std::size_t at = 0;
    for (int c = 0; c < grid.size.z; ++c) {
        for (int b = 0; b < grid.size.y; ++b) {
            for (int a = 0; a < grid.size.x; ++a, ++at) {
                if (found.labels[at] == 0) continue;
                Part& part = found.parts[found.labels[at] - 1];
                ++part.blocks;
                part.low = glm::min(part.low, glm::ivec3(a, b, c));
                part.high = glm::max(part.high, glm::ivec3(a, b, c));
                if (!depthMm.empty()) part.depthMm = std::max(part.depthMm, depthMm[at]);
            }
        }
    }
    return found;
}

void countPersistent(const Grid& grid, Parts& parts) {
    constexpr double kMost = 0.8;
    std::vector<std::pair<std::uint32_t, std::size_t>> column;  // label, blocks
    for (std::size_t ab = 0; ab < grid.sliceSize(); ++ab) {
        column.clear();
        for (std::size_t at = ab; at < grid.count(); at += grid.sliceSize()) {
            const std::uint32_t label = parts.labels[at];
            if (label == 0) continue;
            const auto known = std::find_if(column.begin(), column.end(),
                                            [&](const auto& entry) { return entry.first == label; });
            if (known == column.end()) {
                column.emplace_back(label, 1);
            } else {
                ++known->second;
            }
        }
        for (const auto& [label, blocks] : column) {
            Part& part = parts.parts[label - 1];
            if (double(blocks) >= kMost * (part.high.z - part.low.z + 1)) part.persistent += blocks;
        }
    }
}

}  // namespace macula::segment
