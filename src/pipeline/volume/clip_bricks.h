// Which bricks a clip or a mask empties, and which contain grey faces of a clip.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/mask_bits.h"

namespace macula {

// Sets to 0 the majorants of bricks that a clip without shadow removes entirely. Uses all cores.
void emptyRemovedBricks(const Clip& clip, const Volume& volume, const BrickGrid& grid,
                        std::span<float> bounds);

// The same for bricks in which the mask hides every voxel that interpolation can reach. Uses all cores.
void emptyMaskedBricks(const MaskBits& mask, const BrickGrid& grid, std::span<float> bounds);

// By brick: 1 if a grey face of the clip may pass through it, whatever is visible there; empty if the clip
// has none. Uses all cores.
std::vector<std::uint8_t> bricksAtGreyFaces(const Clip& clip, const Volume& volume, const BrickGrid& grid);

}  // namespace macula
