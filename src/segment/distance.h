// Euclidean distances on the coarse grid.
#pragma once

#include <vector>

#include "segment/coarse_grid.h"

namespace macula::segment {

// The distance of each block's centre to that of the nearest block in the mask, in mm: 0 within, infinite
// where the mask is empty. Exact except for rounding: a pass for each axis takes the lower envelope of the
// parabolas around its blocks (Felzenszwalb and Huttenlocher, Distance transforms of sampled functions,
// 2012). May throw std::bad_alloc.
std::vector<float> distanceTo(const Grid& grid, const Mask& mask);

}  // namespace macula::segment
