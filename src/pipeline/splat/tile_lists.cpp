#include "pipeline/splat/tile_lists.h"

#include <algorithm>
#include <array>
#include <bit>

#include "pipeline/splat/reference_host.h"
#include "shared/splat_frame.h"

namespace macula::splat {

namespace {

using Host = reference::HostSingle;
using shared::kScreenTexels;
using shared::kTileColumns;

Host::ScreenSplat screenSplat(std::span<const glm::vec4> screen, std::uint32_t splat) {
    const glm::vec4* t = &screen[std::size_t(splat) * kScreenTexels];
    return {.mean = {t[0].x, t[0].y},
            .conic = {t[0].z, t[0].w, t[1].x},
            .opacity = t[1].y,
            .depthMm = t[1].z,
            .extent = {t[1].w, t[2].w}};
}

// Front to back, of those that show. Depths are above 0, and their bits are in their order.
std::vector<std::uint32_t> byDepth(std::span<const glm::vec4> screen) {
    struct Key {
        std::uint32_t bits;
        std::uint32_t splat;
    };
    const auto count = static_cast<std::uint32_t>(screen.size() / kScreenTexels);
    std::vector<Key> keys;
    keys.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::vec4& t = screen[std::size_t(i) * kScreenTexels + 1];
        if (t.y > 0.0f) keys.push_back({std::bit_cast<std::uint32_t>(t.z), i});
    }
    // Radix sort, eleven bits at a time, stable.
    constexpr std::uint32_t kDigits = 1u << 11;
    std::vector<Key> other(keys.size());
    for (const std::uint32_t shift : {0u, 11u, 22u}) {
        std::array<std::uint32_t, kDigits + 1> starts{};
        for (const Key& key : keys) ++starts[(key.bits >> shift) % kDigits + 1];
        for (std::uint32_t d = 0; d < kDigits; ++d) starts[d + 1] += starts[d];
        for (const Key& key : keys) other[starts[(key.bits >> shift) % kDigits]++] = key;
        keys.swap(other);
    }
    std::vector<std::uint32_t> order(keys.size());
    std::transform(keys.begin(), keys.end(), order.begin(), [](const Key& key) { return key.splat; });
    return order;
}

}  // namespace

Result<void> sortIntoTiles(std::span<const glm::vec4> screen, const RasterView& view,
                           const Blending& blending, int tileRows, std::uint64_t mostPairs,
                           TileLists& lists) {
    Host host(view, blending);
    const glm::ivec2 tileSize(kTileColumns, tileRows);
    lists.tiles = (view.sizePx + tileSize - 1) / tileSize;
    const auto tileCount = static_cast<std::size_t>(lists.tiles.x) * static_cast<std::size_t>(lists.tiles.y);
    lists.ranges.assign(tileCount, glm::uvec2(0));
    lists.pairs.assign(screen.size() / kScreenTexels, glm::uvec2(0));

    struct Pair {
        std::uint32_t tile;
        std::uint32_t splat;
    };
    std::vector<Pair> pairs;
    pairs.reserve(lists.entries.size());
    for (const std::uint32_t splat : byDepth(screen)) {
        const Host::ScreenSplat s = screenSplat(screen, splat);
        glm::ivec2 first, end;
        host.pixelsOf(s, view.sizePx, first, end);
        const auto firstPair = static_cast<std::uint32_t>(pairs.size());
        if (first.x < end.x && first.y < end.y) {
            const glm::ivec2 firstTile = first / tileSize;
            const glm::ivec2 lastTile = (end - 1) / tileSize;
            const bool one = firstTile == lastTile;
            for (int y = firstTile.y; y <= lastTile.y; ++y) {
                for (int x = firstTile.x; x <= lastTile.x; ++x) {
                    const glm::ivec2 low = glm::ivec2(x, y) * tileSize;
                    if (!one && !host.showsIn(s, low, glm::min(low + tileSize, view.sizePx), host.frame))
                        continue;
                    const auto tile = static_cast<std::uint32_t>(y * lists.tiles.x + x);
                    ++lists.ranges[tile].y;
                    pairs.push_back({tile, splat});
                }
            }
        }
        lists.pairs[splat] = {firstPair, static_cast<std::uint32_t>(pairs.size()) - firstPair};
        if (pairs.size() > mostPairs) {
            return Error{ErrorCode::outOfMemory,
                         "The splats of this model are too large and too many for this device.",
                         {},
                         "Draw a smaller picture, or a model of fewer splats."};
        }
    }
    std::uint32_t sum = 0;
    for (glm::uvec2& range : lists.ranges) {
        const std::uint32_t count = range.y;
        range = {sum, sum};
        sum += count;
    }
    lists.entries.resize(pairs.size());
    for (std::uint32_t i = 0; i < pairs.size(); ++i)
        lists.entries[lists.ranges[pairs[i].tile].y++] = {pairs[i].splat, i};
    return {};
}

}  // namespace macula::splat
