// Reprojection as scalar C++ in double: the same maths (shaders/lib/reproject.glsl), slow, for tests.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "shared/reproject_params.h"

namespace macula::hybrid {

// By pixel, row 0 on top.
struct ReferenceCapture {
    std::vector<glm::dvec4> lights;   // premultiplied, linear
    std::vector<glm::dvec2> depths;   // mm from the eye, negative where there is none; uncertainty, mm
    std::vector<double> trusts = {};  // 0 to 1; none: all are 1
};
struct ReferenceReprojection {
    std::vector<glm::dvec4> lights;
    std::vector<double> weights;  // 0 to 1
    std::vector<double> trusts;   // likewise; where the weight is 0, any
};

// `before` is of push.beforeSize; the result of push.size, and so are the depths along the middle of the view
// at which splats show something, mm, negative where they do not tell. Empty: they tell nothing.
ReferenceReprojection reproject(const shared::ReprojectPush& push, const ReferenceCapture& before,
                                std::span<const double> expectedMm = {});

// shaders/lib/trust.glsl, of a picture of that size; `splats` are linear and premultiplied.
std::vector<double> trustIn(const glm::ivec2& sizePx, std::span<const glm::dvec4> lights,
                            std::span<const double> variances, std::span<const glm::dvec4> splats,
                            double splatGain);

// shaders/lib/feather.glsl, of a picture of that size.
std::vector<double> feather(const glm::ivec2& sizePx, std::span<const double> weights);

}  // namespace macula::hybrid
