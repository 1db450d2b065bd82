// Borders of a clip as rows of dots, for the 3D picture. World frame: patient LPS, mm.
#pragma once

#include <vector>

#include "base/frames.h"
#include "pipeline/volume/clip.h"

namespace macula::scene {

std::vector<glm::dvec3> dotsOfBox(const Box& box);                            // its edges
std::vector<glm::dvec3> dotsOfPlane(const HalfSpace& plane, const Box& box);  // where it meets the box

}  // namespace macula::scene
