// Masks the pixels that lie within the fovea: the cone around the gaze that an eye sees sharply.
#pragma once

#include <glm/glm.hpp>

#include "base/result.h"
#include "image/masked_metrics.h"

namespace macula::image {

struct FoveaInPicture {
    glm::ivec2 sizePx{0};         // of the picture; its pixels are square
    double verticalFovDeg = 0.0;  // of the picture
    glm::dvec2 gaze{0.0};         // in the picture, -1 to 1, right and up are positive
    double fieldDeg = 0.0;        // of the fovea, from side to side
};

// The mask of pixels whose centre lies within half of `fieldDeg` of the gaze. The angle is measured at the
// eye, so away from the middle of the picture the mask is not a disc. Fails with usage when the size is
// empty, an angle is out of range (0.1 to 170 degrees, a field above 0 and at most 180), or the gaze is
// outside the picture.
Result<Mask> foveaMask(const FoveaInPicture& fovea);

}  // namespace macula::image
