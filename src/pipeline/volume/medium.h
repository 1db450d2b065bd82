// A volume under a transfer function, as tables the tracer reads: what light meets at each stored value, and
// a bound on it for every brick.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/volume.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/entry_map.h"
#include "pipeline/volume/mask_bits.h"
#include "pipeline/volume/transfer_function.h"
#include "pipeline/volume/volume_fit.h"

namespace macula {

struct Medium {
    std::vector<float> extinctionPerMm;  // by entry
    std::vector<glm::vec4> albedo;       // by entry; linear RGB, w unused
    glm::ivec3 gridSize{0};
    // By brick, see shaders/lib/brick_walk.glsl: a bound above the extinction anywhere in the brick, rounded
    // up; or, in an empty brick, minus the Chebyshev distance in bricks to the nearest that is not, at most
    // 255.
    std::vector<float> bounds;
    float anisotropy = 0.0f;

    std::size_t visibleBricks() const;
};

// `function` is used as it is: fit it to the volume before (fitted). It must be valid (validate). Bricks of
// which a clip without shadow leaves nothing are empty. On all cores.
Medium makeMedium(const Volume& volume, const BrickGrid& grid, const TransferFunction& function,
                  const Clip& clip = {}, const MaskBits* mask = nullptr);

// Makes the bounds of visible bricks true also where blocks are stored coarsely, by level (voxel_blocks.h):
// the average of a few voxels across a brick's face may lie outside of what the brick itself holds. Empty
// bricks stay empty.
void coverCoarseBlocks(Medium& medium, const BrickGrid& grid, std::span<const std::uint8_t> levels);

}  // namespace macula
