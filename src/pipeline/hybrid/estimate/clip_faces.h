// Where a clip cuts through coarse matter, and the greys that its faces show there.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "pipeline/hybrid/estimate/coarse_matter.h"

namespace macula::hybrid {

// A place on a face: a shown sample of a cell, next to a place that the shape of the clip removes.
struct FacePlace {
    std::uint32_t cell = 0;
    glm::dvec3 voxel{0.0};
    glm::dvec3 outwards{0.0};  // unit, mm of the world
    float radiance = 0.0f;     // linear and grey, before exposure and tone map
};

// Places half a cell edge apart, except where a face is transparent; none if faces show no values. Uses all
// cores.
std::vector<FacePlace> facePlaces(const CoarseMatter& matter, const ShownMatter& shown);

}  // namespace macula::hybrid
