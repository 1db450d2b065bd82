// Where a slice meets what a clip keeps, to be drawn on the slice. World frame: patient LPS, mm.
#pragma once

#include <vector>

#include "scene/clip/kept_box.h"
#include "slices/slice_plane.h"

namespace macula::app {

// The convex polygon in which the box meets the plane, from the plane's right to its down and on. Empty where
// they do not meet or touch in less than an area, and when a number is not finite.
std::vector<glm::dvec3> outlineMm(const Box& box, const slices::SlicePlane& plane);

// That of keptBox; empty also where the faces cut nothing off, or leave nothing.
std::vector<glm::dvec3> keptOutlineMm(const ClipChoice& clip, const Volume& volume,
                                      const slices::SlicePlane& plane);

}  // namespace macula::app
