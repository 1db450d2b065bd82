#include "pipeline/splat/draw/tile_lists.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <limits>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "pipeline/splat/draw/reference_host.h"
#include "pipeline/splat/draw/shown_tiles.h"
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

// Splats are sorted, and their tiles found, in parts on all cores. These are the fewest splats that make a
// part worth a thread.
constexpr std::size_t kSortedInPart = 1 << 15;
constexpr std::size_t kTiledInPart = 1 << 12;
// Limits the number of parts, because counts are kept for each part and tile.
constexpr std::size_t kMostCounts = 1 << 24;

std::size_t partCount(std::size_t splats, std::size_t leastEach, std::size_t countsEach) {
    return std::max<std::size_t>(1, std::min({splats / leastEach, 4 * coreCount(),
                                              kMostCounts / std::max<std::size_t>(countsEach, 1)}));
}

struct Part {
    std::size_t first = 0;
    std::size_t end = 0;
};
Part partOf(std::size_t part, std::size_t parts, std::size_t count) {
    return {part * count / parts, (part + 1) * count / parts};
}

// A prefix sum: turns the counts of each part and kind into the positions where each begins, ordered by kind,
// then by part. Returns the total.
std::uint32_t startsOf(std::span<std::uint32_t> counts, std::size_t parts, std::size_t kinds) {
    std::uint32_t sum = 0;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        for (std::size_t part = 0; part < parts; ++part) {
            std::uint32_t& count = counts[part * kinds + kind];
            sum += std::exchange(count, sum);
        }
    }
    return sum;
}

// Writes the sort keys of visible splats into scratch.keys, in their order: the bits of the depth, and the
// splat. Depths are above 0, so their bits sort as they do.
void collectKeys(std::span<const glm::vec4> screen, TileLists::Scratch& scratch) {
    const std::size_t count = screen.size() / kScreenTexels;
    const std::size_t parts = partCount(count, kSortedInPart, 1);
    scratch.counts.assign(parts, 0);
    const auto shows = [&](std::size_t i) { return screen[i * kScreenTexels + 1].y > 0.0f; };
    parallelFor(parts, [&](std::size_t part) {
        const Part range = partOf(part, parts, count);
        std::uint32_t sum = 0;
        for (std::size_t i = range.first; i < range.end; ++i) sum += shows(i) ? 1 : 0;
        scratch.counts[part] = sum;
    });
    scratch.keys.resize(startsOf(scratch.counts, parts, 1));
    parallelFor(parts, [&](std::size_t part) {
        const Part range = partOf(part, parts, count);
        std::uint32_t to = scratch.counts[part];
        for (std::size_t i = range.first; i < range.end; ++i) {
            if (!shows(i)) continue;
            const float depth = screen[i * kScreenTexels + 1].z;
            scratch.keys[to++] = {std::bit_cast<std::uint32_t>(depth), static_cast<std::uint32_t>(i)};
        }
    });
}

// Radix sort of scratch.keys, eleven bits at a time, stable.
void sortKeys(TileLists::Scratch& scratch) {
    constexpr std::size_t kDigits = 1u << 11;
    const std::size_t count = scratch.keys.size();
    const std::size_t parts = partCount(count, kSortedInPart, kDigits);
    scratch.otherKeys.resize(count);
    for (const std::uint32_t shift : {0u, 11u, 22u}) {
        const auto digit = [&](const glm::uvec2& key) { return (key.x >> shift) % kDigits; };
        scratch.counts.assign(parts * kDigits, 0);
        parallelFor(parts, [&](std::size_t part) {
            const Part range = partOf(part, parts, count);
            std::uint32_t* counts = &scratch.counts[part * kDigits];
            for (std::size_t i = range.first; i < range.end; ++i) ++counts[digit(scratch.keys[i])];
        });
        startsOf(scratch.counts, parts, kDigits);
        parallelFor(parts, [&](std::size_t part) {
            const Part range = partOf(part, parts, count);
            std::uint32_t* starts = &scratch.counts[part * kDigits];
            for (std::size_t i = range.first; i < range.end; ++i)
                scratch.otherKeys[starts[digit(scratch.keys[i])]++] = scratch.keys[i];
        });
        scratch.keys.swap(scratch.otherKeys);
    }
}

// Calls take(tile) for each tile in which the splat shows.
template <class Take>
void forEachTile(Host& host, const Host::ScreenSplat& s, const glm::ivec2& sizePx, const glm::ivec2& tileSize,
                 int tileColumns, const Take& take) {
    glm::ivec2 first, end;
    host.pixelsOf(s, sizePx, first, end);
    if (first.x >= end.x || first.y >= end.y) return;
    const glm::ivec2 firstTile = first / tileSize;
    const glm::ivec2 endTile = (end - 1) / tileSize + 1;
    if (endTile == firstTile + 1) {
        take(static_cast<std::uint32_t>(firstTile.y * tileColumns + firstTile.x));
        return;
    }
    // Does what showsIn does, but computes its logarithm once for all tiles.
    const SearchedTiles searched{.mean = s.mean,
                                 .conic = s.conic,
                                 .most = host.mostPower(s, host.frame),
                                 .sizePx = sizePx,
                                 .tileSize = tileSize,
                                 .tileColumns = tileColumns,
                                 .first = firstTile,
                                 .end = endTile};
    ShownTiles shown;
    for (std::size_t from = 0; from < searched.count(); from += ShownTiles::kMost) {
        findShownTiles(searched, from, shown);
        for (std::size_t n = 0; n < shown.count; ++n) take(shown.tiles[n]);
    }
}

