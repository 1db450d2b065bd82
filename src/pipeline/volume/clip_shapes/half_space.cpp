// What lies on one side of a plane. The planes of a preset are in clip_json.cpp.
#include "pipeline/volume/clip_shape_parts.h"

namespace macula {

std::vector<double> HalfSpace::numbers() const {
    return {normal.x, normal.y, normal.z, offsetMm};
}

Result<void> HalfSpace::check() const {
    const bool isUnit = isFinite(normal) && std::abs(glm::length(normal) - 1.0) < 1e-6;
    if (!isUnit || !std::isfinite(offsetMm))
        return clipNotUsable(Text("a plane has no direction"),
                             Text("Give its normal as a unit vector, and its distance in mm."));
    return {};
}

}  // namespace macula
