// Trains a model, from its points or a saved training, until the user stops it or it ends, and keeps the
// result.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "base/time_budget.h"
#include "live/device/scene_on_device.h"
#include "pipeline/gpu/recovery.h"
#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::live {

// When to stop: whichever comes first.
struct TrainingEnd {
    std::uint64_t steps = 0;  // steps from here on
    TimeBudget budget;        // for everything, points and views included
};

// The result, on the host: losing the device loses none of it.
struct Trained {
    // Why the remaining steps failed; `state` is then the last good one.
    std::optional<Error> failure;
    std::string device;
    std::uint64_t firstStep = 0;  // 0, or the step at which it resumed
    splat::TrainingState state;
    splat::TrainingReport report;
    bool interrupted = false;    // by the user, before the last step
    double pointsSeconds = 0.0;  // includes uploading the volume
    double viewsSeconds = 0.0;
    hybrid::ViewTimes viewTimes;  // the parts of viewsSeconds
    double trainSeconds = 0.0;
    std::size_t viewsTraced = 0;
    std::size_t viewsGivenUp = 0;
};

// Makes points and views, and trains, with a plan of options.iterations steps. Cancelling before the first
// step gives the error `cancelled`; later it gives the model trained so far. Fails as makeFirstModel; a
// failure in a later step is in Trained::failure.
Result<Trained> trainFirst(const std::shared_ptr<gpu::Device>& device, const StudyScene& scene,
                           const hybrid::FirstModelOptions& options, const TrainingEnd& end,
                           Progress& progress);

// Resumes the training `saved`, with the result that trainFirst would have had without stopping. Fails as
// Trainer::resume.
Result<Trained> trainOn(const std::shared_ptr<gpu::Device>& device, const splat::TrainingState& saved,
                        const TrainingEnd& end, Progress& progress);

// Resumes a training that failed, with the result that it would have had without the failure. Fails as
// Trainer::resume, and then leaves `failed` unchanged.
Result<void> trainToTheEnd(const std::shared_ptr<gpu::Device>& device, Trained& failed,
                           const TrainingEnd& end, Progress& progress);

// Runs trainFirst, or trainOn for a saved training, and trainToTheEnd after each device loss.
struct LastingTraining {
    std::optional<Trained> trained;  // nothing if it did not begin
    Result<void> ended;              // the error that ended it, if any
};
LastingTraining trainLasting(gpu::LastingDevice& device, const StudyScene& scene,
                             const hybrid::FirstModelOptions& options,
                             const std::optional<splat::TrainingState>& saved, const TrainingEnd& end,
                             Progress& progress);

// Reads a saved training to resume. Fails as splat::readTraining; with inputNotUsable without a view to learn
// from; with usage if none of its planned steps are left and `toItsEnd` asks for only those.
Result<splat::TrainingState> readTrainingToGoOn(const std::filesystem::path& path, bool toItsEnd);

// The number of steps after which the learning rates reach their final values.
std::uint64_t plannedSteps(const splat::TrainingState& state);
// The number of planned steps that are left.
std::uint64_t stepsLeft(const splat::TrainingState& state);

}  // namespace macula::live
