// From a volume to its first peripheral model: points on what can be seen, views of it, and training.
#pragma once

#include <cstdint>
#include <memory>

#include "base/frames.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/time_budget.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/hybrid/views/view_cache.h"
#include "pipeline/hybrid/views/view_times.h"
#include "pipeline/splat/train/trainer.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

struct FirstModelOptions {
    trace::SurfacePointOptions points;
    // For the same number of light paths, many views with few samples each teach more than few views with
    // many: what a model has not seen from somewhere it does not know. docs/peripheral-model.md.
    std::size_t views = 48;
    std::uint32_t samplesPerPixel = 2;  // few will do: views light each other (training_set.h)
    // Directions of view in all that the model learns from. Where fewer views are traced, the rest are only
    // lit with what was found for these: that costs little, and without it what was seen from few sides is in
    // the wrong place, and in the wrong light, for all others. Where matter scatters more to one side than to
    // another (|g| above 0.1) only their coverage is told.
    std::size_t directions = 48;
    int sizePx = kTrainingSizePx;
    int bounces = trace::kDefaultBounces;
    std::uint64_t trial = 0;  // another draw of the views, their noise, and their order in training
    std::uint64_t iterations = 700;
    bool beginsOnly = false;  // makes at most one of these steps; the caller goes on
    // The time for points, views and training together. Points are not cut short; of what is left then, four
    // tenths are for tracing views, one at least, a tenth is for lighting what was not traced, and the rest
    // for training, one step at least.
    const TimeBudget* budget = nullptr;  // null: without end
    std::uint32_t capacity = 11000;      // splats, at least as many as points
    const ViewCache* kept = nullptr;     // see ViewTracing
    int shDegree = 1;  // of colours: degree 1 is worth 0.3 to 0.6 dB, for 9 bytes more a splat in SPZ
};

struct FirstModel {
    splat::Trainer trainer;  // can go on, and take more views
    // Times by the clock of the budget, kernels compiled on the way included.
    double pointsSeconds = 0.0;
    double viewsSeconds = 0.0;      // choosing and tracing them
    ViewTimes viewTimes;            // where these went
    double trainSeconds = 0.0;      // making the trainer and giving it its pictures included
    std::size_t viewsTraced = 0;    // fewer than wanted where the budget was short
    std::size_t viewsGivenUp = 0;   // none of the tries showed enough, and the last one was taken
    std::size_t viewsFromKept = 0;  // taken from `kept`, which takes no time
};

// `tracer` has its volume, transfer function, environment and clip, and is left with other settings and
// another view; `seenMm` is the box of what can be seen (TracedScene). Fails with inputNotUsable when nothing
// can be, and with `cancelled` when `progress` says so. Lights must be the patient's: of those that hang on
// the camera a model knows nothing.
Result<FirstModel> makeFirstModel(const std::shared_ptr<gpu::Device>& device, trace::PathTracer& tracer,
                                  const Box& seenMm, const FirstModelOptions& options, Progress& progress);

// How such models are trained.
splat::TrainerOptions trainerOptions(const FirstModelOptions& options);

}  // namespace macula::hybrid
