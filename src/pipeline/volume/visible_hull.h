// The outline of what can be seen of a volume, from any side.
#pragma once

#include <vector>

#include "base/volume.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/mask_bits.h"
#include "pipeline/volume/medium.h"

namespace macula {

// Points, LPS mm, whose convex hull is that of what an eye sees of the matter, to a small part of a voxel:
// where along the rows of the grid the first and the last stretch begins and ends that hides a tenth of what
// is behind it; of both volumes where there are two. What a clip removes is not in it; where its faces show
// grey values, all that these could show is. None where there is nothing. `medium` must be made of this
// volume and grid by a function, with this clip, mask and additions. On all cores.
std::vector<glm::dvec3> visibleHullMm(const Volume& volume, const BrickGrid& grid, const Medium& medium,
                                      const Clip& clip = {}, const MaskBits* mask = nullptr,
                                      const Additions& additions = {});

}  // namespace macula
