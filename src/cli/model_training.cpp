#include "cli/model_training.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace macula::cli {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// trained.trainSeconds have gone by.
Result<void> runSteps(splat::Trainer& trainer, const TrainingEnd& end, Progress& progress, Trained& trained) {
    const auto start = Clock::now();
    const double before = trained.trainSeconds;
    const std::uint64_t first = trainer.report().steps;
    const auto mayGoOn = [&] {
        return !progress.cancelled() &&
               (end.budgetSeconds <= 0.0 || before + secondsSince(start) < end.budgetSeconds);
    };
    if (end.steps > 0 && mayGoOn()) {
        MACULA_TRY_VOID(trainer.step(end.steps, [&] {
            progress.advance();
            return mayGoOn();
        }));
    }
    trained.report = trainer.report();
    trained.interrupted = progress.cancelled() && trained.report.steps < first + end.steps;
    MACULA_TRY(trained.state, trainer.state());
    trained.trainSeconds = before + secondsSince(start);
    return {};
}

Error stopped() {
    return {ErrorCode::cancelled, "Stopped before the first step; nothing was written.", {}, {}};
}

}  // namespace

Result<Trained> trainFirst(const std::shared_ptr<gpu::Device>& device, const EvaluatedScene& scene,
                           const hybrid::FirstModelOptions& options, const TrainingEnd& end,
                           Progress& progress) {
    MACULA_TRY(SceneOnDevice onDevice, putOnDevice(device, scene));
    // One step, or none, is made there; the others here, where they can be stopped with nothing lost.
    hybrid::FirstModelOptions begin = options;
    begin.budgetMs = 0.0;
    auto made = hybrid::makeFirstModel(device, onDevice.tracer, onDevice.traced.seenMm(), begin, progress);
    if (!made) return made.error().code == ErrorCode::cancelled ? stopped() : made.error();
    Trained trained{.device = gpu::describe(device->info()),
                    .pointsSeconds = made->pointsSeconds,
                    .viewsSeconds = made->viewsSeconds,
                    .trainSeconds = made->trainSeconds,
                    .viewsGivenUp = made->viewsGivenUp};
    const std::uint64_t done = made->trainer.report().steps;
    MACULA_TRY_VOID(runSteps(
        made->trainer, {.steps = end.steps - std::min(end.steps, done), .budgetSeconds = end.budgetSeconds},
        progress, trained));
    return trained;
}

Result<Trained> trainOn(const std::shared_ptr<gpu::Device>& device, const splat::TrainingState& saved,
                        const TrainingEnd& end, Progress& progress) {
    progress.beginStage("Training", static_cast<std::size_t>(end.steps));
    const auto start = Clock::now();
    MACULA_TRY(splat::Trainer trainer, splat::Trainer::resume(device, saved));
    Trained trained{.device = gpu::describe(device->info())};
    trained.trainSeconds = secondsSince(start);
    if (progress.cancelled()) return stopped();
    MACULA_TRY_VOID(runSteps(trainer, end, progress, trained));
    return trained;
}

std::uint64_t plannedSteps(const splat::TrainingState& state) {
    return state.options.optimizer.positionSteps;
}

}  // namespace macula::cli
