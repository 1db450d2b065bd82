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

namespace {

// A region is the room, not an organ, when the field of view bounds more than this share of it.
constexpr double kOpenShare = 1.0 / 3.0;

struct Border {
    std::size_t open = 0;
    std::size_t closed = 0;
};

Result<void> fillSlice(const Grid& slice, const std::uint8_t* outside, std::uint8_t* mask) {
    Mask hollow(slice.count());
    for (std::size_t n = 0; n < hollow.size(); ++n) hollow[n] = mask[n] == 0 && outside[n] == 0 ? 1 : 0;
    MACULA_TRY(const Labels regions, connectedParts(slice, hollow, false));
    std::vector<Border> borders(regions.count + 1);
    for (std::size_t n = 0; n < hollow.size(); ++n) {
        if (hollow[n] == 0) continue;
        Border& border = borders[regions.ofBlock[n]];
        const auto look = [&](bool within, std::size_t beside) {
            if (!within || outside[beside] != 0) {
                ++border.open;
            } else if (mask[beside] != 0) {
                ++border.closed;
            }
        };
        const auto na = std::size_t(slice.size.x);
        look(n % na > 0, n - 1);
        look((n + 1) % na > 0, n + 1);
        look(n >= na, n - na);
        look(n + na < hollow.size(), n + na);
    }
    for (std::size_t n = 0; n < hollow.size(); ++n) {
        const Border& border = borders[regions.ofBlock[n]];
        const bool isEnclosed = double(border.open) <= kOpenShare * double(border.open + border.closed);
        if (hollow[n] != 0 && isEnclosed) mask[n] = 1;
    }
    return {};
}

}  // namespace

Result<void> fillEnclosed(const Grid& grid, const Mask& outside, Mask& mask, const CancelToken& token) {
    Grid slice = grid;
    slice.size.z = 1;
    for (std::size_t first = 0; first < mask.size() && !token.cancelled(); first += slice.count())
        MACULA_TRY_VOID(fillSlice(slice, outside.data() + first, mask.data() + first));
    return {};
}

}  // namespace macula::segment
