// The bounding box of visible matter.
#pragma once

#include "base/volume.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/medium.h"

namespace macula {

// The smallest box along the patient's axes, LPS mm, that contains every brick in which `medium` has matter:
// wider than the matter itself by less than a brick on each side, and never beyond the volume. Empty, low >
// high, without matter. `medium` must be made from this volume and grid, by a function or a projection. If
// removed matter casts shadow, its bricks are in the box, too.
Box visibleBoxMm(const Volume& volume, const BrickGrid& grid, const Medium& medium);

}  // namespace macula
