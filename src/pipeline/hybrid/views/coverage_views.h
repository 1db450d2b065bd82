// Views of coverage only, without light: the tracer's guides find them without noise, at a fraction of the
// cost of tracing. They teach a model its shape from many more sides than it has pictures of.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// One for each camera: black, with the coverage of each pixel, and no samples. `tracer` is left with another
// view. Fails with `cancelled` if `progress` is cancelled. Asks `hasTime` (may be empty) before each view,
// and leaves out the rest when it says no.
Result<std::vector<TracedView>> coverageViews(trace::PathTracer& tracer, std::span<const Camera> cameras,
                                              const glm::ivec2& sizePx, Progress& progress,
                                              const std::function<bool()>& hasTime = {});

}  // namespace macula::hybrid
