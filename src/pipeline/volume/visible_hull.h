// The outline of the visible matter of a volume, for any direction of view.
#pragma once

#include <vector>

#include "base/volume.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/mask_bits.h"
#include "pipeline/volume/medium.h"

namespace macula {

// Points, LPS mm, whose convex hull is that of the visible matter, to a small part of a voxel. In each row of
// the grid they mark the outer ends of the first and the last run of matter that hides a tenth of what is
// behind it; a second volume counts as well. Matter that a clip removes does not count, but everything that
// its grey faces could show does. Empty without matter. `medium` must be made from this volume and grid by a
// function, with this clip, mask and additions. Uses all cores.
std::vector<glm::dvec3> visibleHullMm(const Volume& volume, const BrickGrid& grid, const Medium& medium,
                                      const Clip& clip = {}, const MaskBits* mask = nullptr,
                                      const Additions& additions = {});

}  // namespace macula
