// The splats of a model around a fovea.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/splat/draw/model_painter.h"

namespace macula::evaluate {

// Draws the splats as each eye sees them, except for the eye `shownTo`, which gets the picture of `now`. If
// these two differ, the result has no depths, because those of `now` would be wrong for `shownTo`. `painter`,
// whose model has the origin `originMm`, must outlive the result.
hybrid::Periphery peripheryFor(splat::ModelPainter& painter, const glm::dvec3& originMm,
                               const Camera& shownTo, const Camera& now);

}  // namespace macula::evaluate
