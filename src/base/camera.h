// A camera in patient LPS mm: an eye, or parallel rays.
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
    // Above 0: rays are parallel, and the picture is so high, whatever its depth. They begin in the plane
    // through the position, across the view; the field of view says how far away an eye would stand that sees
    // as much.
    double parallelHeightMm = 0.0;

    bool operator==(const Camera&) const = default;
};

inline bool isParallel(const Camera& camera) {
    return camera.parallelHeightMm > 0.0;
}

// How high the picture is in mm at the depth of the target; of a parallel camera at every depth.
double heightAtTargetMm(const Camera& camera);

// The parallel camera that shows as much of the plane of the target as `camera` does, and the reverse: an eye
// as far from the target as shows that much.
Camera inParallel(Camera camera);
Camera inPerspective(Camera camera);

// A parallel camera is moved back until its rays begin before all of `box`: it has no eye that something
// could lie behind. Its picture shows the same, and distances are from where it stands then. One with an eye
// stays.
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

// The axes of the picture of frameBox.
CameraBasis standardBasis(ViewDirection from);

// Looks along `axes` at `points`, at least one, from as near as their outline leaves a margin: it fills
// `kFittedPart` of the width or of the height of the picture, and is in the middle of it. The target is
// beside the middle of the box around them, so that a camera that walks around the target keeps them in the
// middle about as well.
inline constexpr double kFittedPart = 0.9;
Camera framePoints(std::span<const glm::dvec3> pointsMm, const CameraBasis& axes, double verticalFovDeg,
                   double aspectWidthOverHeight);

// The same with parallel rays: the middle of the box around the points is the target.
Camera frameInParallel(std::span<const glm::dvec3> pointsMm, const CameraBasis& axes, double verticalFovDeg,
                       double aspectWidthOverHeight);

// The corners of a box, for framePoints.
std::array<glm::dvec3, 8> cornersOf(const Box& box);

}  // namespace macula
