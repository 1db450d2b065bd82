// Turns pictures of splats into what a screen shows or a file stores.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/splat/model/splats.h"

namespace macula::splat {

struct DisplayOptions {
    glm::vec3 background{0.0f};  // as the display is to show it, each channel 0 to 1
    float exposure = 1.0f;       // multiplies linear radiance before the tone map; not display colours
};

// Turns premultiplied `pixels` into opaque 8-bit RGBA. Linear radiance is exposed, tone mapped, laid over the
// background and encoded, as displayColour in shaders/lib/picture.glsl does with the neutral tone map.
// Display colours are laid over the background unchanged, as in 3DGS.
std::vector<std::uint8_t> displayed(std::span<const glm::vec4> pixels, ColourSpace space,
                                    const DisplayOptions& options);

// The same before rounding to 8 bits, each channel 0 to 1.
std::vector<glm::vec3> displayedExactly(std::span<const glm::vec4> pixels, ColourSpace space,
                                        const DisplayOptions& options);

// The linear grey that is displayed as `encoded`, 0 to 1, at an exposure of 1. For an `encoded` near 1 only
// approximately, because the tone map never quite reaches white. `keepsHue`: by toneMapHue instead of
// toneMapNeutral.
float lightOfGrey(float encoded, bool keepsHue = false);

// Converts to premultiplied linear radiance. Display colours are decoded as sRGB: each pixel's own colour,
// without the background.
std::vector<glm::vec4> linearRadiance(std::span<const glm::vec4> pixels, ColourSpace space);

// Converts a model for programs that blend display colours: each splat gets the colour in which it is
// displayed alone, and its change with direction to first order. Where splats are seen through each other,
// the picture differs a little. The model must be valid; one with display colours is returned unchanged.
Splats asDisplayed(Splats splats);

// The mean depth of the splats in each pixel, in mm along the camera's z, from the sums of weight times
// depth; +infinity where coverage is not above minCoverage.
std::vector<float> meanDepthsMm(std::span<const glm::vec4> pixels, std::span<const float> depthSums,
                                float minCoverage = 0.5f);

}  // namespace macula::splat
