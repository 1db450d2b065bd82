// Something small that is laid over a picture of a file: words, letters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace macula::app {

struct Stamp {
    glm::ivec2 atPx{0};  // of its left upper corner, in the picture
    glm::ivec2 sizePx{0};
    std::vector<std::uint8_t> rgba;  // opaque, row 0 on top
};

// What lies beyond the picture, `sizePx` large with 4 bytes a pixel, is left out.
void putOver(std::vector<std::uint8_t>& picture, const glm::ivec2& sizePx, const Stamp& stamp);

}  // namespace macula::app
