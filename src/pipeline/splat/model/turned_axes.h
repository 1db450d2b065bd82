// Converts a model to other axes.
#pragma once

#include <glm/glm.hpp>

#include "pipeline/splat/model/splats.h"

namespace macula::splat {

// Turns the splats about their origin, or mirrors them: `newFromOld` is orthogonal. Positions, shapes and
// colours by direction turn together, so that the model looks the same to an eye that turns with it. originMm
// and `axes` stay.
void turnAxes(Splats& splats, const glm::dmat3& newFromOld);

}  // namespace macula::splat
