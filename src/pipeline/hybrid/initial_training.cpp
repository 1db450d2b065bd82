#include "pipeline/hybrid/initial_training.h"

#include "pipeline/splat/trainer.h"

namespace macula::hybrid {

Result<splat::Splats> trainInitial(const std::shared_ptr<gpu::Device>& device, const splat::Splats& first,
                                   std::span<const TracedView> views, double radiusMm, std::uint64_t steps,
                                   const std::function<bool()>& keepGoing) {
    if (steps == 0) return first;
    constexpr std::uint64_t kStepsOfStages = 700;  // that the trainer's own stages are for
    splat::TrainerOptions options;
    options.optimizer.extentMm = radiusMm;
    options.optimizer.positionSteps = steps;
    options.loss.encode = splat::LossEncoding::display;
    for (splat::TrainingStage& stage : options.stages)
        stage.firstStep = stage.firstStep * steps / kStepsOfStages;
    MACULA_TRY(splat::Trainer trainer, splat::Trainer::create(device, first, options));
    for (const TracedView& traced : views) {
        MACULA_TRY(const splat::RasterView view,
                   splat::rasterView(traced.camera, traced.sizePx, first.originMm));
        MACULA_TRY_VOID(trainer.addView({.view = view, .pixels = traced.rgba}));
    }
    MACULA_TRY(const splat::TrainingReport report, trainer.step(steps, keepGoing));
    if (report.steps < steps) return Error{ErrorCode::cancelled, "Stopped.", {}, {}};
    return trainer.snapshot();
}

}  // namespace macula::hybrid
