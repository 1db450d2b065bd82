// The surface that the patient lies on: a thin sheet that stays in its place while the couch moves, seen
// where the body does not cover it, and continued under the body where it lies against it.
#pragma once

#include "segment/coarse_grid.h"

namespace macula::segment {

struct TableSurface {
    Mask beyond;             // the sheet, and all that lies on the other side of it than the body
    int slices = 0;          // in which a sheet was seen
    int touchingSlices = 0;  // in which it was continued under a body that lies against it
    bool found() const { return slices > 0; }
};

// `solid`: anything denser than foam. `body`: what is certainly of the patient. `toBodyMm`: distance of each
// block to anything thick, a sheet being thin.
TableSurface findTableSurface(const Grid& grid, const Mask& solid, const Mask& body,
                              const std::vector<float>& toThickMm, const CancelToken& token);

}  // namespace macula::segment
