// How fast a step of training is, stage by stage, compared with the C++ reference of the same stage in
// double, in the same run: ratios are comparable between machines, milliseconds are not.
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
    splat::TrainerOptions trainer;  // but full-size pictures, no density control and no kept copies
    int repetitions = 5;            // device and reference alternate, so that other load affects both
};

// Median times of a stage over the turns, until the device has finished it.
struct StageBenchmark {
    Spent device;
    std::optional<Spent> reference;  // nothing if the reference has no such stage
    Ratio ratio;                     // device over reference
};

struct TrainingBenchmark {
    std::uint64_t pairs = 0;  // pairs of splat and tile in the picture
    StageBenchmark project;
    StageBenchmark lists;        // of tiles, until they are on the device; not in the reference
    StageBenchmark deviceLists;  // the same, made by the device; the usual maker on a CPU is the host
    // For the reference the time of splat::rasterize minus that of splat::projectSplats: it contains sorting,
    // and uses no tiles.
    StageBenchmark raster;
    StageBenchmark loss;      // with its derivative by the picture
    StageBenchmark backward;  // to the parameters; for the reference without splat::projectSplats
    StageBenchmark adam;
    // splat::Trainer::step, which also waits for each step; for the reference the sum of the above.
    StageBenchmark step;
};

// Measures with a model, and one view with its picture. Does not time the first turn, which compiles kernels.
// Fails as splat::Rasterizer, splat::Loss and splat::Trainer do, with `cancelled`, and with usage for a model
// without splats.
Result<TrainingBenchmark> benchmarkTraining(const std::shared_ptr<gpu::Device>& device,
                                            const splat::Splats& model, const splat::TrainingView& view,
                                            const TrainingBenchmarkOptions& options, Progress& progress);

}  // namespace macula::evaluate
