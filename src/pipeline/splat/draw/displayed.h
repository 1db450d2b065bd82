// From a picture of splats to what is looked at or stored.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/splat/model/splats.h"

namespace macula::splat {

struct DisplayOptions {
    glm::vec3 background{0.0f};  // as it is to be on the display, each 0 to 1
    float exposure = 1.0f;       // multiplies linear radiance before the tone map; others have none
};

// 8-bit RGBA, opaque, of premultiplied `pixels`. Linear radiance is exposed, tone mapped, laid over the
// background and encoded, as displayColour in shaders/lib/picture.glsl with the neutral tone map. Colours of
// the display are laid over the background as they are, as 3DGS does.
std::vector<std::uint8_t> displayed(std::span<const glm::vec4> pixels, ColourSpace space,
                                    const DisplayOptions& options);

// The same before it is rounded to 8 bits, each 0 to 1.
std::vector<glm::vec3> displayedExactly(std::span<const glm::vec4> pixels, ColourSpace space,
                                        const DisplayOptions& options);

// The linear grey that is displayed as `encoded`, 0 to 1, at an exposure of 1; of white, nearly so.
// `keepsHue`: by toneMapHue, else toneMapNeutral.
float lightOfGrey(float encoded, bool keepsHue = false);

// Premultiplied linear radiance. Colours of the display are taken as sRGB: each pixel's own colour, without
// what is behind it, is decoded.
std::vector<glm::vec4> linearRadiance(std::span<const glm::vec4> pixels, ColourSpace space);

// A model for programs that blend what is displayed: the colour of each splat as it is displayed alone, and
// how that changes with direction to first order. Where splats are seen through each other it comes out a
// little different. The model must be valid; one of the display's colours is what it was.
Splats asDisplayed(Splats splats);

// The mean depth of the splats that each pixel shows, in mm along the camera's z, from their sums of weight
// times depth; +infinity where coverage is not above minCoverage.
std::vector<float> meanDepthsMm(std::span<const glm::vec4> pixels, std::span<const float> depthSums,
                                float minCoverage = 0.5f);

}  // namespace macula::splat
