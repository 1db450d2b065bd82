// A model in other axes.
#pragma once

#include <glm/glm.hpp>

#include "pipeline/splat/model/splats.h"

namespace macula::splat {

// Turns the splats about their origin, or mirrors them: `newFromOld` is orthogonal. Positions, shapes and
// colours by direction go with it, so that the model looks as it did to an eye that went along. originMm and
// `axes` stay.
void turnAxes(Splats& splats, const glm::dmat3& newFromOld);

}  // namespace macula::splat
