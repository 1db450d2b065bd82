// The background of a picture: a display colour that exposure and tone map do not change.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::scene {

using BackgroundColour = glm::u8vec3;  // display-encoded (IEC 61966-2-1)

inline constexpr BackgroundColour kBlackBackground{0, 0, 0};
// Not a colour: the picture gets an alpha channel.
inline constexpr std::string_view kTransparent = "transparent";

// "black", "white", "grey", or "#rrggbb". Fails with usage.
Result<BackgroundColour> backgroundOf(std::string_view text);

// "#rrggbb", as in files; and back, nothing for other text.
std::string hexOf(BackgroundColour colour);
std::optional<BackgroundColour> colourOfHex(std::string_view text);

// The linear colour that PathTracer and Compositor need to display `colour`.
glm::vec3 lightOf(BackgroundColour colour);

}  // namespace macula::scene
