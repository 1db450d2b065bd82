// Linear pictures as they are displayed, on the host: the last kernel of the tracer
// (shaders/trace/display.comp) for those that come from elsewhere.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace macula::hybrid {

// Linear premultiplied RGBA over black, exposed, tone-mapped, sRGB-encoded, rounded to 8 bits: three bytes a
// pixel.
std::vector<std::uint8_t> displayed(std::span<const glm::vec4> rgba, double exposure = 1.0);

}  // namespace macula::hybrid
