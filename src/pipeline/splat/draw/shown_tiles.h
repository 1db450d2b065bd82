// In which tiles of a rectangle a splat shows: many tiles at once, in vectors (Google Highway).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace macula::splat {

// The tiles first <= tile < end, row by row, and the splat: see shaders/lib/splat_tile.glsl.
struct SearchedTiles {
    glm::vec2 mean;
    glm::vec3 conic;
    float most;  // the largest power at which the splat shows
    glm::ivec2 sizePx;
    glm::ivec2 tileSize;
    int tileColumns;  // of the picture, which has fewer than 2^22 tiles
    glm::ivec2 first;
    glm::ivec2 end;

    std::size_t count() const {
        const glm::ivec2 tiles = end - first;
        return static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
    }
};

struct ShownTiles {
    static constexpr std::size_t kMost = 32;
    static constexpr std::size_t kLongestVector = 16;

    std::size_t count = 0;
    // Numbers of tiles, row by row in the picture. Whole vectors are written, of which not all numbers count.
    std::array<std::uint32_t, kMost + kLongestVector> tiles;
};

// Of the tiles from number `from` on, at most kMost. The answers are those of showsIn to the bit.
void findShownTiles(const SearchedTiles& searched, std::size_t from, ShownTiles& shown);

}  // namespace macula::splat
