// Compiles the kernels of first models before any model is timed.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "live/device/scene_on_device.h"

namespace macula::evaluate {

// Makes a small model and discards it: otherwise the first model's time would include compilation. Fails as
// hybrid::makeFirstModel does. The tracer is left with other settings and another view.
Result<void> compileModelKernels(const BenchStudy& study, live::SceneOnDevice& scene, int bounces,
                                 Progress& progress);

}  // namespace macula::evaluate
