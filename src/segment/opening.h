// Morphology by distances in mm: exact on anisotropic grids.
#pragma once

#include "base/result.h"
#include "segment/coarse_grid.h"

namespace macula::segment {

struct Opened {
    Mask mask;
    std::vector<float> depthMm;  // of each block to the outside of what was opened
};

// Morphological opening: the part of the mask that a ball of this radius can reach without leaving it, where
// the mask goes on beyond the edge of the grid.
Result<Opened> opened(const Grid& grid, const Mask& mask, double radiusMm);

}  // namespace macula::segment
