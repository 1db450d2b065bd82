// Makes a set of training views together: some are traced, and the light that these find goes into a radiance
// cache (light_in_space.h), which lights all of them, and views from other sides that are not traced.
//
// A picture of few samples is noisy, and a denoiser blurs. But each of many pictures has found light for
// matter that the others show: so each picture is marched again, lit by the light of all (lit_view.h), and
// combined with its traced version (combined_view.h). docs/peripheral-model.md says how much that gains.
#pragma once

#include <cstddef>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/view_times.h"
#include "pipeline/hybrid/views/view_tracing.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct TrainingSet {
    std::vector<Camera> traced;
    std::vector<Camera> sides;  // views that are not traced
};

struct TrainingPictures {
    std::vector<TracedView> traced;  // by camera, as far as time allowed
    std::vector<TracedView> sides;   // likewise
    // False for matter that scatters more forwards than back (|g| above 0.1), because the light of one view
    // is wrong for another: then `traced` stays as traced, and `sides` have only coverage.
    bool areLit = false;
    std::size_t fromKept = 0;  // pictures from ViewTracing::kept; if areLit, all or none
    ViewTimes times;
};

// `tracing` says how views are traced; its `light` is ignored. Views that were not traced for lack of time
// are lit by the light of the traced ones, like sides and before these, until the time for lighting is spent.
// `seenMm` is the box of visible matter (TracedScene). `tracer` and `progress` are as for traceViews.
Result<TrainingPictures> makePictures(trace::PathTracer& tracer, const Box& seenMm, const TrainingSet& set,
                                      const ViewTracing& tracing, Progress& progress);

}  // namespace macula::hybrid
