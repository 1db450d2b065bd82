#include "pictures/stamp.h"

#include <algorithm>
#include <cstring>

#include "base/check.h"

namespace macula::pictures {

void putOver(std::vector<std::uint8_t>& picture, const glm::ivec2& sizePx, const Stamp& stamp) {
    MACULA_CHECK_EQ(stamp.rgba.size(), std::size_t(stamp.sizePx.x) * std::size_t(stamp.sizePx.y) * 4);
    MACULA_CHECK_EQ(picture.size(), std::size_t(sizePx.x) * std::size_t(sizePx.y) * 4);
    const glm::ivec2 from = glm::max(stamp.atPx, glm::ivec2(0));
    const glm::ivec2 to = glm::min(stamp.atPx + stamp.sizePx, sizePx);
    if (from.x >= to.x) return;
    const std::size_t rowBytes = std::size_t(to.x - from.x) * 4;
    for (int y = from.y; y < to.y; ++y) {
        const std::size_t source =
            std::size_t(y - stamp.atPx.y) * std::size_t(stamp.sizePx.x) + std::size_t(from.x - stamp.atPx.x);
        const std::size_t target = std::size_t(y) * std::size_t(sizePx.x) + std::size_t(from.x);
        std::memcpy(&picture[4 * target], &stamp.rgba[4 * source], rowBytes);
    }
}

}  // namespace macula::pictures
