// Cameras for a model that is drawn without any: far enough that all of it is in the picture.
#pragma once

#include <span>
#include <vector>

#include "base/frames.h"
#include "base/result.h"
#include "pipeline/splat/model/splats.h"
#include "scene/camera/splat_cameras.h"

namespace macula::app {

// What is nearer to the eye is not drawn unless a person says otherwise: 2 mm, or of a model whose unit
// nobody knows 0.2 as 3DGS has it.
double usualNearOf(const splat::Splats& splats);

// For a model in the patient's axes: a camera from each direction, or without any from the front, as `macula
// render` looks at a series. For a model of unknown axes: one along its own +z with -y up, which is where the
// first camera of most reconstructions looks; usage when a direction is given. Such models have stray splats
// far out: of its box the outermost hundredth of the centres at either side is left out. Named by the
// direction, or "along-z"; RasterView::nearMm, in the model's unit, is near enough for a small model. The
// model must be valid.
Result<std::vector<SplatCamera>> framedCameras(const splat::Splats& splats,
                                               std::span<const ViewDirection> from, const glm::ivec2& sizePx);

}  // namespace macula::app
