// Euclidean distances on the coarse grid, and morphological opening by them.
#pragma once

#include <vector>

#include "base/progress.h"
#include "segment/coarse_grid.h"

namespace macula::segment {

// The distance of each block's centre to that of the nearest block in the mask, in mm: 0 within, infinite
// where the mask is empty. Exact except for rounding: a pass for each axis takes the lower envelope of the
// parabolas around its blocks (Felzenszwalb and Huttenlocher, Distance transforms of sampled functions,
// 2012). Incomplete when cancelled. May throw std::bad_alloc.
std::vector<float> distanceTo(const Grid& grid, const Mask& mask, const CancelToken& token = {});

struct Opened {
    Mask mask;
    std::vector<float> depthMm;  // from each block to the nearest one outside the input mask
};

// Morphological opening by distances in mm, exact on anisotropic grids: the part of the mask that a ball of
// this radius covers without leaving it. The mask counts as continuing beyond the edge of the grid. May throw
// std::bad_alloc.
Opened opened(const Grid& grid, const Mask& mask, double radiusMm);

}  // namespace macula::segment
