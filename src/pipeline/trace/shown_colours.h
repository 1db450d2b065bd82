// The display colours of light in host memory: PathTracer::display does the same on the device.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/trace/settings.h"

namespace macula::trace {

// Composes linear premultiplied radiance over `background` (linear), with the settings' exposure and tone
// map; returns display-encoded, opaque RGBA8.
std::vector<std::uint8_t> shownColours(std::span<const glm::vec4> radiance, const glm::vec3& background,
                                       const Settings& settings);

}  // namespace macula::trace
