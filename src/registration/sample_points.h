// The points of the fixed volume at which the moving one is compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "registration/intensity_bins.h"
#include "registration/scalar_grid.h"

namespace macula::registration {

struct SamplePoint {
    glm::dvec3 mm{0.0};  // in the world of the fixed volume
    int bin = 0;         // the bin of the fixed volume's value there
};

// About `wanted` points, spread over all cells with a value; `seed` jitters each within its cell, because
// points on a grid cause a grid of wrong answers. The result depends only on the four arguments.
std::vector<SamplePoint> samplePoints(const ScalarGrid& grid, const IntensityBins& bins, std::size_t wanted,
                                      std::uint64_t seed);

}  // namespace macula::registration
