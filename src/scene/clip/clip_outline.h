// The line where a slice meets what a clip keeps, and dots for borders in the 3D picture. World frame:
// patient LPS, mm.
#pragma once

#include <vector>

#include "scene/clip/kept_box.h"
#include "slices/slice_plane.h"

namespace macula::scene {

// The convex polygon in which the box meets the plane, in order from the plane's right towards its down.
// Empty if they do not meet in an area, or a number is not finite.
std::vector<glm::dvec3> outlineMm(const Box& box, const slices::SlicePlane& plane);

// The outline of keptBox; empty also when that is all of the volume, or nothing.
std::vector<glm::dvec3> keptOutlineMm(const OptionalClip& clip, const Volume& volume,
                                      const slices::SlicePlane& plane);

// Rows of dots, for the 3D picture: on the edges of the box, and where a plane meets it.
std::vector<glm::dvec3> dotsOfBox(const Box& box);
std::vector<glm::dvec3> dotsOfPlane(const HalfSpace& plane, const Box& box);

}  // namespace macula::scene
