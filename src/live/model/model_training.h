// Training of a model, from its points or from where it was saved, that stops when it is asked to and keeps
// what it has.
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

namespace macula::app {

// When to stop; whatever comes first.
struct TrainingEnd {
    std::uint64_t steps = 0;  // that are to follow
    TimeBudget budget;        // of all that is done, points and views as well
};

// What is on the host when the device is done: a lost device takes nothing of it along.
struct Trained {
    // Why steps that were to follow did not; the state is then the last good one.
    std::optional<Error> failure;
    std::string device;
    std::uint64_t firstStep = 0;  // 0, or what it went on from
    splat::TrainingState state;
    splat::TrainingReport report;
    bool interrupted = false;    // by the user, with steps still to come
    double pointsSeconds = 0.0;  // putting the volume on the device included
    double viewsSeconds = 0.0;
    hybrid::ViewTimes viewTimes;  // where these went
    double trainSeconds = 0.0;
    std::size_t viewsTraced = 0;
    std::size_t viewsGivenUp = 0;
};

// Points, views, and training that is planned for options.iterations steps. Cancelled before the first of
// these it is an error, `cancelled`; afterwards the model as it is then. Fails as makeFirstModel; what fails
// in a later step is told by Trained::failure.
Result<Trained> trainFirst(const std::shared_ptr<gpu::Device>& device, const StudyScene& scene,
                           const hybrid::FirstModelOptions& options, const TrainingEnd& end,
                           Progress& progress);

// Resumes the training of `saved`, to what trainFirst had come to if it had not stopped. Fails as
// Trainer::resume.
Result<Trained> trainOn(const std::shared_ptr<gpu::Device>& device, const splat::TrainingState& saved,
                        const TrainingEnd& end, Progress& progress);

// Resumes a training that failed, to the same end as if it had not. Fails as Trainer::resume, and then
// `failed` is what it was.
Result<void> trainToTheEnd(const std::shared_ptr<gpu::Device>& device, Trained& failed,
                           const TrainingEnd& end, Progress& progress);

// Runs trainFirst, or trainOn for a saved training, and trainToTheEnd for each device that is lost on the
// way.
struct LastingTraining {
    std::optional<Trained> trained;  // nothing when it did not begin
    Result<void> ended;              // why it is not whole, unless it was stopped
};
LastingTraining trainLasting(gpu::LastingDevice& device, const StudyScene& scene,
                             const hybrid::FirstModelOptions& options,
                             const std::optional<splat::TrainingState>& saved, const TrainingEnd& end,
                             Progress& progress);

// A training that was saved, to go on with. Fails as splat::readTraining; with inputNotUsable when there is
// nothing to learn from; with usage when no steps are left of its plan, if `toItsEnd` is all that is wanted.
Result<splat::TrainingState> readTrainingToGoOn(const std::filesystem::path& path, bool toItsEnd);

// Steps after which the learning rates of a training have fallen to where they are to stay.
std::uint64_t plannedSteps(const splat::TrainingState& state);
// How many of the planned steps are still to come.
std::uint64_t stepsLeft(const splat::TrainingState& state);

}  // namespace macula::app
