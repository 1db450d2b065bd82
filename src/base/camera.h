// A pinhole camera in patient LPS mm.
#pragma once

#include "base/frames.h"
#include "base/result.h"

namespace macula {

struct Camera {
    glm::dvec3 positionMm{0.0, -1000.0, 0.0};
    glm::dvec3 targetMm{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};  // need not be perpendicular to the view direction, only not parallel
    double verticalFovDeg = 30.0;
};

// Orthonormal: right = forward x up, as seen in the picture.
struct CameraBasis {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 forward;
};

// Fails with usage when position and target coincide, up is parallel to the view, a number is not finite, or
// the field of view is not between 0.1 and 170 degrees.
Result<CameraBasis> basis(const Camera& camera);

// Looks at the centre of `box` from a standard direction, superior up (anterior up for the views from above
// and below), far enough that the whole box is in the picture.
Camera frameBox(const Box& box, ViewDirection from, double verticalFovDeg, double aspectWidthOverHeight);

}  // namespace macula
