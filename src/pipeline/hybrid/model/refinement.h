// A model that goes on learning: from more views, with room for more splats, and nothing of what it knows
// given up.
#pragma once

#include <cstdint>

#include "base/frames.h"
#include "base/progress.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/view_cache.h"
#include "pipeline/splat/train/trainer.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct RefinementOptions {
    std::size_t views = 64;
    std::uint32_t samplesPerPixel = 4;  // few will do: views light each other (training_set.h)
    int sizePx = kTrainingSizePx;
    int bounces = trace::kDefaultBounces;
    std::uint64_t iterations = 2000;  // to follow: over them learning rates fall and splats become more
    std::uint32_t capacity = 50000;   // splats; the model keeps those it has if they are more
    // How many times larger the steps are at first than where the training before ended, so that there is use
    // made of the new room; never larger than that training began with. They fall back to where it ended.
    // With larger ones the model loses before it gains (docs/peripheral-model.md).
    double warmer = 7.0;
    const ViewCache* kept = nullptr;  // see ViewTracing
    int shDegree = 1;                 // more views can tell colours by direction; never less than it has
};

struct MoreViews {
    double seconds = 0.0;      // by the clock: choosing, tracing and adding views
    std::size_t givenUp = 0;   // none of the tries showed enough, and the last one was taken
    std::size_t fromKept = 0;  // views from `kept`, which took no time
};

// Traces the views (pose_sampling.h: extension) and gives them to `trainer`, which drops its stand-in views
// (ViewKind) once it has pictures from enough sides. Its next `options.iterations` steps are then as
// refinementTraining has them. `tracer` and `seenMm` as for makeFirstModel, whose model this goes on with.
// Call it once: a second time would trace the same views. `cancelled` when `progress` says so. After
// outOfMemory the trainer goes on, as before or with some of the views.
Result<MoreViews> beginRefinement(splat::Trainer& trainer, trace::PathTracer& tracer, const Box& seenMm,
                                  const RefinementOptions& options, Progress& progress);

// How a model goes on that `before` has trained up to `now`.
splat::TrainerOptions refinementTraining(splat::TrainerOptions before, const splat::TrainingReport& now,
                                         const RefinementOptions& options);

}  // namespace macula::hybrid
