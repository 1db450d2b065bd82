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
#include "pipeline/volume/coat.h"
#include "pipeline/volume/entry_map.h"
#include "pipeline/volume/mask_bits.h"
#include "pipeline/volume/transfer_function.h"
#include "pipeline/volume/volume_fit.h"

namespace macula {

struct Medium {
    std::vector<float> extinctionPerMm;  // by entry
    std::vector<glm::vec4> albedo;       // by entry; linear RGB, and in w its extinction again
    glm::ivec3 gridSize{0};
    // The majorant of each brick, see shaders/lib/brick_walk.glsl: a bound on the extinction anywhere in it,
    // rounded up. Of an empty brick: minus the Chebyshev distance in bricks to the nearest that is not empty,
    // at most 255.
    std::vector<float> bounds;
    float anisotropy = 0.0f;
    Surface surface = {};  // its gradient in units per mm, as the fitted preset has it
    Coat coat = {};        // of a surface that has a weight
    // The gradient opacity, by the length of the gradient of values, in steps of `gradientStep` units per mm
    // from 0; empty when it is 1 everywhere.
    std::vector<float> gradientOpacity;
    double gradientStep = 0.0;
    // As `albedo`, of steep matter; empty when it has no curves of its own. `steepGradientPerMm` is that of
    // the fitted preset.
    std::vector<glm::vec4> steep;
    double steepGradientPerMm = 0.0;
    double unitDepthMm = 1.0;  // of the preset: unit distance divided by density
    // Values this far apart may have quite different optics: a third of the narrowest piece of the curves.
    double featureUnits = 1.0;
    // By brick: the part of `bounds` that is of a second volume (additions.h); empty: there is none.
    std::vector<float> addedBounds;
    float ambient = 1.0f;  // of the preset's lighting
    float diffuse = 0.0f;

    // By entry: the extinction per mm by the denser of the curves, which no gradient can exceed.
    std::vector<float> mostPerMm() const;
    std::size_t visibleBricks() const;
    // The bounds where there is matter of the volume itself, 0 elsewhere.
    std::vector<float> ownBounds() const;
};

// By entry: linear RGB albedo, and in w the extinction per mm. `function` as below.
std::vector<glm::vec4> opticsByEntry(const Volume& volume, const TransferFunction& function);
// See Medium::featureUnits; of all curves.
double featureUnitsOf(const TransferFunction& function, const Volume& volume);

// `function` is used as it is: fit it to the volume before (fitted). It must be valid (validate). Bricks of
// which a clip without shadow leaves nothing are empty. `added` is of a second volume in the same picture
// (addedBounds in additions.h), or empty. On all cores.
Medium makeMedium(const Volume& volume, const BrickGrid& grid, const TransferFunction& function,
                  const Clip& clip = {}, const MaskBits* mask = nullptr, std::span<const float> added = {});

// Makes the bounds of visible bricks true also where blocks are stored coarsely, by level (voxel_blocks.h):
// the average of a few voxels across a brick's face may lie outside of what the brick itself holds. Empty
// bricks stay empty.
void coverCoarseBlocks(Medium& medium, const BrickGrid& grid, std::span<const std::uint8_t> levels);

enum class Projection { maximum, minimum, mean };

// For rays that gather values and not light: everything but padding can be seen. A brick's bound tells how
// much it can change the answer: one more than its largest entry; the number of entries minus its smallest;
// the same for all bricks.
Medium makeMedium(const Volume& volume, const BrickGrid& grid, Projection projection, const Clip& clip = {},
                  const MaskBits* mask = nullptr);

}  // namespace macula
