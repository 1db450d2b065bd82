// A small overlay on a picture: text or letters.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace macula::pictures {

struct Stamp {
    glm::ivec2 atPx{0};  // its upper left corner in the picture
    glm::ivec2 sizePx{0};
    std::vector<std::uint8_t> rgba;  // opaque, row 0 on top
};

// Copies the stamp into a picture of `sizePx`, 4 bytes a pixel; clips it at the border.
void putOver(std::vector<std::uint8_t>& picture, const glm::ivec2& sizePx, const Stamp& stamp);

}  // namespace macula::pictures
