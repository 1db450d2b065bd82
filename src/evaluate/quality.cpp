#include "evaluate/quality.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "evaluate/frame_makers.h"
#include "evaluate/held_out_views.h"
#include "evaluate/measurement.h"
#include "live/device/scene_on_device.h"
#include "scene/choice/lights_choice.h"

namespace macula::evaluate {

namespace {

constexpr std::string_view kFresh = "fresh";
constexpr std::string_view kRefined = "refined";

std::string wayOf(std::string_view name, Grade grade) {
    return std::string(name) + (grade == Grade::high ? "-hq" : "");
}

class Measurement {
  public:
    Measurement(const BenchStudy& study, const QualityOptions& options, live::SceneOnDevice scene,
                TracedFrames tracedFrames, Progress& progress)
        : study_(study),
          options_(options),
          scene_(std::move(scene)),
          tracedFrames_(std::move(tracedFrames)),
          progress_(progress) {}

    static Result<Measurement> create(const BenchStudy& study, const QualityOptions& options,
                                      Progress& progress) {
        MACULA_TRY(live::SceneOnDevice scene, study.putOnDevice());
        MACULA_TRY(TracedFrames tracedFrames,
                   TracedFrames::create(study.device, scene.tracer, options.bounces, progress));
        return Measurement(study, options, std::move(scene), std::move(tracedFrames), progress);
    }

    Result<QualityReport> run() {
        MACULA_TRY_VOID(traceTruth());
        MACULA_TRY_VOID(measureTracing());
        MACULA_TRY_VOID(compileModelKernels(study_, scene_, options_.bounces, progress_));
        for (const Grade grade : kGrades) MACULA_TRY_VOID(measureModels(grade));
        return std::move(report_);
    }

  private:
    Result<void> traceTruth() {
        const hybrid::TruthOptions wanted{
            .sizePx = options_.sizePx, .samplesPerPixel = options_.truthSamples, .bounces = options_.bounces};
        MACULA_TRY(const HeldOutViews views, HeldOutViews::trace(study_.device, scene_, options_.poses,
                                                                 options_.views, wanted, {}, progress_));
        std::transform(views.pictures().begin(), views.pictures().end(), std::back_inserter(truth_),
                       frameTruthOf);
        report_.viewsGivenUp = views.givenUp();
        return {};
    }

    Result<void> measureTracing() {
        progress_.beginStage(Text("Tracing whole frames"), kGrades.size() * truth_.size());
        for (const Grade grade : kGrades) {
            QualityRow row{.way = wayOf("pt", grade)};
            costs_.clear();  // the last grade has the most samples, so the best estimates
            for (const FrameTruth& truth : truth_) {
                MACULA_TRY(
                    const TracedFrames::Costed made,
                    tracedFrames_.make(truth.camera, options_.sizePx, planOf(options_, grade).wholeSamples));
                costs_.push_back(made.cost);
                MACULA_TRY_VOID(note(row, truth, made.frame));
            }
            report_.rows.push_back(std::move(row));
        }
        return {};
    }

    Result<void> measureModels(Grade grade) {
        const GradePlan plan = planOf(options_, grade);
        MACULA_TRY(hybrid::FirstModel first,
                   hybrid::makeFirstModel(study_.device, scene_.tracer, scene_.traced.seenMm(), plan.model,
                                          progress_));
        const double seconds = first.pointsSeconds + first.viewsSeconds + first.trainSeconds;
        MACULA_TRY_VOID(measureModel(grade, kFresh, first.trainer, seconds));
        MACULA_TRY(const double moreSeconds, refine(first.trainer, plan.refinement));
        return measureModel(grade, kRefined, first.trainer, seconds + moreSeconds);
    }

    // Returns the seconds that it took.
    Result<double> refine(splat::Trainer& trainer, const hybrid::RefinementOptions& plan) {
        MACULA_TRY(const hybrid::MoreViews more,
                   hybrid::beginRefinement(trainer, scene_.tracer, scene_.traced.seenMm(), plan, progress_));
        progress_.beginStage(Text("Refining"), static_cast<std::size_t>(plan.iterations));
        Watch watch;
        MACULA_TRY_VOID(trainer.step(plan.iterations, [this] {
            progress_.advance();
            return !progress_.cancelled();
        }));
        if (progress_.cancelled()) return cancelledError();
        MACULA_TRY_VOID(study_.device->waitForAll());
        return more.seconds + watch.lap().wallMs / 1e3;
    }

