// The points of the fixed volume that the moving one is compared at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "registration/intensity_bins.h"
#include "registration/scalar_grid.h"

namespace macula::registration {

struct SamplePoint {
    glm::dvec3 mm{0.0};  // in the world of the fixed volume
    int bin = 0;         // of its value there
};

// About `wanted` of them, spread over all that has a value; each somewhere within its cell, because points on
// a grid make a grid of wrong answers. A function of the grid, the number and the seed: nothing of it is left
// to chance.
std::vector<SamplePoint> samplePoints(const ScalarGrid& grid, const IntensityBins& bins, std::size_t wanted,
                                      std::uint64_t seed);

}  // namespace macula::registration
