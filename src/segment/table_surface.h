// Finds the surface that the patient lies on: a thin sheet that stays in place along the couch. It is
// detected where the body does not cover it, and interpolated under the body where that lies against it.
#pragma once

#include "segment/coarse_grid.h"

namespace macula::segment {

struct TableSurface {
    Mask beyond;             // the sheet, and all blocks on its side away from the body
    int slices = 0;          // slices in which a sheet was seen
    int touchingSlices = 0;  // slices in which it was continued under a body that lies against it
    bool found() const { return slices > 0; }
};

// `solid`: blocks that may be sheet or body, covers of mattresses included. `body`: blocks that are certainly
// the patient's. `toThickMm`: distance of each block to anything thick; a sheet is thin.
TableSurface findTableSurface(const Grid& grid, const Mask& solid, const Mask& body,
                              const std::vector<float>& toThickMm, const CancelToken& token);

}  // namespace macula::segment