// Collects the pairs of splat and tile in order of depth, by part. False when there are more than
// `mostPairs`.
bool collectPairs(std::span<const glm::vec4> screen, const Host& prototype, const glm::ivec2& tileSize,
                  std::size_t parts, std::uint64_t mostPairs, TileLists& lists) {
    constexpr std::size_t kAhead = 12;   // prefetch distance in splats, which are scattered in memory
    constexpr std::size_t kTold = 4096;  // a part adds its new pairs to the total once it has this many
    const std::vector<glm::uvec2>& keys = lists.scratch.keys;
    const std::size_t tiles = lists.ranges.size();
    lists.scratch.counts.assign(parts * tiles, 0);
    if (lists.scratch.pairs.size() < parts) lists.scratch.pairs.resize(parts);
    std::atomic<std::uint64_t> total{0};
    parallelFor(parts, [&](std::size_t part) {
        Host host = prototype;
        const Part range = partOf(part, parts, keys.size());
        std::vector<glm::uvec2>& pairs = lists.scratch.pairs[part];
        pairs.clear();
        std::uint32_t* counts = &lists.scratch.counts[part * tiles];
        std::size_t told = 0;
        for (std::size_t i = range.first; i < range.end; ++i) {
            if (i + kAhead < range.end)
                __builtin_prefetch(&screen[std::size_t(keys[i + kAhead].y) * kScreenTexels]);
            const std::uint32_t splat = keys[i].y;
            const auto before = static_cast<std::uint32_t>(pairs.size());
            forEachTile(host, screenSplat(screen, splat), host.frame.sizePx, tileSize, lists.tiles.x,
                        [&](std::uint32_t tile) {
                            ++counts[tile];
                            pairs.emplace_back(tile, splat);
                        });
            lists.pairs[splat] = {before, static_cast<std::uint32_t>(pairs.size()) - before};
            if (pairs.size() - told >= kTold || i + 1 == range.end) {
                const std::uint64_t news = pairs.size() - std::exchange(told, pairs.size());
                if (total.fetch_add(news) + news > mostPairs) return;
            }
        }
    });
    return total <= mostPairs;
}

}  // namespace

Result<void> sortIntoTiles(std::span<const glm::vec4> screen, const RasterView& view,
                           const Blending& blending, int tileRows, std::uint64_t mostPairs,
                           TileLists& lists) {
    const glm::ivec2 tileSize(kTileColumns, tileRows);
    lists.tiles = (view.sizePx + tileSize - 1) / tileSize;
    const auto tileCount = static_cast<std::size_t>(lists.tiles.x) * static_cast<std::size_t>(lists.tiles.y);
    lists.ranges.assign(tileCount, glm::uvec2(0));
    lists.pairs.assign(screen.size() / kScreenTexels, glm::uvec2(0));
    lists.entries.clear();
    collectKeys(screen, lists.scratch);
    sortKeys(lists.scratch);

    const std::size_t parts = partCount(lists.scratch.keys.size(), kTiledInPart, tileCount);
    mostPairs = std::min<std::uint64_t>(mostPairs, std::numeric_limits<std::uint32_t>::max());
    if (!collectPairs(screen, Host(view, blending), tileSize, parts, mostPairs, lists)) {
        return Error{ErrorCode::outOfMemory,
                     Text("The splats of this model are too large and too many for this device."),
                     {},
                     Text("Draw a smaller picture, or a model of fewer splats.")};
    }
    // Pairs are numbered consecutively over all parts.
    std::vector<std::uint32_t> firstPairs;
    std::uint32_t sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        firstPairs.push_back(sum);
        sum += static_cast<std::uint32_t>(lists.scratch.pairs[part].size());
    }
    startsOf(lists.scratch.counts, parts, tileCount);
    for (std::size_t tile = 0; tile < tileCount; ++tile) {
        lists.ranges[tile] = {lists.scratch.counts[tile],
                              tile + 1 < tileCount ? lists.scratch.counts[tile + 1] : sum};
    }
    lists.entries.resize(sum);
    parallelFor(parts, [&](std::size_t part) {
        const std::vector<glm::uvec2>& pairs = lists.scratch.pairs[part];
        std::uint32_t* starts = &lists.scratch.counts[part * tileCount];
        for (std::size_t i = 0; i < pairs.size(); ++i)
            lists.entries[starts[pairs[i].x]++] = {pairs[i].y,
                                                   firstPairs[part] + static_cast<std::uint32_t>(i)};
        const Part range = partOf(part, parts, lists.scratch.keys.size());
        for (std::size_t i = range.first; i < range.end && firstPairs[part] > 0; ++i)
            lists.pairs[lists.scratch.keys[i].y].x += firstPairs[part];
    });
    return {};
}

}  // namespace macula::splat
