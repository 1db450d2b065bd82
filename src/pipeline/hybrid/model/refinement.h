// Continues the training of a model, with more views and room for more splats, without losing what it has
// learnt.
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
    std::uint32_t samplesPerPixel = 4;  // few suffice: views light each other (training_set.h)
    int sizePx = kTrainingSizePx;
    int bounces = trace::kDefaultBounces;
    std::uint64_t iterations = 2000;  // the next steps: rates fall and splats are split
    std::uint32_t capacity = 50000;   // splats; a model that has more keeps them
    // How many times larger learning rates are at first than at the end of the earlier training, so that the
    // new room is used; never larger than those it began with. They fall back to its last ones. With larger
    // rates the model loses before it gains (docs/peripheral-model.md).
    double warmer = 7.0;
    const ViewCache* kept = nullptr;  // see ViewTracing
    int shDegree = 1;                 // more views allow for view-dependent colours; never less than now
};

struct MoreViews {
    double seconds = 0.0;      // wall time: choosing, tracing and adding views
    std::size_t givenUp = 0;   // no try showed enough, and the last one was used
    std::size_t fromKept = 0;  // views from `kept`, which took no time
};

// Traces the views (pose_sampling.h: extension) and gives them to `trainer`, which drops its stand-in views
// (ViewKind) once it has pictures from enough sides. Its next `options.iterations` steps then follow
// refinementTraining. `tracer` and `seenMm` as for makeFirstModel, which made the model. Call this once: a
// second call would trace the same views. Fails with `cancelled` if `progress` is cancelled. After
// outOfMemory the trainer is still usable, as before or with some of the views.
Result<MoreViews> beginRefinement(splat::Trainer& trainer, trace::PathTracer& tracer, const Box& seenMm,
                                  const RefinementOptions& options, Progress& progress);

// The options that continue a training which `before` has brought up to `now`.
splat::TrainerOptions refinementTraining(splat::TrainerOptions before, const splat::TrainingReport& now,
                                         const RefinementOptions& options);

}  // namespace macula::hybrid
