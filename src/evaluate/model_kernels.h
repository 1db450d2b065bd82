// Kernels of first models, compiled before any model's time is taken.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "live/device/scene_on_device.h"

namespace macula::evaluate {

// Makes a small model and forgets it: else the first model's time would be that of compilers. Fails as
// hybrid::makeFirstModel. The tracer is left with other settings and another view.
Result<void> compileModelKernels(const BenchStudy& study, live::SceneOnDevice& scene, int bounces,
                                 Progress& progress);

}  // namespace macula::evaluate
