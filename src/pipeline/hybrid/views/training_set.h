// The pictures that a model learns from at once: some are traced, and the light that these find goes into a
// radiance cache (light_in_space.h), which lights all of them and sides that are not traced as well.
//
// A picture of few samples is noisy, and a filter that takes the noise out blurs. But each of many pictures
// has found light for what the others show: so a picture is marched anew, with what all have found
// (lit_view.h), and combined with what it was traced to be (combined_view.h). What that is worth:
// docs/peripheral-model.md.
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
    std::vector<Camera> sides;  // no path of light is traced for them
};

struct TrainingPictures {
    std::vector<TracedView> traced;  // by camera, those for which there was time
    std::vector<TracedView> sides;   // likewise
    // What leaves matter towards one side is not what leaves it towards another, where matter scatters more
    // forwards than back (|g| above 0.1): then `traced` is as it was traced, and of `sides` only coverage is
    // known.
    bool areLit = false;
    std::size_t fromKept = 0;  // pictures from ViewTracing::kept; lit ones all or none
    ViewTimes times;
};

// `tracing` says how views are traced; its `light` is ignored. Views that the time budget left untraced are
// lit from the light of the traced ones, as sides are and before these, until the budget for lighting is
// spent. `seenMm` is the box of visible matter (TracedScene).
// For `tracer` and `progress`, what traceViews says.
Result<TrainingPictures> makePictures(trace::PathTracer& tracer, const Box& seenMm, const TrainingSet& set,
                                      const ViewTracing& tracing, Progress& progress);

}  // namespace macula::hybrid
