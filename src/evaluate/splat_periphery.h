// The splats of a model around a fovea.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/splat/draw/model_painter.h"

namespace macula::evaluate {

// Draws the splats as each eye sees them, but for the eye `shownTo` as `now` sees them. Where those two
// differ it tells no depths, because the depths of `now` say nothing there. `painter`, whose model has the
// origin `originMm`, must outlive it.
hybrid::Periphery peripheryFor(splat::ModelPainter& painter, const glm::dvec3& originMm,
                               const Camera& shownTo, const Camera& now);

}  // namespace macula::evaluate
