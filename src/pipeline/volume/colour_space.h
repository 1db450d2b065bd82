// The spaces in which colours are interpolated, as vtkColorTransferFunction defines them.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string_view>

namespace macula {

enum class ColourSpace {
    rgb,
    hsv,        // hue, saturation, value; the hue does not pass through red
    hsvWrap,    // the hue goes the shorter way around
    lab,        // CIE L*a*b* under D65
    diverging,  // Moreland's Msh space: through white between two saturated colours that differ
    step,       // a piece has the colour of the point it ends at
};

// The colour `fraction` of the way from one sRGB-encoded colour to another; encoded, 0 to 1. Not for step,
// which mixes nothing.
glm::dvec3 mixColours(ColourSpace space, const glm::dvec3& from, const glm::dvec3& to, double fraction);

// "rgb", "hsv", "hsvWrap", "lab", "diverging", "step": as in our files.
std::string_view colourSpaceName(ColourSpace space);
std::optional<ColourSpace> colourSpaceNamed(std::string_view name);

// sRGB-encoded, 0 to 1, to CIE L*a*b* with the white point X = 0.9505, Y = 1, Z = 1.089, and back. What lies
// outside of sRGB is scaled down by its largest channel, and negative channels become 0.
glm::dvec3 labFromSrgb(const glm::dvec3& encoded);
glm::dvec3 srgbFromLab(const glm::dvec3& lab);

}  // namespace macula
