// The splats of a model around a fovea.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/splat/draw/model_painter.h"

namespace macula::evaluate {

// Draws the splats always for the eye `now`, also in a frame that shows its fovea to another eye. To that one
// it tells no depths, because those of `now` say nothing there. `painter`, whose model has the origin
// `originMm`, must outlive it.
hybrid::Periphery peripheryFor(splat::ModelPainter& painter, const glm::dvec3& originMm, const Camera& now);

}  // namespace macula::evaluate
