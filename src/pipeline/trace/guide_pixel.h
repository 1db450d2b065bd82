// What the centre ray of one pixel meets: shaders/lib/guides.glsl says how it is found.
#pragma once

#include <glm/glm.hpp>

#include "base/result.h"
#include "pipeline/trace/settings.h"
#include "shared/guide_params.h"

namespace macula::trace {

// With depth of field it is the mean over rays through the lens: normals that differ add to less than
// length 1. World is patient LPS mm; pixels are counted from the top left corner of the picture.
template <class Real>
struct GuideOf {
    Real depthMm{-1};    // along the eye ray to transmittance 1/2; negative when it does not fall so far
    Real confidence{0};  // 0 to 1, of the depth: f / (f + s), s the length from transmittance 3/4 to 1/4, f
                         // the width of four pixels there; fades to 0 as coverage falls from 3/4 to 1/2
    Real coverage{0};    // 1 - transmittance of the whole ray
    Real beforeMm{-1};   // distance of the same point from the eye before; negative when there is none
    // Mean over the matter down to transmittance 1/2. A grey face of a clip counts with the light it sends at
    // exposure 1, which near white is above 1.
    glm::vec<3, Real> albedo{Real(0)};
    glm::vec<3, Real> normal{Real(0)};  // unit, towards the eye; 0 where the values around are all the same
    glm::vec<2, Real> motion{Real(0)};  // pixels: where it was in the view before, minus where it is
};
using GuidePixel = GuideOf<float>;

// The eye of `before`, and where that of `now` is from there. Fails with usage when a camera is not usable.
Result<shared::GuidePush> guidePush(const View& now, const View& before);

}  // namespace macula::trace
