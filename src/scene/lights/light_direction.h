// Where the lights of a rig shine from in the world, and on a dome that lies over the picture: there a hand
// takes them. World frame: patient LPS.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "pipeline/trace/environment.h"

namespace macula::app {

// What turns a rig: its frame, the eye that a rig on the camera hangs on, and Settings::lightRotationDeg.
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
// eye (Snyder, Map Projections: A Working Manual, 1987, section 25): its middle shines from the eye, the
// circle at half of its radius from the sides, the rim from behind. It is round, and as large as the picture
// has room for. Places are -1 to 1 on both sides, right and up positive.
glm::dvec2 placeOnDome(const glm::dvec3& direction, const CameraBasis& eye, double aspect);
glm::dvec3 directionOnDome(const glm::dvec2& place, const CameraBasis& eye,
                           double aspect);  // outside: the rim
// A point of the circle that is so many degrees from the middle.
glm::dvec2 circleOnDome(double fromMiddleDeg, double aroundRad, double aspect);

}  // namespace macula::app
