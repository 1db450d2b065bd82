// Fills lungs, bowel gas and all else that lies within the patient without being solid.
#pragma once

#include "base/result.h"
#include "segment/coarse_grid.h"

namespace macula::segment {

// Adds to the mask, slice by slice, the regions that it encloses. The edge of the field of view may be up to
// a third of a region's border, as where it cuts through a hollow organ; with more, the region is the room.
Result<void> fillEnclosed(const Grid& grid, const Mask& outside, Mask& mask, const CancelToken& token);

}  // namespace macula::segment
