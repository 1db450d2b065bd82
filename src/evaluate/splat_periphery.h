// The splats of a model around a fovea.
#pragma once

#include <glm/glm.hpp>

#include "base/camera.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/splat/draw/model_painter.h"

namespace macula::evaluate {

// Draws the splats for every eye as that sees them; but for `shownTo` as `now` sees them, also where these
// are not the same: then it tells no depths, because those of `now` say nothing there. `painter`, whose model
// has the origin `originMm`, must outlive it.
hybrid::Periphery peripheryFor(splat::ModelPainter& painter, const glm::dvec3& originMm,
                               const Camera& shownTo, const Camera& now);

}  // namespace macula::evaluate
