// How bright light and pictures are, as a camera measures them.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

namespace macula::app {

// Luminance (Rec. 709) of a linear colour.
inline double brightnessOf(const glm::dvec3& linear) {
    return glm::dot(linear, glm::dvec3(0.2126, 0.7152, 0.0722));
}

// The exposure under which the brightest twentieth of what is seen begins just below white: its luminance
// (Rec. 709) there becomes kMeteredLuminance. Pixels are linear, of exposure 1, premultiplied; those that are
// less than half covered do not count, nor those that are not finite. Within 1 / kMostMetered to
// kMostMetered, so that an almost black picture does not become noise. Nothing where nothing is seen.
std::optional<double> meteredExposure(std::span<const glm::vec4> radiance);
inline constexpr double kMeteredLuminance = 0.7;  // 0.83 as it is displayed
inline constexpr double kMostMetered = 32.0;

}  // namespace macula::app
