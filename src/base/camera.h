// A camera in patient LPS mm: an eye, or parallel rays.
#pragma once

#include <span>

#include "base/frames.h"
#include "base/result.h"

namespace macula {

struct Camera {
    glm::dvec3 positionMm{0.0, -1000.0, 0.0};
    glm::dvec3 targetMm{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};  // need not be perpendicular to the view direction, only not parallel
    double verticalFovDeg = 30.0;
    // Above 0: the rays are parallel, and this is the height of the picture at every depth. They start in the
    // plane through the position, perpendicular to the view. The field of view then only determines how far
    // away an eye would stand that sees as much (inPerspective).
    double parallelHeightMm = 0.0;

    bool operator==(const Camera&) const = default;
};

inline bool isParallel(const Camera& camera) {
    return camera.parallelHeightMm > 0.0;
}

// The height of the picture in mm at the depth of the target; of a parallel camera, at every depth.
double heightAtTargetMm(const Camera& camera);

// inParallel gives the parallel camera that shows as much of the target's plane as `camera` does;
// inPerspective gives the camera whose eye sees as much of that plane.
Camera inParallel(Camera camera);
Camera inPerspective(Camera camera);

// Moves a parallel camera back until its rays start in front of all of `box`. The picture stays the same, and
// depths count from the new position. A camera with an eye is returned unchanged.
Camera standingBefore(Camera camera, const Box& box);

// Orthonormal: right = forward x up, as seen in the picture.
struct CameraBasis {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 forward;
};

inline constexpr double kLeastParallelMm = 1e-3;
inline constexpr double kMostParallelMm = 1e6;

// Fails with usage when position and target coincide, up is parallel to the view, a number is not finite,
// the field of view is not between 0.1 and 170 degrees, or the height of a parallel picture is not between
// kLeastParallelMm and kMostParallelMm.
Result<CameraBasis> basis(const Camera& camera);

// Looks at the centre of `box` from a standard direction, superior up (anterior up for the views from above
// and below), far enough that the whole box is in the picture.
Camera frameBox(const Box& box, ViewDirection from, double verticalFovDeg, double aspectWidthOverHeight);

// The axes of the camera that frameBox returns.
CameraBasis standardBasis(ViewDirection from);

// Looks along `axes` at the points (at least one), from the distance at which their outline fills
// `kFittedPart` of the width or of the height of the picture, in its middle. The target is on the view axis,
// at the depth of the middle of the points' bounding box, so that the points stay roughly centred while the
// camera orbits.
inline constexpr double kFittedPart = 0.9;
Camera framePoints(std::span<const glm::dvec3> pointsMm, const CameraBasis& axes, double verticalFovDeg,
                   double aspectWidthOverHeight);

// The same with parallel rays. The target is the middle of the points' bounding box along the axes.
Camera frameInParallel(std::span<const glm::dvec3> pointsMm, const CameraBasis& axes, double verticalFovDeg,
                       double aspectWidthOverHeight);

}  // namespace macula
