// Lungs, bowel gas, everything else that lies within the patient without being solid.
#pragma once

#include "base/result.h"
#include "segment/coarse_grid.h"

namespace macula::segment {

// Adds to the mask, slice by slice, what it encloses. The edge of the field of view counts as a wall where it
// cuts through a hollow organ, and as open where it bounds the room.
Result<void> fillEnclosed(const Grid& grid, const Mask& outside, Mask& mask, const CancelToken& token);

}  // namespace macula::segment
