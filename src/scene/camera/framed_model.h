// Default cameras for a splat model, far enough away to show all of it.
#pragma once

#include <span>
#include <vector>

#include "base/frames.h"
#include "base/result.h"
#include "pipeline/splat/model/splats.h"
#include "scene/camera/splat_cameras.h"

namespace macula::scene {

// The default near distance, closer than which nothing is drawn: 2 mm, or 0.2 as in 3DGS for a model whose
// axes and unit are unknown.
double usualNearOf(const splat::Splats& splats);

// For a model in the patient's axes: a camera from each direction, or one from the front if there are none.
// For a model of unknown axes: one along its own +z with -y up, as the first camera of most reconstructions
// looks; fails with usage when a direction is given. Stray splats lie far out in such models, so its box
// omits the outermost hundredth of the centres at either side of each axis. The name is the direction, or
// "along-z". RasterView::nearMm is 1 % of the distance, at most usualNearOf. The model must be valid.
Result<std::vector<SplatCamera>> framedCameras(const splat::Splats& splats,
                                               std::span<const ViewDirection> from, const glm::ivec2& sizePx);

}  // namespace macula::scene
