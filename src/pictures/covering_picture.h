// A picture with an alpha channel, of the same picture over two backgrounds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace macula::app {

// Both 4 bytes a pixel, display-encoded, with a background that is mixed in as linear light behind the tone
// map: what is seen over white and not over black is background (Smith and Blinn, "Blue Screen Matting",
// 1996, triangulation). Colours are straight, not premultiplied, as PNG has them; what covers nothing is
// clear black. A channel that is white in both does not count where another one tells more.
std::vector<std::uint8_t> coveringPicture(std::span<const std::uint8_t> overBlack,
                                          std::span<const std::uint8_t> overWhite);

}  // namespace macula::app
