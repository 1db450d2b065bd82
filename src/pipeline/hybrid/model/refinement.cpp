#include "pipeline/hybrid/model/refinement.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/elapsed.h"
#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/hybrid/model/training_rounds.h"
#include "pipeline/hybrid/views/training_set.h"
#include "pipeline/hybrid/views/training_views.h"

namespace macula::hybrid {

namespace {

constexpr std::uint64_t kEvery = 50;  // steps between splits, at most
constexpr double kGrowing = 0.4;      // part of the steps in which splats are split; then they settle
constexpr double kSquaresFrom = 0.9;  // part of the steps after which differences are squared
constexpr double kMostAtOnce = 0.22;  // part of the splats that one step may split
// With so many pictures, stand-in views are dropped.
constexpr std::size_t kEnoughSides = FirstModelOptions{}.directions;

// The share of splats to split each time, so that the capacity is filled before the last split.
double splitShare(double splats, double capacity, double splits) {
    if (!(splats > 0.0) || capacity <= splats) return 0.05;
    return std::min(1.25 * (std::pow(capacity / splats, 1.0 / splits) - 1.0), kMostAtOnce);
}

std::size_t picturesOf(const splat::Trainer& trainer) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < trainer.viewCount(); ++i)
        if (trainer.view(i).kind == splat::ViewKind::picture) ++count;
    return count;
}

}  // namespace

// docs/peripheral-model.md says what each number gains.
splat::TrainerOptions refinementTraining(splat::TrainerOptions before, const splat::TrainingReport& now,
                                         const RefinementOptions& options) {
    const std::uint64_t steps = std::max<std::uint64_t>(options.iterations, 1);
    // Rates larger than at the end of the earlier training, which fall likewise.
    const splat::OptimizerOptions& rates = before.optimizer;
    before.optimizer =
        following(rates, {.position = std::min(rates.position, options.warmer * rates.positionAtLast),
                          .others = std::min(1.0, options.warmer * rates.othersAtLast),
                          .holdUntil = now.steps,
                          .fallUntil = now.steps + steps});
    before.capacity = options.capacity;
    before.stages = {{.firstStep = 0, .halvings = 0},
                     {.firstStep = now.steps + static_cast<std::uint64_t>(kSquaresFrom * double(steps)),
                      .halvings = 0,
                      .measure = splat::LossMeasure::squared}};
    const auto growing = static_cast<std::uint64_t>(kGrowing * double(steps));
    const std::uint64_t every = std::clamp<std::uint64_t>(growing, 1, kEvery);
    // With hundreds of views, removing the least visible splats costs 2 dB (docs/peripheral-model.md).
    before.density.unseenShare = 0.0;
    before.density.every = every;
    before.density.firstStep = now.steps + every;
    before.density.lastStep = now.steps + growing;
    before.density.splitShare = splitShare(double(now.splats), double(options.capacity),
                                           double(std::max(growing / every, std::uint64_t(1))));
    return before;
}

Result<MoreViews> beginRefinement(splat::Trainer& trainer, trace::PathTracer& tracer, const Box& seenMm,
                                  const RefinementOptions& options, Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    const PoseSampling sampling = extension(options.views);
    MACULA_TRY(const ChosenPoses chosen, choosePoses(tracer, seenMm, sampling, {}, progress));
    ViewTracing tracing{.sizePx = glm::ivec2(options.sizePx),
                        .samplesPerPixel = options.samplesPerPixel,
                        .kept = options.kept};
    tracing.settings.bounces = options.bounces;
    tracing.settings.seed = static_cast<std::uint32_t>(sampling.seed << 16);  // far from all other seeds
    const TrainingSet set{.traced = chosen.cameras};
    MACULA_TRY(TrainingPictures pictures, makePictures(tracer, seenMm, set, tracing, progress));
    const splat::TrainerOptions training =
        refinementTraining(trainer.lastGood().options, trainer.report(), options);
    MACULA_TRY_VOID(
        trainer.goOnWith(training, std::max(options.shDegree, trainer.lastGood().splats.shDegree)));
    for (TracedView& view : pictures.traced) MACULA_TRY_VOID(learnFrom(trainer, seenMm, std::move(view)));
    if (picturesOf(trainer) >= kEnoughSides) trainer.forgetStandIns();
    return MoreViews{
        .seconds = secondsSince(start), .givenUp = chosen.givenUp, .fromKept = pictures.fromKept};
}

}  // namespace macula::hybrid
