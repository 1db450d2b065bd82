// Tile binning: which splats each tile of a picture shows, front to back. Made on the host: on a CPU device
// that is faster than any kernel.
//
// A tile is kTileColumns pixels wide. A pair is a splat and a tile that shows it. Pairs of one splat are
// numbered one after the other, so that what tiles say of it can be gathered.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/draw/raster_view.h"

namespace macula::splat {

struct TileLists {
    glm::ivec2 tiles{0};              // columns and rows of them
    std::vector<glm::uvec2> ranges;   // by tile, row by row: first entry, and one after the last
    std::vector<glm::uvec2> entries;  // by tile, front to back: splat, number of the pair
    std::vector<glm::uvec2> pairs;    // by splat: first pair, and how many

    // What sorting needs besides, kept so that the next picture allocates nothing.
    struct Scratch {
        std::vector<glm::uvec2> keys, otherKeys;     // bits of the depth, splat
        std::vector<std::vector<glm::uvec2>> pairs;  // by part of the splats: tile, splat
        std::vector<std::uint32_t> counts;           // by part and digit, or by part and tile
    } scratch;
};

// `screen` is what shaders/splat/project.comp writes, kScreenTexels for each splat; of equally deep ones
// the one with the lower index is in front. On all cores; what comes out does not depend on them. Reuses what
// `lists` holds. outOfMemory when there are more than `mostPairs`.
Result<void> sortIntoTiles(std::span<const glm::vec4> screen, const RasterView& view,
                           const Blending& blending, int tileRows, std::uint64_t mostPairs, TileLists& lists);

}  // namespace macula::splat
