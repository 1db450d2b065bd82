// A picture that a model learns from, with its camera, weight and kind.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "pipeline/splat/draw/raster_view.h"

namespace macula::splat {

inline constexpr float kMaxViewWeight = 1e6f;

enum class ViewKind : std::uint32_t {  // values are stored in files
    picture = 0,                       // what the camera sees
    outline = 1,  // only its coverage: its unknown colours teach nothing, and colours only continue a little
                  // in the direction of earlier steps (Adam's first moment)
    standIn = 2,  // what the camera probably sees, used while there are few pictures
};

struct TrainingView {
    RasterView view;                // relative to the model's origin
    std::vector<glm::vec4> pixels;  // premultiplied RGBA in the model's colour space, row 0 on top
    float weight = 1.0f;            // of its loss relative to other views; above 0, at most kMaxViewWeight
    ViewKind kind = ViewKind::picture;
};

}  // namespace macula::splat
