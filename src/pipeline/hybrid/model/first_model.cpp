#include "pipeline/hybrid/model/first_model.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "pipeline/hybrid/model/model_start.h"
#include "pipeline/hybrid/views/training_set.h"
#include "pipeline/hybrid/views/training_views.h"

namespace macula::hybrid {

namespace {

// Of the time left after the choice of points and views, the share that must remain after tracing, and after
// lighting.
constexpr double kLeftAfterTracing = 0.6;
constexpr double kLeftAfterLighting = 0.5;

// Whether one more view, if it takes as long as the last one, leaves enough of a budget.
class Allowance {
  public:
    Allowance(const TimeBudget& budget, double leaveSeconds)
        : budget_(&budget), leaveSeconds_(leaveSeconds) {}

    bool operator()() {
        const double left = budget_->leftSeconds();
        const double took = leftSeconds_.value_or(left) - left;
        leftSeconds_ = left;
        return left - took >= leaveSeconds_;
    }

  private:
    const TimeBudget* budget_;
    double leaveSeconds_;
    std::optional<double> leftSeconds_;  // at the last call
};

Error cancelled() {
    return {ErrorCode::cancelled, Text("The training was cancelled."), {}, {}};
}

// Adds pictures and stand-ins in turn, because the trainer draws new views in the order in which they were
// added.
Result<void> learnFromAll(splat::Trainer& trainer, const Box& seenMm, TrainingPictures pictures) {
    const auto learn = pictures.areLit ? learnStandInFrom : learnCoverageFrom;
    std::vector<TracedView>& sides = pictures.sides;
    std::size_t told = 0;
    for (std::size_t i = 0; i < pictures.traced.size(); ++i) {
        MACULA_TRY_VOID(learnFrom(trainer, seenMm, std::move(pictures.traced[i])));
        for (; told < (i + 1) * sides.size() / pictures.traced.size(); ++told)
            MACULA_TRY_VOID(learn(trainer, seenMm, std::move(sides[told])));
    }
    return {};
}

Result<void> train(FirstModel& model, const FirstModelOptions& options, const TimeBudget& budget,
                   Progress& progress) {
    progress.beginStage(Text("Training"), static_cast<std::size_t>(options.iterations));
    const auto keepGoing = [&] {
        progress.advance();
        return !options.beginsOnly && !progress.cancelled() && !budget.isSpent();
    };
    MACULA_TRY_VOID(model.trainer.step(options.iterations, keepGoing));
    if (progress.cancelled()) return cancelled();
    return {};
}

}  // namespace

// The rates minimise the error after 400 to 700 steps on the phantom and a chest CT (the rate of positions
// only on the phantom): docs/peripheral-model.md.
splat::TrainerOptions trainerOptions(const FirstModelOptions& options) {
    splat::TrainerOptions training;
    training.capacity = options.capacity;
    training.seed = static_cast<std::uint32_t>(options.trial);
    training.loss.encode = splat::LossEncoding::display;
    splat::OptimizerOptions& rates = training.optimizer;
    rates.position = 0.05;
    rates.positionAtLast = 0.005;
    // Towards the end single views pull the model to and fro; with smaller steps it settles between them.
    rates.decayFrom = options.iterations * 7 / 10;
    rates.positionSteps = std::max<std::uint64_t>(options.iterations, 1);
    rates.othersAtLast = 0.2;
    rates.logScale = 0.04;
    rates.rotation = 0.002;
    rates.opacityLogit = 0.1;
    rates.dc = 0.015;
    rates.sh = rates.dc / 20.0;
    // The first fifth of the steps uses pictures of half the size. Small pictures are not halved: they would
    // show too little.
    training.stages = {{.firstStep = 0, .halvings = options.sizePx >= 256 ? 1 : 0},
                       {.firstStep = options.iterations / 5, .halvings = 0}};
    // The last steps use squared differences: absolute ones favour the median, and lose light.
    if (options.iterations > 0)
        training.stages.push_back(
            {.firstStep = options.iterations * 3 / 4, .halvings = 0, .measure = splat::LossMeasure::squared});
    return training;
}

Result<FirstModel> makeFirstModel(const std::shared_ptr<gpu::Device>& device, trace::PathTracer& tracer,
                                  const Box& seenMm, const FirstModelOptions& options, Progress& progress) {
    const TimeBudget withoutEnd;
    const TimeBudget& budget = options.budget != nullptr ? *options.budget : withoutEnd;
    const double before = budget.spentSeconds();
    MACULA_TRY(ModelStart first, startFromPoints(tracer, seenMm, {}, options.points, progress));
    first.splats.setShDegree(options.shDegree);
    const double withPoints = budget.spentSeconds();

    std::size_t givenUp = 0;
    TrainingPictures pictures;
    if (options.views > 0) {
        const std::size_t lacking = options.directions - std::min(options.views, options.directions);
        MACULA_TRY(ChosenPoses traced,
                   choosePoses(tracer, seenMm, initialTraining(options.views, options.trial), {}, progress));
        ChosenPoses sides;
        if (lacking > 0) {
            MACULA_TRY(sides, choosePoses(tracer, seenMm, otherSides(lacking, options.trial), {}, progress));
        }
        const double withPoses = budget.spentSeconds();
        givenUp = traced.givenUp + sides.givenUp;
        ViewTracing tracing{.sizePx = glm::ivec2(options.sizePx),
                            .samplesPerPixel = options.samplesPerPixel,
                            .kept = options.kept};
        tracing.settings.bounces = options.bounces;
        if (budget.isLimited()) {
            const double left = budget.leftSeconds();
            tracing.hasTimeToTrace = Allowance(budget, kLeftAfterTracing * left);
            tracing.hasTimeToLight = Allowance(budget, kLeftAfterLighting * left);
        }
        tracing.settings.seed =
            static_cast<std::uint32_t>(options.trial) * 0x9e3779b9u;  // far from other trials
        const TrainingSet set{.traced = std::move(traced.cameras), .sides = std::move(sides.cameras)};
        MACULA_TRY(pictures, makePictures(tracer, seenMm, set, tracing, progress));
        pictures.times.poses = withPoses - withPoints;
    }
    const double withViews = budget.spentSeconds();

    MACULA_TRY(splat::Trainer trainer, splat::Trainer::create(device, first.splats, trainerOptions(options)));
    const std::size_t fromKept = pictures.fromKept;
    const std::size_t viewsTraced = pictures.traced.size();
    ViewTimes viewTimes = pictures.times;
    const bool canLearn = !pictures.traced.empty();
    {
        const Lap lap(viewTimes.toTrainer);
        MACULA_TRY_VOID(learnFromAll(trainer, seenMm, std::move(pictures)));
    }
    FirstModel model{.trainer = std::move(trainer),
                     .pointsSeconds = withPoints - before,
                     .viewsSeconds = withViews - withPoints,
                     .viewTimes = viewTimes,
                     .viewsTraced = viewsTraced,
                     .viewsGivenUp = givenUp,
                     .viewsFromKept = fromKept};
    if (options.iterations > 0 && canLearn) MACULA_TRY_VOID(train(model, options, budget, progress));
    model.trainSeconds = budget.spentSeconds() - withViews;
    return model;
}

}  // namespace macula::hybrid
