#include "evaluate/model_evaluation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/elapsed.h"
#include "evaluate/held_out_views.h"
#include "pipeline/hybrid/model/live_model.h"
#include "pipeline/splat/model/constant_colour.h"

namespace macula::evaluate {

namespace {

using Clock = std::chrono::steady_clock;

// Multiplies the light by the gain, as the window does.
splat::Splats asBrightAs(splat::Splats splats, double gain) {
    for (glm::vec3& dc : splats.dc) dc = splat::dcOfColour(static_cast<float>(gain) * splat::colourOfDc(dc));
    for (glm::vec3& sh : splats.sh) sh *= static_cast<float>(gain);
    return splats;
}

// Compares snapshots only after all training, so that nothing else runs between training steps.
class Evaluation {
  public:
    Evaluation(std::shared_ptr<gpu::Device> device, const EvaluationOptions& options,
               live::SceneOnDevice& scene, Progress& progress)
        : device_(std::move(device)),
          options_(options),
          scene_(scene),
          progress_(progress),
          // The key of a picture does not say how coarsely this device stores the volume.
          cacheFolder_(scene.isCoarse ? std::filesystem::path() : options.cache),
          cache_(cacheFolder_),
          kept_(scene.traced, cache_) {}

    Result<SceneEvaluation> run() {
        report_.seenMm = scene_.traced.seenMm();
        MACULA_TRY_VOID(cache_.prepare());
        if (options_.live) {
            MACULA_TRY_VOID(liveModel(*options_.live));
        } else {
            MACULA_TRY(hybrid::FirstModel model, firstModel());
            MACULA_TRY_VOID(keep(model.trainer, model.trainSeconds));
            if (options_.refinement) MACULA_TRY_VOID(refine(model, *options_.refinement));
        }
        MACULA_TRY(const HeldOutViews truth,
                   HeldOutViews::trace(device_, scene_, hybrid::groundTruth(), options_.truthViews,
                                       options_.truth, cacheFolder_, progress_));
        report_.truthCameras = truth.cameras();
        report_.truthSeconds = truth.seconds();
        report_.truthFromCache = truth.fromCache();
        report_.viewsGivenUp += truth.givenUp();
        for (std::size_t i = 0; i < models_.size(); ++i) {
            MACULA_TRY(Comparison comparison, truth.compare(models_[i], progress_));
            report_.snapshots[i].scores = std::move(comparison.scores);
            report_.drawMs = comparison.drawMs;
            report_.pictures = std::move(comparison.pictures);
        }
        return std::move(report_);
    }

  private:
    const hybrid::ViewCache* kept() const { return options_.keepViews ? &kept_ : nullptr; }

