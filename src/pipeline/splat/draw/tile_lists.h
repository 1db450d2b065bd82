// Tile binning: which splats each tile of a picture shows, front to back. Made on the host: on a CPU device
// that is faster than any kernel.
//
// A tile is kTileColumns pixels wide. A pair is a splat and a tile that shows it. The pairs of a splat are
// numbered consecutively, so that its derivatives from all tiles can be gathered.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/draw/raster_view.h"

namespace macula::splat {

struct TileLists {
    glm::ivec2 tiles{0};              // number of columns and rows
    std::vector<glm::uvec2> ranges;   // for each tile, row by row: first entry, and one after the last
    std::vector<glm::uvec2> entries;  // for each tile, front to back: splat, number of the pair
    std::vector<glm::uvec2> pairs;    // for each splat: first pair, and how many

    // Working memory of the sort, kept so that the next picture allocates nothing.
    struct Scratch {
        std::vector<glm::uvec2> keys, otherKeys;     // bits of the depth, splat
        std::vector<std::vector<glm::uvec2>> pairs;  // for each part of the splats: tile, splat
        std::vector<std::uint32_t> counts;           // for each part and digit, or part and tile
    } scratch;
};

// `screen` is the output of shaders/splat/project.comp, kScreenTexels for each splat; of equally deep splats
// the one with the lower index is in front. Uses all cores; the result does not depend on their number.
// Reuses the memory of `lists`. outOfMemory when there are more than `mostPairs`.
Result<void> sortIntoTiles(std::span<const glm::vec4> screen, const RasterView& view,
                           const Blending& blending, int tileRows, std::uint64_t mostPairs, TileLists& lists);

}  // namespace macula::splat
