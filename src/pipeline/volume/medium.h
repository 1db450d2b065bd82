// A volume under a transfer function, as tables that the tracer reads: the optics of each stored value, and a
// majorant for every brick.
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
    // The majorant of each brick, rounded up (shaders/lib/brick_walk.glsl). For an empty brick: minus the
    // Chebyshev distance in bricks to the nearest one that is not empty, at most 255.
    std::vector<float> bounds;
    float anisotropy = 0.0f;
    Surface surface = {};  // its gradient in units per mm, from the fitted preset
    Coat coat = {};        // set if `surface` has a weight
    // The gradient opacity, by the length of the gradient of values, in steps of `gradientStep` units per mm
    // from 0; empty if it is 1 everywhere.
    std::vector<float> gradientOpacity;
    double gradientStep = 0.0;
    // As `albedo`, for steep matter; empty if it has no curves of its own. `steepGradientPerMm` is that of
    // the fitted preset.
    std::vector<glm::vec4> steep;
    double steepGradientPerMm = 0.0;
    double unitDepthMm = 1.0;  // unit distance of the preset, divided by its density
    // Values this far apart may have quite different optics: a third of the narrowest piece of the curves.
    double featureUnits = 1.0;
    // By brick: the part of `bounds` that a second volume adds (additions.h); empty without one.
    std::vector<float> addedBounds;
    float ambient = 1.0f;  // from the preset's lighting, as is `diffuse`
    float diffuse = 0.0f;

    // By entry: the extinction per mm of the denser curve, an upper limit for any gradient.
    std::vector<float> mostPerMm() const;
    std::size_t visibleBricks() const;
    // `bounds` of bricks with matter of the volume itself, 0 for others.
    std::vector<float> ownBounds() const;
};

// By entry: linear RGB albedo, and in w the extinction per mm. `function` as below.
std::vector<glm::vec4> opticsByEntry(const Volume& volume, const TransferFunction& function);
// Medium::featureUnits, over all curves.
double featureUnitsOf(const TransferFunction& function, const Volume& volume);

// `function` is used as it is: fit it to the volume before (fitted). It must be valid (validate). Bricks of
// which a clip without shadow leaves nothing are empty. `added` are the bounds of a second volume in the same
// picture (addedBounds in additions.h), or empty. Uses all cores.
Medium makeMedium(const Volume& volume, const BrickGrid& grid, const TransferFunction& function,
                  const Clip& clip = {}, const MaskBits* mask = nullptr, std::span<const float> added = {});

// Raises the majorants of visible bricks whose blocks are stored coarsely, by level (voxel_blocks.h):
// averages of voxels on both sides of a brick's face may lie outside the brick's own range. Empty bricks stay
// empty.
void coverCoarseBlocks(Medium& medium, const BrickGrid& grid, std::span<const std::uint8_t> levels);

enum class Projection { maximum, minimum, mean };

// For rays that gather values instead of light: everything but padding is visible. The bound of a brick says
// how much it can change the result: for a maximum, one more than its largest entry; for a minimum, the
// number of entries minus its smallest; for a mean, the same for all bricks.
Medium makeMedium(const Volume& volume, const BrickGrid& grid, Projection projection, const Clip& clip = {},
                  const MaskBits* mask = nullptr);

}  // namespace macula
