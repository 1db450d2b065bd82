// Pictures of a model of splats, drawn on the device.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/camera.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/splat/model/splats.h"

namespace macula::hybrid {

// Both lists are by camera.
struct DrawnViews {
    std::vector<std::vector<glm::vec4>>
        pictures;                      // premultiplied RGBA in the model's colour space, row 0 on top
    std::vector<double> milliseconds;  // drawing times; the first one includes compilation
};

// The model must be valid; without splats all pictures are empty. Waits for the device.
Result<DrawnViews> drawViews(const std::shared_ptr<gpu::Device>& device, const splat::Splats& splats,
                             std::span<const Camera> cameras, const glm::ivec2& sizePx);

}  // namespace macula::hybrid
