// LightTable::lit as C++ in double, for tests of the kernel.
#pragma once

#include <span>

#include "base/result.h"
#include "pipeline/hybrid/light/light_in_space.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "shared/pixel_layers.h"

namespace macula::hybrid {

// `layers` are those of a picture with `raysAside` times as many pixels along each side.
Result<TracedView> referenceLitView(std::span<const shared::PixelLayers> layers, const Camera& camera,
                                    const glm::ivec2& sizePx, int raysAside, const LightInSpace& light);

}  // namespace macula::hybrid
