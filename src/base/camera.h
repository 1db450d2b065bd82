// A pinhole camera in patient LPS mm.
#pragma once

#include <array>
#include <span>

#include "base/frames.h"
#include "base/result.h"

namespace macula {

struct Camera {
    glm::dvec3 positionMm{0.0, -1000.0, 0.0};
    glm::dvec3 targetMm{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};  // need not be perpendicular to the view direction, only not parallel
    double verticalFovDeg = 30.0;

    bool operator==(const Camera&) const = default;
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

// The axes of the picture of frameBox.
CameraBasis standardBasis(ViewDirection from);

// Looks along `axes` at `points`, at least one, from as near as their outline leaves a margin: it fills
// `kFittedPart` of the width or of the height of the picture, and is in the middle of it. The target is
// beside the middle of the box around them, so that a camera that walks around the target keeps them in the
// middle about as well.
inline constexpr double kFittedPart = 0.9;
Camera framePoints(std::span<const glm::dvec3> pointsMm, const CameraBasis& axes, double verticalFovDeg,
                   double aspectWidthOverHeight);

// The corners of a box, for framePoints.
std::array<glm::dvec3, 8> cornersOf(const Box& box);

}  // namespace macula
