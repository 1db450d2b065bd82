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
    diverging,  // Moreland's Msh space: through white between saturated colours of different hue
    step,       // a piece has the colour of the point at its end
};

// The colour at `fraction` of the way from one sRGB-encoded colour to another; encoded, 0 to 1. Not for step,
// which does not mix.
glm::dvec3 mixColours(ColourSpace space, const glm::dvec3& from, const glm::dvec3& to, double fraction);

// The names in Macula's files: "rgb", "hsv", "hsvWrap", "lab", "diverging", "step".
std::string_view colourSpaceName(ColourSpace space);
std::optional<ColourSpace> colourSpaceNamed(std::string_view name);

// From sRGB-encoded values, 0 to 1, to CIE L*a*b* with the white point X = 0.9505, Y = 1, Z = 1.089, and
// back. Colours outside sRGB are divided by their largest channel, and negative channels become 0.
glm::dvec3 labFromSrgb(const glm::dvec3& encoded);
glm::dvec3 srgbFromLab(const glm::dvec3& lab);

}  // namespace macula
