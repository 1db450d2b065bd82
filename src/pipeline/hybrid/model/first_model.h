// From a volume to its first peripheral model: points on visible matter, views, and training.
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
    // many: a model does not know sides that it has not seen (docs/peripheral-model.md).
    std::size_t views = 48;
    std::uint32_t samplesPerPixel = 2;  // few suffice: views light each other (training_set.h)
    // All directions of view that the model learns from. If fewer views are traced, the rest are only lit by
    // the light that these found: that costs little, and without it a model of few sides looks wrong from all
    // others. Of matter that scatters anisotropically (|g| above 0.1) the model learns only the coverage in
    // these directions.
    std::size_t directions = 48;
    int sizePx = kTrainingSizePx;
    int bounces = trace::kDefaultBounces;
    std::uint64_t trial = 0;  // selects the random views, their noise, and their order in training
    std::uint64_t iterations = 700;
    bool beginsOnly = false;  // makes at most one of these steps; the caller makes the rest
    // The time for points, views and training together. Points are not cut short. Of the time left then, four
    // tenths are for tracing views (at least one), a tenth is for lighting untraced views, and the rest is
    // for training (at least one step).
    const TimeBudget* budget = nullptr;  // null: unlimited
    std::uint32_t capacity = 11000;      // splats, at least as many as points
    const ViewCache* kept = nullptr;     // see ViewTracing
    int shDegree = 1;  // of colours: 1 gains 0.3 to 0.6 dB, for 9 more bytes per splat in SPZ
};

struct FirstModel {
    splat::Trainer trainer;  // can continue, and take more views
    // Times by the clock of the budget, with the compiling of kernels.
    double pointsSeconds = 0.0;
    double viewsSeconds = 0.0;      // choosing and tracing them
    ViewTimes viewTimes;            // what viewsSeconds is made of
    double trainSeconds = 0.0;      // includes making the trainer and giving it its pictures
    std::size_t viewsTraced = 0;    // fewer than wanted if the budget was short
    std::size_t viewsGivenUp = 0;   // no try showed enough, and the last one was used
    std::size_t viewsFromKept = 0;  // taken from `kept`, which takes no time
};

// `tracer` must have its volume, transfer function, environment and clip, and is left with other settings and
// another view; `seenMm` contains all that can be seen (TracedScene). Fails with inputNotUsable if nothing
// can be seen, and with `cancelled` if `progress` is cancelled. Lights must be fixed to the patient: a model
// cannot represent those that follow the camera.
Result<FirstModel> makeFirstModel(const std::shared_ptr<gpu::Device>& device, trace::PathTracer& tracer,
                                  const Box& seenMm, const FirstModelOptions& options, Progress& progress);

// The training options of such models.
splat::TrainerOptions trainerOptions(const FirstModelOptions& options);

}  // namespace macula::hybrid
