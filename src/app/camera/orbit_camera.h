// A camera on a turntable: it looks at a target and walks around it, the patient's superior axis upright.
#pragma once

#include <span>

#include "base/camera.h"
#include "base/frames.h"

namespace macula::app {

// Angles say where the eye is, seen from the target. Azimuth 0 is anterior, positive towards the patient's
// left; elevation 90 is superior. The up direction follows from both, at the poles too, so the view from
// above needs no special case and never flips.
struct OrbitCamera {
    glm::dvec3 targetMm{0.0};
    double distanceMm = 1000.0;
    double azimuthDeg = 0.0;    // kept in [-180, 180)
    double elevationDeg = 0.0;  // kept in [-90, 90]
    double verticalFovDeg = 30.0;
};

Camera toCamera(const OrbitCamera& camera);
// The orbit camera that stands where `camera` stands and looks where it looks. A turntable is always upright:
// of a camera that is rolled only that is lost. The camera must be valid (basis()).
OrbitCamera orbitCameraOf(const Camera& camera);

// Looks at the points from `from`, or from the side that `camera` looks from, as near as they fit
// (framePoints).
OrbitCamera framed(std::span<const glm::dvec3> pointsMm, ViewDirection from, double verticalFovDeg,
                   double aspectWidthOverHeight);
OrbitCamera fitted(OrbitCamera camera, std::span<const glm::dvec3> pointsMm, double aspectWidthOverHeight);

// Walks the eye around the target: towards the patient's left and up, seen from the front.
OrbitCamera orbited(OrbitCamera camera, double azimuthDeg, double elevationDeg);

// What a drag by (dx, dy) pixels, y downwards, does in a picture `heightPx` high. orbitedByDrag turns the
// patient with the cursor, half a turn for the height of the picture. pannedByDrag keeps the point of the
// target plane that was under the cursor under it.
OrbitCamera orbitedByDrag(const OrbitCamera& camera, double dxPx, double dyPx, double heightPx);
OrbitCamera pannedByDrag(OrbitCamera camera, double dxPx, double dyPx, double heightPx);

// Divides the distance by `magnification`, within limits that keep the eye from reaching the target and from
// losing a patient of `sceneDiagonalMm`.
OrbitCamera zoomed(OrbitCamera camera, double magnification, double sceneDiagonalMm);

// The letters at the edges of the picture; "PS" at an edge means mainly posterior, then superior.
struct EdgeLetters {
    std::string left;
    std::string right;
    std::string top;
    std::string bottom;
};
EdgeLetters edgeLetters(const OrbitCamera& camera);

}  // namespace macula::app
