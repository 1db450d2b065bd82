// Distances in mm to a mask, and the morphology that is made of them: exact on anisotropic grids.
#pragma once

#include "base/result.h"
#include "segment/coarse_grid.h"

namespace macula::segment {

// Of each block, to the nearest one in the mask, mm; 0 within, infinite where the mask is empty.
Result<std::vector<float>> distanceTo(const Grid& grid, const Mask& mask);

struct Opened {
    Mask mask;
    std::vector<float> depthMm;  // of each block to the outside of what was opened
};

// What of the mask a ball of this radius can reach without leaving it, where the mask goes on beyond the edge
// of the grid.
Result<Opened> opened(const Grid& grid, const Mask& mask, double radiusMm);

}  // namespace macula::segment