    // The compared ways alternate, view by view.
    Result<void> measureModel(Grade grade, std::string_view model, const splat::Trainer& trainer,
                              double preparationSeconds) {
        MACULA_TRY(const splat::Splats splats, trainer.snapshot());
        MACULA_TRY(SplatFrames frames,
                   SplatFrames::create(study_.device, scene_.tracer, options_.bounces, splats, progress_));
        const auto rowOf = [&](std::string_view name) {
            return QualityRow{.way = wayOf(name, grade),
                              .model = model,
                              .splats = splats.size(),
                              .preparationSeconds = preparationSeconds};
        };
        QualityRow bare = rowOf("splats");
        QualityRow hybrid = rowOf("hybrid");
        QualityRow equal{.way = wayOf("pt-equal", grade), .model = model};
        progress_.beginStage(Text("Comparing frames"), 3 * truth_.size());
        for (std::size_t i = 0; i < truth_.size(); ++i) {
            const Camera& camera = truth_[i].camera;
            MACULA_TRY(const MadeFrame drawn, frames.bare(camera, options_.sizePx));
            MACULA_TRY_VOID(note(bare, truth_[i], drawn));
            MACULA_TRY(const MadeFrame both,
                       frames.withFovea(camera, options_.sizePx, planOf(options_, grade).foveaSamples));
            MACULA_TRY_VOID(note(hybrid, truth_[i], both));
            MACULA_TRY(const MadeFrame traced,
                       tracedFrames_.makeIn(both.ms, costs_[i], camera, options_.sizePx));
            MACULA_TRY_VOID(note(equal, truth_[i], traced));
        }
        report_.gains.push_back(gainOf(hybrid, equal, bare));
        for (QualityRow* row : {&bare, &hybrid, &equal}) report_.rows.push_back(std::move(*row));
        return {};
    }

    Result<void> note(QualityRow& row, const FrameTruth& truth, const MadeFrame& frame) {
        MACULA_TRY(const FrameScores scores, frameScoresOf(truth, frame.shown));
        std::optional<image::SeamVisibility> seam;
        if (!frame.foveaWeights.empty()) {
            MACULA_TRY(seam, image::seamVisibility(truth.shown, frame.shown, frame.foveaWeights));
        }
        MACULA_TRY(const auto silhouette,
                   image::edgeVisibility(truth.shown, frame.shown, truth.silhouetteInMiddle));
        row.views.push_back({.scores = scores,
                             .frameMs = frame.ms,
                             .samplesPerPixel = frame.samplesPerPixel,
                             .resolutionShare = frame.resolutionShare,
                             .seam = seam,
                             .silhouette = silhouette,
                             .foveaTimes = frame.foveaTimes});
        progress_.advance();
        return progress_.cancelled() ? Result<void>(cancelledError()) : Result<void>();
    }

    const BenchStudy& study_;
    const QualityOptions& options_;
    live::SceneOnDevice scene_;
    TracedFrames tracedFrames_;
    std::vector<FrameTruth> truth_;   // by view
    std::vector<TracingCost> costs_;  // of a whole frame, by view
    QualityReport report_;
    Progress& progress_;
};

}  // namespace

GradePlan planOf(const QualityOptions& options, Grade grade) {
    const int sizePx = std::min(hybrid::kTrainingSizePx, options.sizePx.y);
    const std::uint32_t fovea = options.foveaSamples;
    GradePlan plan{.foveaSamples = fovea,
                   .wholeSamples = std::max(fovea / 2, 1u),
                   .model = {.views = 12,
                             .samplesPerPixel = 8,
                             .sizePx = sizePx,
                             .bounces = options.bounces,
                             .iterations = options.iterations},
                   .refinement = {.views = 64,
                                  .samplesPerPixel = 4,
                                  .sizePx = sizePx,
                                  .bounces = options.bounces,
                                  .iterations = 3 * options.iterations}};
    if (grade == Grade::normal) return plan;
    plan.foveaSamples = 4 * fovea;
    plan.wholeSamples = std::max(3 * fovea / 2, plan.wholeSamples + 1);
    plan.model.views = 16;
    plan.model.samplesPerPixel = 16;
    plan.model.points.count *= 2;
    plan.model.capacity *= 2;
    plan.model.iterations *= 2;
    plan.refinement.samplesPerPixel = 16;
    plan.refinement.capacity *= 2;
    plan.refinement.iterations *= 2;
    return plan;
}

std::vector<FrameScores> QualityRow::scores() const {
    std::vector<FrameScores> all;
    std::transform(views.begin(), views.end(), std::back_inserter(all),
                   [](const QualityView& view) { return view.scores; });
    return all;
}

QualityGain gainOf(const QualityRow& hybrid, const QualityRow& equal, const QualityRow& splats) {
    const std::vector<FrameScores> ours = hybrid.scores();
    std::vector<std::optional<double>> shares;
    for (std::size_t i = 0; i < hybrid.views.size(); ++i)
        shares.emplace_back(equal.views[i].frameMs / hybrid.views[i].frameMs);
    return {.way = hybrid.way,
            .model = hybrid.model,
            .foveaDb = spreadOf(gainsDb(ours, equal.scores(), &FrameScores::fovea)),
            .equalTimeShare = spreadOf(shares),
            .fullOverSplatsDb = spreadOf(gainsDb(ours, splats.scores(), &FrameScores::full))};
}

Result<QualityReport> measureQuality(const BenchStudy& study, const QualityOptions& options,
                                     Progress& progress) {
    MACULA_TRY_VOID(scene::checkPatientLights(study.environment, study.lights));
    MACULA_TRY(Measurement measurement, Measurement::create(study, options, progress));
    return measurement.run();
}

}  // namespace macula::evaluate
