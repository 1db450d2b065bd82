// Morphology by distances in mm: exact on anisotropic grids.
#pragma once

#include <vector>

#include "segment/coarse_grid.h"

namespace macula::segment {

struct Opened {
    Mask mask;
    std::vector<float> depthMm;  // from each block to the nearest one outside the input mask
};

// Morphological opening: the part of the mask that a ball of this radius covers without leaving it. The mask
// counts as continuing beyond the edge of the grid. May throw std::bad_alloc.
Opened opened(const Grid& grid, const Mask& mask, double radiusMm);

}  // namespace macula::segment
