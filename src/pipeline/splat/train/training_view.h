// A picture that a model is to look like: from where, and how good it is.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "pipeline/splat/draw/raster_view.h"

namespace macula::splat {

inline constexpr float kMaxViewWeight = 1e6f;

enum class ViewKind : std::uint32_t {  // as in files
    picture = 0,                       // what is seen from there
    outline = 1,  // its coverage: colours are not known and teach nothing, they only go on a little by what
                  // moved them before (Adam's first moment)
    standIn = 2,  // what is likely seen from there, as long as there are few pictures
};

struct TrainingView {
    RasterView view;                // relative to the model's origin
    std::vector<glm::vec4> pixels;  // premultiplied RGBA in the model's colour space, row 0 on top
    float weight = 1.0f;            // of its loss beside those of others, 0 to kMaxViewWeight, not 0
    ViewKind kind = ViewKind::picture;
};

}  // namespace macula::splat
