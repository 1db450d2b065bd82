#include "live/model/model_training.h"

#include <algorithm>
#include <utility>

#include "pipeline/splat/files/training_file.h"

namespace macula::live {

namespace {

void runSteps(splat::Trainer& trainer, const TrainingEnd& end, Progress& progress, Trained& trained) {
    const double start = end.budget.spentSeconds();
    const std::uint64_t last = trained.firstStep + end.steps;
    const std::uint64_t steps = last - std::min(last, trainer.report().steps);
    const auto mayGoOn = [&] { return !progress.cancelled() && !end.budget.isSpent(); };
    const auto run = [&]() -> Result<splat::TrainingState> {
        if (steps > 0 && mayGoOn()) {
            MACULA_TRY_VOID(trainer.step(steps, [&] {
                progress.advance();
                return mayGoOn();
            }));
        }
        return trainer.state();
    };
    Result<splat::TrainingState> state = run();
    trained.failure = state.ok() ? std::nullopt : std::optional(state.error());
    trained.state = state.ok() ? *std::move(state) : trainer.lastGood();
    trained.report = trainer.report();
    trained.report.steps = trained.state.steps;
    trained.report.splats = static_cast<std::uint32_t>(trained.state.splats.size());
    trained.interrupted = progress.cancelled() && trained.state.steps < last;
    trained.trainSeconds += end.budget.spentSeconds() - start;
}

Error stopped() {
    return {ErrorCode::cancelled, Text("Stopped before the first step; nothing was written."), {}, {}};
}

}  // namespace

Result<Trained> trainFirst(const std::shared_ptr<gpu::Device>& device, const StudyScene& scene,
                           const hybrid::FirstModelOptions& options, const TrainingEnd& end,
                           Progress& progress) {
    const double start = end.budget.spentSeconds();
    MACULA_TRY(SceneOnDevice onDevice, putOnDevice(device, scene));
    const double putSeconds = end.budget.spentSeconds() - start;
    // makeFirstModel takes one step at most. The others are taken here, where stopping loses nothing.
    hybrid::FirstModelOptions begin = options;
    begin.beginsOnly = true;
    begin.budget = &end.budget;
    auto made = hybrid::makeFirstModel(device, onDevice.tracer, onDevice.traced.seenMm(), begin, progress);
    if (!made) return made.error().code == ErrorCode::cancelled ? stopped() : made.error();
    Trained trained{.device = gpu::describe(device->info()),
                    .pointsSeconds = putSeconds + made->pointsSeconds,
                    .viewsSeconds = made->viewsSeconds,
                    .viewTimes = made->viewTimes,
                    .trainSeconds = made->trainSeconds,
                    .viewsTraced = made->viewsTraced,
                    .viewsGivenUp = made->viewsGivenUp};
    runSteps(made->trainer, end, progress, trained);
    return trained;
}

Result<Trained> trainOn(const std::shared_ptr<gpu::Device>& device, const splat::TrainingState& saved,
                        const TrainingEnd& end, Progress& progress) {
    progress.beginStage(Text("Training"), static_cast<std::size_t>(end.steps));
    const double start = end.budget.spentSeconds();
    MACULA_TRY(splat::Trainer trainer, splat::Trainer::resume(device, saved));
    Trained trained{.device = gpu::describe(device->info()), .firstStep = saved.steps};
    trained.trainSeconds = end.budget.spentSeconds() - start;
    if (progress.cancelled()) return stopped();
    runSteps(trainer, end, progress, trained);
    return trained;
}

Result<void> trainToTheEnd(const std::shared_ptr<gpu::Device>& device, Trained& failed,
                           const TrainingEnd& end, Progress& progress) {
    const std::uint64_t last = failed.firstStep + end.steps;
    progress.beginStage(Text("Training"),
                        static_cast<std::size_t>(last - std::min(last, failed.state.steps)));
    const double start = end.budget.spentSeconds();
    MACULA_TRY(splat::Trainer trainer, splat::Trainer::resume(device, failed.state));
    failed.device = gpu::describe(device->info());
    failed.trainSeconds += end.budget.spentSeconds() - start;
    runSteps(trainer, end, progress, failed);
    return {};
}

LastingTraining trainLasting(gpu::LastingDevice& device, const StudyScene& scene,
                             const hybrid::FirstModelOptions& options,
                             const std::optional<splat::TrainingState>& saved, const TrainingEnd& end,
                             Progress& progress) {
    LastingTraining lasting;
    std::optional<Trained>& begun = lasting.trained;  // on the host, so it survives the loss of a device
    lasting.ended = device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        if (begun) {
            MACULA_TRY_VOID(trainToTheEnd(on, *begun, end, progress));
        } else if (saved) {
            MACULA_TRY(begun, trainOn(on, *saved, end, progress));
        } else {
            MACULA_TRY(begun, trainFirst(on, scene, options, end, progress));
        }
        return begun->failure ? Result<void>(*begun->failure) : Result<void>();
    });
    return lasting;
}

Result<splat::TrainingState> readTrainingToGoOn(const std::filesystem::path& path, bool toItsEnd) {
    MACULA_TRY(splat::TrainingState state, splat::readTraining(path));
    const auto isPicture = [](const splat::TrainingState::View& view) {
        return view.given->kind == splat::ViewKind::picture;
    };
    if (std::none_of(state.views.begin(), state.views.end(), isPicture))
        return Error{ErrorCode::inputNotUsable, Text("The saved training has no views to learn from."),
                     path.string(), Text("Train anew, with --views above 0.")};
    if (toItsEnd && stepsLeft(state) == 0)
        return Error{ErrorCode::usage,
                     Text("The saved training has all of its {} steps.", plannedSteps(state)),
                     {},
                     Text("Give --iterations for as many more.")};
    return state;
}

std::uint64_t plannedSteps(const splat::TrainingState& state) {
    return state.options.optimizer.positionSteps;
}

std::uint64_t stepsLeft(const splat::TrainingState& state) {
    return plannedSteps(state) - std::min(plannedSteps(state), state.steps);
}

}  // namespace macula::live
