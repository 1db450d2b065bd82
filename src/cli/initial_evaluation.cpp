#include "cli/initial_evaluation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "image/masked_metrics.h"
#include "pipeline/hybrid/drawn_views.h"
#include "pipeline/hybrid/first_model.h"
#include "pipeline/hybrid/traced_views.h"
#include "pipeline/hybrid/view_sampling.h"
#include "pipeline/splat/displayed.h"

namespace macula::cli {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr double kLeastCoverageOfTruth = 0.06;

class Evaluation {
  public:
    Evaluation(std::shared_ptr<gpu::Device> device, const InitialEvaluationOptions& options,
               trace::PathTracer& tracer, const hybrid::TracedScene& scene, Progress& progress)
        : device_(std::move(device)),
          options_(options),
          tracer_(tracer),
          scene_(scene),
          progress_(progress) {}

    Result<SceneEvaluation> run() {
        report_.seenMm = scene_.seenMm();
        MACULA_TRY(const auto truthCameras,
                   choose(hybrid::groundTruth(options_.truthViews), kLeastCoverageOfTruth));
        MACULA_TRY(const splat::Splats model, makeModel());
        auto start = Clock::now();
        MACULA_TRY(const auto truth, hybrid::truthPictures(tracer_, scene_, truthCameras, options_.truth,
                                                           hybrid::PictureCache(options_.cache), progress_));
        report_.truthSeconds = secondsSince(start);
        MACULA_TRY_VOID(compare(model, truth));
        return std::move(report_);
    }

  private:
    Result<std::vector<Camera>> choose(const hybrid::ViewSampling& sampling, double leastCoverage) {
        const double radiusMm = 0.5 * scene_.seenMm().diagonal();
        MACULA_TRY(const auto views,
                   hybrid::sampleViews(
                       scene_.seenMm(), sampling,
                       hybrid::showsEnough(tracer_, radiusMm, {.leastCoverage = leastCoverage}, progress_)));
        std::vector<Camera> cameras;
        for (const hybrid::SampledView& view : views) {
            cameras.push_back(view.camera);
            if (!view.accepted) ++report_.viewsGivenUp;
        }
        return cameras;
    }

    Result<splat::Splats> makeModel() {
        const hybrid::FirstModelOptions wanted{.points = options_.points,
                                               .views = options_.views,
                                               .samplesPerPixel = options_.samplesPerPixel,
                                               .sizePx = options_.sizePx,
                                               .bounces = options_.truth.bounces,
                                               .trial = options_.trial,
                                               .iterations = options_.iterations};
        MACULA_TRY(const hybrid::FirstModel model,
                   hybrid::makeFirstModel(device_, tracer_, scene_.seenMm(), wanted, progress_));
        report_.pointsSeconds = model.pointsSeconds;
        report_.viewsSeconds = model.viewsSeconds;
        report_.trainSeconds = model.trainSeconds;
        report_.viewsGivenUp += model.viewsGivenUp;
        MACULA_TRY(splat::Splats splats, model.trainer.snapshot());
        report_.splats = splats.size();
        return splats;
    }

    Result<void> compare(const splat::Splats& model, const std::vector<hybrid::TruthPicture>& truth) {
        progress_.beginStage("Comparing", truth.size());
        const glm::ivec2 size = options_.truth.sizePx;
        std::vector<Camera> cameras;
        std::transform(truth.begin(), truth.end(), std::back_inserter(cameras),
                       [](const hybrid::TruthPicture& picture) { return picture.view.camera; });
        MACULA_TRY(const hybrid::DrawnViews drawn, hybrid::drawViews(device_, model, cameras, size));
        report_.drawMs = image::percentile(drawn.milliseconds, 0.5);
        double squares = 0.0;
        for (const hybrid::TruthPicture& picture : truth) {
            if (progress_.cancelled()) return Error{ErrorCode::cancelled, "Stopped.", {}, {}};
            const std::vector<glm::vec4>& rgba = drawn.pictures[report_.scores.size()];
            MACULA_TRY(const ViewScores scores, scoresOf(picture.view, rgba));
            report_.scores.push_back(scores);
            report_.pictures.push_back(besideEachOther(size, picture.view.rgba, rgba));
            squares += picture.noise * picture.noise;
            report_.truthFromCache += picture.fromCache ? 1 : 0;
            progress_.advance();
        }
        report_.truthNoise = std::sqrt(squares / double(std::max<std::size_t>(truth.size(), 1)));
        return {};
    }

    static std::vector<std::uint8_t> besideEachOther(const glm::ivec2& size, std::span<const glm::vec4> left,
                                                     std::span<const glm::vec4> right) {
        std::vector<std::uint8_t> rgba;
        rgba.reserve(left.size() * 8);
        const auto a = splat::displayed(left, splat::ColourSpace::linear, {});
        const auto b = splat::displayed(right, splat::ColourSpace::linear, {});
        const auto rowBytes = 4 * static_cast<std::ptrdiff_t>(size.x);
        for (std::ptrdiff_t y = 0; y < size.y; ++y) {
            for (const auto* half : {&a, &b})
                rgba.insert(rgba.end(), half->begin() + y * rowBytes, half->begin() + (y + 1) * rowBytes);
        }
        return rgba;
    }

    std::shared_ptr<gpu::Device> device_;
    const InitialEvaluationOptions& options_;
    trace::PathTracer& tracer_;
    const hybrid::TracedScene& scene_;
    Progress& progress_;
    SceneEvaluation report_;
};

}  // namespace

Result<SceneEvaluation> evaluateInitial(const std::shared_ptr<gpu::Device>& device,
                                        const EvaluatedScene& scene, const InitialEvaluationOptions& options,
                                        Progress& progress) {
    MACULA_TRY(const hybrid::TracedScene traced,
               hybrid::TracedScene::create(scene.volume, scene.function, scene.clip, scene.environment));
    if (!(traced.seenMm().low.x <= traced.seenMm().high.x))
        return Error{ErrorCode::inputNotUsable,
                     "Nothing of the series can be seen.",
                     {},
                     "Choose another preset or clip."};
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device));
    MACULA_TRY_VOID(tracer.setVolume(scene.volume));
    MACULA_TRY_VOID(tracer.setClip(scene.clip));
    MACULA_TRY_VOID(tracer.setTransferFunction(scene.function));
    MACULA_TRY_VOID(tracer.setEnvironment(scene.environment));
    return Evaluation(device, options, tracer, traced, progress).run();
}

}  // namespace macula::cli
