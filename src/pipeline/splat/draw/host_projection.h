// Projects splats into the picture on the host: for models that are larger than a device's buffers, of which
// one view usually shows only a part.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "pipeline/splat/draw/raster_view.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

// Returns what shaders/splat/project.comp writes, kScreenTexels for each splat, but only for visible splats,
// in their order. The view and the blending must be valid.
std::vector<glm::vec4> projectOnHost(const Splats& splats, const RasterView& view, const Blending& blending);

}  // namespace macula::splat