    Result<void> liveModel(const LivePlan& plan) {
        constexpr double kSliceMs = 40.0;
        auto shelf = std::make_shared<hybrid::ModelShelf>(0);
        MACULA_TRY(hybrid::LiveModel model,
                   hybrid::LiveModel::create(device_, scene_.tracer, std::move(shelf), nullptr,
                                             hybrid::liveModelOptions(*device_)));
        MACULA_TRY_VOID(model.show("evaluated", {.bounces = options_.model.bounces}));
        const auto goesOn = [&] { return !progress_.cancelled(); };
        progress_.beginStage(Text("Finding points"), 1);
        auto start = Clock::now();
        while (model.news().stage == hybrid::ModelStage::searching && goesOn())
            MACULA_TRY_VOID(model.work(kSliceMs, goesOn));
        report_.pointsSeconds = secondsSince(start);
        progress_.advance();
        progress_.beginStage(Text("Learning"), static_cast<std::size_t>(std::ceil(plan.seconds)));
        start = Clock::now();
        double next = 0.0;
        for (std::size_t told = 0;;) {
            const double seconds = secondsSince(start);
            const bool isLast = !model.hasWork() || seconds >= plan.seconds;
            if (progress_.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
            if (!model.canBeDrawn())
                return Error{ErrorCode::outOfMemory,
                             Text("There is no room on the device for a model."),
                             {},
                             Text("Close other programs, or choose another device.")};
            if (isLast || seconds >= next) {
                report_.snapshots.push_back({.steps = model.news().steps,
                                             .splats = model.news().splats,
                                             .trainSeconds = seconds,
                                             .scores = {}});
                models_.push_back(asBrightAs(*model.shown(), model.gain()));
                next += plan.snapshotEvery;
            }
            if (isLast) return {};
            MACULA_TRY_VOID(model.work(kSliceMs, goesOn));
            for (; told < static_cast<std::size_t>(secondsSince(start)); ++told) progress_.advance();
        }
    }

    Result<hybrid::FirstModel> firstModel() {
        hybrid::FirstModelOptions wanted = options_.model;
        wanted.kept = kept();
        MACULA_TRY(hybrid::FirstModel model,
                   hybrid::makeFirstModel(device_, scene_.tracer, scene_.traced.seenMm(), wanted, progress_));
        report_.viewsFromCache += model.viewsFromKept;
        report_.pointsSeconds = model.pointsSeconds;
        report_.viewsSeconds = model.viewsSeconds;
        report_.viewsGivenUp += model.viewsGivenUp;
        return model;
    }

    Result<void> refine(hybrid::FirstModel& model, const RefinementPlan& plan) {
        splat::Trainer& trainer = model.trainer;
        const hybrid::RefinementOptions wanted{.views = plan.views,
                                               .samplesPerPixel = plan.samplesPerPixel,
                                               .sizePx = options_.model.sizePx,
                                               .bounces = options_.model.bounces,
                                               .iterations = plan.iterations,
                                               .capacity = plan.capacity,
                                               .kept = kept()};
        MACULA_TRY(
            const hybrid::MoreViews more,
            hybrid::beginRefinement(trainer, scene_.tracer, scene_.traced.seenMm(), wanted, progress_));
        report_.moreViewsSeconds = more.seconds;
        report_.viewsGivenUp += more.givenUp;
        report_.viewsFromCache += more.fromKept;
        progress_.beginStage(Text("Refining"), static_cast<std::size_t>(plan.iterations));
        double seconds = model.trainSeconds;
        for (std::uint64_t done = 0; done < plan.iterations;) {
            const std::uint64_t count = std::min(plan.snapshotEvery, plan.iterations - done);
            const auto start = Clock::now();
            MACULA_TRY_VOID(trainer.step(count, [&] {
                progress_.advance();
                return !progress_.cancelled();
            }));
            if (progress_.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
            seconds += secondsSince(start);
            done += count;
            MACULA_TRY_VOID(keep(trainer, seconds));
        }
        return {};
    }

    Result<void> keep(const splat::Trainer& trainer, double trainSeconds) {
        MACULA_TRY(splat::Splats splats, trainer.snapshot());
        report_.snapshots.push_back({.steps = trainer.report().steps,
                                     .splats = splats.size(),
                                     .trainSeconds = trainSeconds,
                                     .scores = {}});
        models_.push_back(std::move(splats));
        return {};
    }

    std::shared_ptr<gpu::Device> device_;
    const EvaluationOptions& options_;
    live::SceneOnDevice& scene_;
    Progress& progress_;
    std::filesystem::path cacheFolder_;
    hybrid::PictureCache cache_;
    hybrid::ViewCache kept_;
    SceneEvaluation report_;
    std::vector<splat::Splats> models_;  // by snapshot
};

}  // namespace

Result<SceneEvaluation> evaluateModel(const std::shared_ptr<gpu::Device>& device,
                                      const live::StudyScene& scene, const EvaluationOptions& options,
                                      Progress& progress) {
    MACULA_TRY(live::SceneOnDevice onDevice, live::putOnDevice(device, scene));
    return Evaluation(device, options, onDevice, progress).run();
}

double SceneEvaluation::truthNoise() const {
    double squares = 0.0;
    for (const ViewScores& scores : last().scores)
        squares += scores.truthNoise.value_or(0.0) * scores.truthNoise.value_or(0.0);
    return std::sqrt(squares / double(std::max<std::size_t>(last().scores.size(), 1)));
}

GreatestFall greatestFall(const std::vector<Snapshot>& snapshots) {
    GreatestFall fall;
    for (std::size_t i = 1; i < snapshots.size(); ++i) {
        const auto before = spreadOf(snapshots[i - 1].scores, &ViewScores::maskedPsnrDb);
        const auto after = spreadOf(snapshots[i].scores, &ViewScores::maskedPsnrDb);
        if (!before || !after) continue;
        fall.meanDb = std::max(fall.meanDb, before->mean - after->mean);
        fall.medianDb = std::max(fall.medianDb, before->p50 - after->p50);
    }
    return fall;
}

}  // namespace macula::evaluate
