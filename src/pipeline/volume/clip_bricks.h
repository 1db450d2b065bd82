// Which bricks a clip or a mask empties, and which hold grey faces of a clip.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/mask_bits.h"

namespace macula {

// Bounds (by brick) become 0 where a clip without shadow leaves nothing of a brick. On all cores.
void emptyRemovedBricks(const Clip& clip, const Volume& volume, const BrickGrid& grid,
                        std::span<float> bounds);

// The same where the mask hides every voxel that interpolation in a brick can reach. On all cores.
void emptyMaskedBricks(const MaskBits& mask, const BrickGrid& grid, std::span<float> bounds);

// By brick: 1 where a face of the clip that shows values may pass through, whatever is visible there; empty
// when no face shows any. On all cores.
std::vector<std::uint8_t> bricksAtGreyFaces(const Clip& clip, const Volume& volume, const BrickGrid& grid);

}  // namespace macula
