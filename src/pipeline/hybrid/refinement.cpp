#include "pipeline/hybrid/refinement.h"

#include <algorithm>
#include <chrono>

#include "pipeline/hybrid/learnt_views.h"

namespace macula::hybrid {

// No rate jumps: those of the last step are the first ones. What each number is worth:
// docs/peripheral-model.md.
splat::TrainerOptions refinementTraining(splat::TrainerOptions before, std::uint64_t stepsDone,
                                         const RefinementOptions& options) {
    const std::uint64_t last = stepsDone + std::max<std::uint64_t>(options.iterations, 1);
    before.capacity = options.capacity;
    before.optimizer.position = before.optimizer.positionAtLast;
    before.optimizer.positionAtLast = 0.1 * before.optimizer.position;
    before.optimizer.othersAtLast = 0.1;
    before.optimizer.decayFrom = stepsDone;
    before.optimizer.positionSteps = last;
    before.stages = {{.firstStep = 0, .halvings = 0}};
    before.density.firstStep = stepsDone + 100;
    before.density.every = 100;
    before.density.splitShare = 0.12;
    before.density.lastStep = stepsDone + (options.iterations * 3) / 4;
    return before;
}

Result<MoreViews> beginRefinement(splat::Trainer& trainer, trace::PathTracer& tracer, const Box& seenMm,
                                  const RefinementOptions& options, Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    const ViewSampling sampling = extension(options.views);
    MACULA_TRY(const ChosenViews chosen, chooseViews(tracer, seenMm, sampling, {}, progress));
    ViewTracing tracing{.sizePx = glm::ivec2(options.sizePx), .samplesPerPixel = options.samplesPerPixel};
    tracing.settings.bounces = options.bounces;
    tracing.settings.seed = static_cast<std::uint32_t>(sampling.seed << 16);  // no other view has one near it
    MACULA_TRY(const std::vector<TracedView> views, traceViews(tracer, chosen.cameras, tracing, progress));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    for (const TracedView& view : views) MACULA_TRY_VOID(learnFrom(trainer, view));
    MACULA_TRY_VOID(
        trainer.goOnWith(refinementTraining(trainer.lastGood().options, trainer.report().steps, options)));
    return MoreViews{.seconds = seconds.count(), .givenUp = chosen.givenUp};
}

}  // namespace macula::hybrid
