// Pictures from sides that no light was traced for: coverage as the guides find it, and the light that traced
// views have found where their rays meet matter. They cost a small part of what tracing does, and teach a
// model how what it knows looks from many more sides than it has pictures of.
#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/light_in_space.h"
#include "pipeline/hybrid/traced_view.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// One for each camera, with no samples. Where matter is seen that no traced view has come near, pixels are
// NaN: not known. `tracer` is left with another view. `cancelled` when `progress` says so.
Result<std::vector<TracedView>> litViews(trace::PathTracer& tracer, std::span<const Camera> cameras,
                                         const glm::ivec2& sizePx, const LightInSpace& light,
                                         Progress& progress);

}  // namespace macula::hybrid
