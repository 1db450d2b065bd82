// A turntable camera: it circles a target, with the patient's superior axis upright unless the camera is
// rolled.
#pragma once

#include <span>

#include "base/camera.h"
#include "base/frames.h"

namespace macula::scene {

// The angles give the direction from the target to the eye. Azimuth 0 is anterior, positive towards the
// patient's left; elevation 90 is superior. The up direction follows from both, at the poles too, so the view
// from above needs no special case and never flips.
struct OrbitCamera {
    glm::dvec3 targetMm{0.0};
    double distanceMm = 1000.0;
    double azimuthDeg = 0.0;    // kept in [-180, 180)
    double elevationDeg = 0.0;  // kept in [-90, 90]
    double verticalFovDeg = 30.0;
    double rollDeg = 0.0;     // in [-180, 180): turns the patient clockwise in the picture
    bool isParallel = false;  // its picture is as high as an eye would see at the target
};

Camera toCamera(const OrbitCamera& camera);
// The orbit camera with the picture of `camera`, which must be valid (basis()). A parallel camera gets the
// distance of an eye that sees as much.
OrbitCamera orbitCameraOf(const Camera& camera);

// Shows all the points from as near as possible (framePoints): `framed` from the direction `from`, `fitted`
// in the view direction of `camera`.
OrbitCamera framed(std::span<const glm::dvec3> pointsMm, ViewDirection from, double verticalFovDeg,
                   double aspectWidthOverHeight);
OrbitCamera fitted(OrbitCamera camera, std::span<const glm::dvec3> pointsMm, double aspectWidthOverHeight);

// Moves the eye around the target: towards the patient's left by azimuth, upwards by elevation.
OrbitCamera orbited(OrbitCamera camera, double azimuthDeg, double elevationDeg);

// The camera after a drag by (dx, dy) pixels, y downwards, in a picture `heightPx` high. orbitedByDrag turns
// the patient with the cursor, half a turn per picture height. pannedByDrag keeps the point of the target
// plane under the cursor.
OrbitCamera orbitedByDrag(const OrbitCamera& camera, double dxPx, double dyPx, double heightPx);
OrbitCamera pannedByDrag(OrbitCamera camera, double dxPx, double dyPx, double heightPx);

// Turns the patient clockwise in the picture. A drag to the right over the picture height is half a turn.
OrbitCamera rolled(OrbitCamera camera, double clockwiseDeg);
OrbitCamera rolledByDrag(const OrbitCamera& camera, double dxPx, double heightPx);

// Moves the eye and the target together along the view; negative moves back. Does nothing if the target would
// get farther from the middle of the scene than its diagonal, and not nearer than it was.
OrbitCamera flown(OrbitCamera camera, double forwardMm, const Box& sceneMm);

// Looks at the same target from `from`, upright and at the same distance.
OrbitCamera turnedTo(OrbitCamera camera, ViewDirection from);

// Millimetres per pixel in a picture `heightPx` high, at the depth of the target; for a parallel camera at
// every depth.
double mmPerPixel(const OrbitCamera& camera, double heightPx);

// Divides the distance by `magnification`, within 0.02 to 20 times `sceneDiagonalMm`: the eye neither reaches
// the target nor loses the patient.
OrbitCamera zoomed(OrbitCamera camera, double magnification, double sceneDiagonalMm);

// The letters at the edges of the picture; "PS" at an edge means mainly posterior, then superior.
struct EdgeLetters {
    std::string left;
    std::string right;
    std::string top;
    std::string bottom;
};
EdgeLetters edgeLetters(const OrbitCamera& camera);

}  // namespace macula::scene
