// Fills lungs, bowel gas and everything else within the patient that is not solid.
#pragma once

#include "base/result.h"
#include "segment/coarse_grid.h"

namespace macula::segment {

// Adds to the mask, slice by slice, the regions that it encloses. Up to a third of a region's border may be
// the edge of the field of view, which may cut through a hollow organ; with more, the region is the room.
Result<void> fillEnclosed(const Grid& grid, const Mask& outside, Mask& mask, const CancelToken& token);

}  // namespace macula::segment
