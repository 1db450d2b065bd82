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
    double rollDeg = 0.0;     // in [-180, 180): by so much the patient is turned clockwise in the picture
    bool isParallel = false;  // shows as much of the plane of the target as the eye would
};

Camera toCamera(const OrbitCamera& camera);
// The orbit camera that shows what `camera` shows, which must be valid (basis()). A parallel camera gives the
// distance of an eye that sees as much, wherever it stands.
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

// Turns the patient clockwise in the picture. A drag to the right over the height of the picture is half a
// turn.
OrbitCamera rolled(OrbitCamera camera, double clockwiseDeg);
OrbitCamera rolledByDrag(const OrbitCamera& camera, double dxPx, double heightPx);

// The eye and what it turns around go forward together, into what is seen; negative: back. Nothing moves
// farther than the diagonal of the scene from its middle.
OrbitCamera flown(OrbitCamera camera, double forwardMm, const Box& sceneMm);

// Looks at the same place from there, upright and as near as before.
OrbitCamera turnedTo(OrbitCamera camera, ViewDirection from);

// Millimetres of a pixel of a picture `heightPx` high, at the depth of the target; of a parallel camera at
// every depth.
double mmPerPixel(const OrbitCamera& camera, double heightPx);

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
