// A model of splats in double, for the reference rasterizer: its input, or the derivative by that. Finite
// differences need parameters with more digits than Splats has.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "pipeline/splat/model/splats.h"

namespace macula::splat {

// Arrays, units and order as in Splats.
struct ReferenceSplats {
    int shDegree = 0;
    std::vector<glm::dvec3> position;
    std::vector<glm::dvec3> logScale;
    std::vector<glm::dvec4> rotation;  // w, x, y, z
    std::vector<double> opacityLogit;
    std::vector<glm::dvec3> dc;
    std::vector<glm::dvec3> sh;

    ReferenceSplats() = default;
    // All 0, quaternions too: the start of a sum of derivatives.
    ReferenceSplats(std::size_t count, int degree);
    explicit ReferenceSplats(const Splats& splats);

    std::size_t size() const { return position.size(); }
};

}  // namespace macula::splat
