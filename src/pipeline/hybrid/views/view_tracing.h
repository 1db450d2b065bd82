// Pictures that the path tracer makes for the peripheral model.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/light/light_in_space.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/pose_sampling.h"
#include "pipeline/hybrid/views/view_cache.h"
#include "pipeline/hybrid/views/view_times.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// All of these use a tracer that has its volume, transfer function, environment and clip, and wait. Those
// with `progress` leave it with other settings and another view, and give `cancelled` when that says so.

struct ViewTracing {
    glm::ivec2 sizePx{kTrainingSizePx};
    std::uint32_t samplesPerPixel = 8;
    // Each view takes the next seed: the same noise in all views would be learnt as if it were there.
    trace::Settings settings = {.denoising = trace::Denoising::little};
    // Views are looked up here before they are traced, and put here afterwards: one by one, so that who is
    // cancelled goes on where he was, or sets that light each other (training_set.h). It must be of the
    // tracer's scene. Null: nothing is kept.
    const ViewCache* kept = nullptr;
    // Asked before each view: when it says no, that and the rest are left out, but for the first view. Views
    // are then traced in an order in which the first few are spread over all of them. Empty: all, in their
    // order.
    std::function<bool()> hasTimeToTrace = {};
    // Likewise for the views that are lit without being traced, after that: training_set.h.
    std::function<bool()> hasTimeToLight = {};
    // Gets the light that is found on the way; then `kept` is not asked and keeps nothing. Null: nobody wants
    // it.
    LightInSpace* light = nullptr;
};

struct TracedViews {
    std::vector<TracedView> views;  // by camera
    std::vector<Camera> leftOut;    // those for which there was no time
    std::size_t fromKept = 0;       // those of `views` that `kept` had
    ViewTimes times;
};

// One view as it is traced, for comparing with; a step of `progress` for each sample.
Result<TracedView> traceView(trace::PathTracer& tracer, const trace::View& view,
                             const trace::Settings& settings, std::uint32_t samplesPerPixel,
                             Progress& progress);

// What the tracer has traced so far, of its view, which has this camera and no foveation: for
// PeripheralModel::offer, whoever it was traced for. Coverage is what the guides find without chance: noise
// in it would be learnt as shape. Light is denoised as the tracer's settings say, and Denoising::little is
// best to learn from. Pixels without samples are NaN, which says that they are not known.
Result<TracedView> readToLearnFrom(trace::PathTracer& tracer, const Camera& camera);

// Traces views to learn from. One sample after the other for each camera, evenly; nothing is carried over
// from the view before, however near. Coverage as readToLearnFrom. `progress` gets a stage, a step for each
// sample of a view.
Result<TracedViews> traceViews(trace::PathTracer& tracer, std::span<const Camera> cameras,
                               const ViewTracing& options, Progress& progress);

// When a view shows enough, from far enough.
struct PoseLimits {
    double leastCoverage = 0.04;  // mean over the picture; 0.06 for ground truth
    // At most this part of the picture is nearer than so many half-diagonals of what is seen. The paper's
    // distance is in its own units; this is about what it comes to in its scenes.
    double mostNear = 0.2;
    double nearRadii = 0.1;
    int sizePx = 64;  // of the picture that is looked at, which has guides only: no chance decides
};

// The test of a pose for samplePoses. `tracer` and `progress` must outlive it.
PoseAcceptance showsEnough(trace::PathTracer& tracer, double radiusMm, const PoseLimits& limits,
                           const Progress& progress);

}  // namespace macula::hybrid
