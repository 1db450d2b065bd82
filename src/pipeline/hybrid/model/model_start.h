// What a peripheral model begins with: points on what can be seen, or an older model of something like it.
#pragma once

#include <string>

#include "base/frames.h"
#include "base/progress.h"
#include "base/result.h"
#include "pipeline/splat/model/splats.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct ModelStart {
    splat::Splats splats;   // valid; may be none
    Box seenMm;             // box of visible matter (TracedScene)
    bool isTaught = false;  // the splats are those of an older model, not of points
    std::string key;        // of volume, preset, clip and lights; the caller's
};

// A splat for each of the points that `tracer` finds (surface_points.h). The tracer has its volume, transfer
// function, environment and clip, and is left with another view. inputNotUsable when nothing can be seen;
// `cancelled` when `progress` says so.
Result<ModelStart> startFromPoints(trace::PathTracer& tracer, const Box& seenMm, const std::string& key,
                                   const trace::SurfacePointOptions& options, Progress& progress);

// The same model relative to another origin.
splat::Splats relativeTo(splat::Splats splats, const glm::dvec3& originMm);

}  // namespace macula::hybrid
