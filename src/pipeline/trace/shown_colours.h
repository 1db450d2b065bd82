// The colours that a display shows of light that lies in host memory: what PathTracer::display does on the
// device.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/trace/settings.h"

namespace macula::trace {

// RGBA8, opaque, display-encoded, of linear premultiplied radiance over `background` (linear), by exposure
// and tone map of the settings.
std::vector<std::uint8_t> shownColours(std::span<const glm::vec4> radiance, const glm::vec3& background,
                                       const Settings& settings);

}  // namespace macula::trace
