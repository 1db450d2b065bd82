// How bright a picture is, as a camera measures it.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

namespace macula::app {

// The exposure under which the brightest twentieth of what is seen begins just below white: its luminance
// (Rec. 709) there becomes kMeteredLuminance. Pixels are linear, of exposure 1, premultiplied; those that are
// less than half covered do not count, nor those that are not finite. Within 1 / kMostMetered to
// kMostMetered, so that an almost black picture does not become noise. Nothing where nothing is seen.
std::optional<double> meteredExposure(std::span<const glm::vec4> radiance);
inline constexpr double kMeteredLuminance = 0.7;  // display-encoded 0.85
inline constexpr double kMostMetered = 32.0;

}  // namespace macula::app
