// Views of coverage only, without light: found by the tracer's guides, without chance, for a small part of
// what tracing costs. They teach a model its shape from many more sides than it has pictures of.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// One for each camera: black, with the coverage of each pixel, and no samples. `tracer` is left
// with another view. `cancelled` when `progress` says so. `hasTime` (may be empty) is asked before each: when
// it says no, the rest is left out.
Result<std::vector<TracedView>> coverageViews(trace::PathTracer& tracer, std::span<const Camera> cameras,
                                              const glm::ivec2& sizePx, Progress& progress,
                                              const std::function<bool()>& hasTime = {});

}  // namespace macula::hybrid
