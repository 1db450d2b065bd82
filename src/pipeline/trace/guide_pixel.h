// What the centre ray of one pixel meets: shaders/lib/guides.glsl says how it is found.
#pragma once

#include <glm/glm.hpp>

#include "base/result.h"
#include "pipeline/trace/settings.h"
#include "shared/guide_params.h"

namespace macula::trace {

// With depth of field each value is the mean over rays through the lens, so that a mean of unlike normals is
// shorter than 1. World is patient LPS mm; pixels count from the top left corner of the picture.
template <class Real>
struct GuideOf {
    Real depthMm{-1};  // along the eye ray, to transmittance 1/2; negative if it does not fall so far
    // Of depthMm, 0 to 1: f / (f + s), where s is the length from transmittance 3/4 to 1/4 and f the width of
    // four pixels there. Fades to 0 as coverage falls from 3/4 to 1/2.
    Real confidence{0};
    Real coverage{0};   // 1 - transmittance of the whole ray
    Real beforeMm{-1};  // distance of the same point from the previous eye; negative if there is none
    // Mean over the matter down to transmittance 1/2. A grey clip face counts with the light that it sends at
    // exposure 1, which exceeds 1 near white.
    glm::vec<3, Real> albedo{Real(0)};
    glm::vec<3, Real> normal{Real(0)};  // unit, towards the eye; 0 where the values around are equal
    glm::vec<2, Real> motion{Real(0)};  // pixels: position in the previous view minus position now
};
using GuidePixel = GuideOf<float>;

// The eye of `before`, and the position of `now`'s eye relative to it. Fails with usage when the camera of
// `before` is not usable.
Result<shared::GuidePush> guidePush(const View& now, const View& before);

}  // namespace macula::trace
