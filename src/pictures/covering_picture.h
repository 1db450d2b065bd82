// Recovers the alpha channel of a picture from its renderings over black and over white.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace macula::pictures {

// Both pictures have 4 bytes a pixel, display-encoded; their background was mixed in as linear light, after
// the tone map. So the light in which they differ is background (triangulation: Smith and Blinn, "Blue Screen
// Matting", 1996). Colours are straight, as in PNG; pixels without coverage are clear black. The channel with
// the least coverage decides, because one that is white in both pictures says nothing.
std::vector<std::uint8_t> coveringPicture(std::span<const std::uint8_t> overBlack,
                                          std::span<const std::uint8_t> overWhite);

}  // namespace macula::pictures
