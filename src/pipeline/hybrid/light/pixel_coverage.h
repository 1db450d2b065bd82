// How much of each pixel matter covers, without noise.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/trace/guide_pixel.h"

namespace macula::hybrid {

// The coverage of each pixel of a picture, averaged over its area: linear between the rays through the
// centres around it, as the denoiser measures it (massAround in shaders/lib/denoise_prepare.glsl). Row 0 on
// top; 0 to 1.
std::vector<float> pixelCoverage(std::span<const trace::GuidePixel> guides, const glm::ivec2& sizePx);

// The same, from the coverage along the centre rays (GuidePixel::coverage).
std::vector<float> pixelCoverageOf(std::span<const float> atCentres, const glm::ivec2& sizePx);

}  // namespace macula::hybrid
