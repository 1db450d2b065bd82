// The directions of a rig's lights in the world, and their places on a dome over the picture, where a user
// drags them. World frame: patient LPS.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "pipeline/trace/environment.h"

namespace macula::scene {

// The orientation of a rig: its frame, the camera for a rig that is fixed to it, and
// Settings::lightRotationDeg.
struct LightStand {
    trace::LightFrame frame = trace::LightFrame::patient;
    CameraBasis eye = {};
    double rotationDeg = 0.0;
};

// Unit vector towards the light.
glm::dvec3 directionTo(const trace::SoftLight& light, const LightStand& stand);
// Gives the light the azimuth and elevation of that direction, in patient LPS, which need not be a unit
// vector. A direction that is zero or not finite leaves the light where it is.
trace::SoftLight shiningFrom(trace::SoftLight light, const glm::dvec3& direction, const LightStand& stand);

// The dome is the azimuthal equidistant projection of all directions, centred on that from the patient to the
// eye (Snyder, Map Projections: A Working Manual, 1987, section 25): light at its middle comes from the eye,
// on the circle at half its radius from the sides, at the rim from behind. It is a circle, nearly as large as
// the picture has room for. Places are -1 to 1 on both sides, right and up positive.
glm::dvec2 placeOnDome(const glm::dvec3& direction, const CameraBasis& eye, double aspect);
glm::dvec3 directionOnDome(const glm::dvec2& place, const CameraBasis& eye,
                           double aspect);  // outside the dome: its rim
// The place at `fromMiddleDeg` from the middle, counter-clockwise by `aroundRad` from the right.
glm::dvec2 circleOnDome(double fromMiddleDeg, double aroundRad, double aspect);

}  // namespace macula::scene
