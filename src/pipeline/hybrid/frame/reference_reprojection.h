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
    std::vector<glm::dvec2> depths;   // mm from the eye, negative without a surface; uncertainty, mm
    std::vector<double> trusts = {};  // 0 to 1; empty: all are 1
};
struct ReferenceReprojection {
    std::vector<glm::dvec4> lights;
    std::vector<double> weights;  // 0 to 1
    std::vector<double> trusts;   // likewise; undefined where the weight is 0
};

// `before` has push.beforeSize, the result push.size. `expectedMm`, of push.size or empty, are the depths of
// splats along the middle of the view, in mm, negative where unknown.
ReferenceReprojection reproject(const shared::ReprojectPush& push, const ReferenceCapture& before,
                                std::span<const double> expectedMm = {});

// shaders/lib/trust.glsl for a picture of this size; `splats` are linear and premultiplied.
std::vector<double> trustIn(const glm::ivec2& sizePx, std::span<const glm::dvec4> lights,
                            std::span<const double> variances, std::span<const glm::dvec4> splats,
                            double splatGain);

// shaders/lib/feather.glsl for a picture of this size.
std::vector<double> feather(const glm::ivec2& sizePx, std::span<const double> weights);

}  // namespace macula::hybrid
