// What a window would draw of a study that is measured.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "evaluate/bench_study.h"
#include "pipeline/trace/environment.h"
#include "scene/drawing/drawing.h"

namespace macula::evaluate {

// usage for lights that are not built in: a window has no others.
Result<std::shared_ptr<const trace::LightRig>> builtInLights(const std::string& name);

// Complete, with settings that nobody chose. Fails likewise.
Result<scene::Drawing> drawingOf(const BenchStudy& study);

}  // namespace macula::evaluate
