// How fast a step of training is, stage by stage, beside the C++ reference of the same stage in double, in
// the same run: a ratio means something on every machine, milliseconds only on one.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/measurement.h"
#include "pipeline/gpu/device.h"
#include "pipeline/splat/train/trainer_options.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::evaluate {

struct TrainingBenchmarkOptions {
    splat::TrainerOptions trainer;  // pictures in full size, no density control, no copies: these are set
    int repetitions = 5;            // device and reference take turns, so that a busy neighbour hits both
};

// Median times of a stage over the turns, each until the device has finished it.
struct StageBenchmark {
    Spent device;
    std::optional<Spent> reference;  // of what the reference has as a stage of its own
    Ratio ratio;                     // device over reference
};

struct TrainingBenchmark {
    std::uint64_t pairs = 0;  // of splats and tiles in the picture
    StageBenchmark project;
    StageBenchmark lists;        // of tiles, until they are on the device; the reference has none
    StageBenchmark deviceLists;  // the same when the device makes them: on a CPU device the host does
    // Of the reference what splat::rasterize takes, less what splat::projectSplats does: its sorting is in
    // it, and it has no tiles.
    StageBenchmark raster;
    StageBenchmark loss;      // and its derivative by the picture
    StageBenchmark backward;  // to the parameters; of the reference less splat::projectSplats, as above
    StageBenchmark adam;
    // splat::Trainer::step, which also waits for each step; of the reference the sum of the above.
    StageBenchmark step;
};

// Of a model, and one view of it with its picture. The first turn, which compiles kernels, is not timed.
// Fails as splat::Rasterizer, splat::Loss and splat::Trainer do, and with `cancelled`; usage for a model
// without splats.
Result<TrainingBenchmark> benchmarkTraining(const std::shared_ptr<gpu::Device>& device,
                                            const splat::Splats& model, const splat::TrainingView& view,
                                            const TrainingBenchmarkOptions& options, Progress& progress);

}  // namespace macula::evaluate
