// What a peripheral model begins with: points on visible matter, or an older model of a similar scene.
#pragma once

#include <string>

#include "base/frames.h"
#include "base/progress.h"
#include "base/result.h"
#include "pipeline/splat/model/splats.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct ModelStart {
    splat::Splats splats;   // valid; may be empty
    Box seenMm;             // box of visible matter (TracedScene)
    bool isTaught = false;  // the splats are those of an older model, not of points
    std::string key;        // names volume, preset, clip and lights; chosen by the caller
};

// Makes a splat for each of the points that `tracer` finds (surface_points.h). The tracer must have its
// volume, transfer function, environment and clip, and is left with another view. Fails with inputNotUsable
// if nothing can be seen, and with `cancelled` if `progress` is cancelled.
Result<ModelStart> startFromPoints(trace::PathTracer& tracer, const Box& seenMm, const std::string& key,
                                   const trace::SurfacePointOptions& options, Progress& progress);

// The same model relative to another origin.
splat::Splats relativeTo(splat::Splats splats, const glm::dvec3& originMm);

}  // namespace macula::hybrid
