// The drawing with which a window would show a measured study.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "evaluate/bench_study.h"
#include "pipeline/trace/environment.h"
#include "scene/drawing/drawing.h"

namespace macula::evaluate {

// Fails with usage for lights that are not built in: a window has no others.
Result<std::shared_ptr<const trace::LightRig>> builtInLights(const std::string& name);

// A complete drawing with default settings. Fails likewise.
Result<scene::Drawing> drawingOf(const BenchStudy& study);

}  // namespace macula::evaluate
