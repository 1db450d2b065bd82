// The pictures that the path tracer makes for a peripheral model.
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

// All functions need a tracer with its volume, transfer function, environment and clip, and wait for the
// device. Those with `progress` leave the tracer with other settings and another view, and fail with
// `cancelled` if that is cancelled.

struct ViewTracing {
    glm::ivec2 sizePx{kTrainingSizePx};
    std::uint32_t samplesPerPixel = 8;
    // Each view has the next seed: otherwise the model would learn the same noise from all views.
    trace::Settings settings = {.denoising = trace::Denoising::little};
    // Views are looked up here before they are traced, and kept here afterwards: one by one, so that a
    // cancelled run can continue, or as a set of views that light each other (training_set.h). It must belong
    // to the tracer's scene. Null: nothing is kept.
    const ViewCache* kept = nullptr;
    // Asked before each view: when it says no, this and all later ones are left out, except the first. Views
    // are then traced in an order in which the first few are spread over all. Empty: traces all, in their
    // order.
    std::function<bool()> hasTimeToTrace = {};
    // Likewise for the views that are lit afterwards without being traced: training_set.h.
    std::function<bool()> hasTimeToLight = {};
    // Receives the light that the samples find; `kept` is not used then. Null: the light is not collected.
    LightInSpace* light = nullptr;
};

struct TracedViews {
    std::vector<TracedView> views;  // by camera
    std::vector<Camera> leftOut;    // cameras for which there was no time
    std::size_t fromKept = 0;       // number of `views` that `kept` had
    ViewTimes times;
};

// One view as it is traced, for comparisons. Makes a step of `progress` for each sample.
Result<TracedView> traceView(trace::PathTracer& tracer, const trace::View& view,
                             const trace::Settings& settings, std::uint32_t samplesPerPixel,
                             Progress& progress);

// What the tracer has traced so far of its view, which must have this camera and no foveation: for
// PeripheralModel::offer. Coverage comes from the guides, because a model would learn noise in it as shape.
// Light is denoised as the tracer's settings say; Denoising::little is best for learning. Pixels without
// samples are NaN: unknown.
Result<TracedView> readToLearnFrom(trace::PathTracer& tracer, const Camera& camera);

// Traces training views, with as many samples in each pixel, and without reusing samples of a similar earlier
// view. Coverage as in readToLearnFrom. Adds a stage to `progress`, with a step for each sample of a view.
Result<TracedViews> traceViews(trace::PathTracer& tracer, std::span<const Camera> cameras,
                               const ViewTracing& options, Progress& progress);

// When a view shows enough, from far enough away.
struct PoseLimits {
    double leastCoverage = 0.04;  // mean over the picture; 0.06 for ground truth
    // At most mostNear of the picture may be nearer than nearRadii half-diagonals of the box of visible
    // matter. The paper's distance is in its own units, and roughly this in its scenes.
    double mostNear = 0.2;
    double nearRadii = 0.1;
    int sizePx = 64;  // of the test picture, which has only guides, so no noise
};

// The test of a pose for samplePoses. `tracer` and `progress` must outlive it.
PoseAcceptance showsEnough(trace::PathTracer& tracer, double radiusMm, const PoseLimits& limits,
                           const Progress& progress);

// Views of coverage only, without light: the tracer's guides find them without noise, at a fraction of the
// cost of tracing. They teach a model its shape from many more sides than it has pictures of. One for each
// camera: black, with the coverage of each pixel, and no samples. Asks `hasTime`
// (may be empty) before each view, and leaves out the rest when it says no.
Result<std::vector<TracedView>> coverageViews(trace::PathTracer& tracer, std::span<const Camera> cameras,
                                              const glm::ivec2& sizePx, Progress& progress,
                                              const std::function<bool()>& hasTime = {});

}  // namespace macula::hybrid
