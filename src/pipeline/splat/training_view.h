// A picture that a model is to look like: from where, and how good it is.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "pipeline/splat/raster_view.h"

namespace macula::splat {

inline constexpr float kMaxViewWeight = 1e6f;

struct TrainingView {
    RasterView view;                // relative to the model's origin
    std::vector<glm::vec4> pixels;  // premultiplied RGBA in the model's colour space, row 0 on top
    float weight = 1.0f;            // of its loss beside those of others, 0 to kMaxViewWeight, not 0
    // The colours of `pixels` are not known and teach nothing; those of the model only go on a little by what
    // moved them before (Adam's first moment).
    bool coverageOnly = false;
};

}  // namespace macula::splat
