// How bright light and pictures are, as a camera measures them.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

namespace macula::scene {

// Luminance (Rec. 709) of a linear colour.
inline double brightnessOf(const glm::dvec3& linear) {
    return glm::dot(linear, glm::dvec3(0.2126, 0.7152, 0.0722));
}

// The exposure at which the brightest twentieth of the pixels begins just below white: their least luminance
// (Rec. 709) becomes kMeteredLuminance. Pixels are linear, of exposure 1, premultiplied; those less than half
// covered or not finite do not count. Clamped to 1 / kMostMetered to kMostMetered, so that an almost black
// picture does not become noise. Nothing if no pixel counts.
std::optional<double> meteredExposure(std::span<const glm::vec4> radiance);
inline constexpr double kMeteredLuminance = 0.7;  // 0.83 as it is displayed
inline constexpr double kMostMetered = 32.0;

}  // namespace macula::scene
