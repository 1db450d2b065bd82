#include "evaluate/frame_tradeoff.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

#include "evaluate/frame_makers.h"
#include "evaluate/measurement.h"
#include "evaluate/viewpoints.h"
#include "live/device/scene_on_device.h"
#include "scene/choice/lights_choice.h"

namespace macula::evaluate {

namespace {

// The camera after a turn around `centreMm`, about its up axis. At an angle of 0 it is unchanged to the last
// bit.
Camera goneAround(const Camera& camera, const glm::dvec3& centreMm, double degrees) {
    if (degrees == 0.0) return camera;
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(degrees), basis(camera)->up);
    Camera gone = camera;
    gone.positionMm = centreMm + transformVector(turn, camera.positionMm - centreMm);
    gone.targetMm = centreMm + transformVector(turn, camera.targetMm - centreMm);
    gone.up = transformVector(turn, camera.up);
    return gone;
}

struct ShownFrame {
    double drawMs = 0.0;
    FrameErrors errors;
};

// A traced fovea, which several recipes share: they differ only in how they show it.
struct AgedFovea {
    int age = 0;  // frames
    double traceMs = 0.0;
    ShownFrame warped;
    ShownFrame pasted;
};

FramePoint pointOf(const FrameRecipe& recipe, std::span<const AgedFovea> foveae) {
    FramePoint point{.recipe = recipe};
    const std::vector<int> ages = agesOf(recipe.framesPerFovea);
    std::vector<FrameErrors> errors;
    for (const AgedFovea& fovea : foveae) {
        if (std::find(ages.begin(), ages.end(), fovea.age) == ages.end()) continue;
        const ShownFrame& shown = recipe.isWarped ? fovea.warped : fovea.pasted;
        point.drawMs += shown.drawMs;
        point.foveaMs += fovea.traceMs;
        errors.push_back(shown.errors);
    }
    point.drawMs /= double(errors.size());
    point.foveaMs /= double(errors.size());
    point.errors = meanOf(errors);
    return point;
}

class Measurement {
  public:
    Measurement(const BenchStudy& study, const FrameTradeoffOptions& options, live::SceneOnDevice scene,
                Progress& progress)
        : study_(study), options_(options), scene_(std::move(scene)), progress_(progress) {}

    Result<FrameTradeoff> run() {
        MACULA_TRY_VOID(traceTruth());
        MACULA_TRY_VOID(measureModels());
        MACULA_TRY_VOID(measureFrames());
        markFronts(report_);
        return std::move(report_);
    }

  private:
    Result<void> traceTruth() {
        std::vector<Camera> cameras;
        for (const Viewpoint& viewpoint : kViewpoints)
            cameras.push_back(
                cameraFrom(viewpoint, scene_.traced.seenMm(), options_.verticalFovDeg, options_.sizePx));
        const hybrid::TruthOptions wanted{.sizePx = options_.sizePx,
                                          .samplesPerPixel = options_.truthSamples,
                                          .bounces = options_.truthBounces};
        const hybrid::PictureCache nothingKept{std::filesystem::path()};
        MACULA_TRY(
            const std::vector<hybrid::TruthPicture> pictures,
            hybrid::truthPictures(scene_.tracer, scene_.traced, cameras, wanted, nothingKept, progress_));
        std::transform(pictures.begin(), pictures.end(), std::back_inserter(truth_), frameTruthOf);
        return {};
    }

    Result<void> measureModels() {
        MACULA_TRY_VOID(compileModelKernels(study_, scene_, options_.model.bounces, progress_));
        hybrid::FirstModelOptions usual = options_.model;
        usual.sizePx = std::min(usual.sizePx, options_.sizePx.y);
        for (const ModelRecipe& recipe : modelRecipesOf(usual, options_.models)) {
            MACULA_TRY(const hybrid::FirstModel model,
                       hybrid::makeFirstModel(study_.device, scene_.tracer, scene_.traced.seenMm(),
                                              recipe.options, progress_));
            MACULA_TRY(splat::Splats splats, model.trainer.snapshot());
            MACULA_TRY(const ShownFrame shown, drawSplats(splats));
            report_.models.push_back(
                {.recipe = recipe,
                 .splats = splats.size(),
                 .preparationSeconds = model.pointsSeconds + model.viewsSeconds + model.trainSeconds,
                 .drawMs = shown.drawMs,
                 .errors = shown.errors});
            if (report_.models.size() == 1) splats_ = std::move(splats);
        }
        return {};
    }

    // Frames of splats alone; the mean over the viewpoints.
    Result<ShownFrame> drawSplats(const splat::Splats& splats) {
        MACULA_TRY(MovingFrames frames,
                   MovingFrames::create(study_.device, scene_.tracer, splats, options_.sizePx, progress_));
        ShownFrame mean;
        std::vector<FrameErrors> errors;
        for (const FrameTruth& truth : truth_) {
            MACULA_TRY(const ShownFrame shown, shownIn(frames, truth, true));
            mean.drawMs += shown.drawMs / double(truth_.size());
            errors.push_back(shown.errors);
        }
        mean.errors = meanOf(errors);
        return mean;
    }

    Result<void> measureFrames() {
        const ModelPoint& usual = report_.models.front();
        report_.frames.push_back({.recipe = {}, .drawMs = usual.drawMs, .errors = usual.errors});
        MACULA_TRY(MovingFrames frames,
                   MovingFrames::create(study_.device, scene_.tracer, splats_, options_.sizePx, progress_));
        const std::vector<TracedFovea> foveae = foveaeOf(options_.frames);
        const std::vector<int> ages = agesOf(options_.frames);
        progress_.beginStage(Text("Comparing frames"), foveae.size() * truth_.size() * ages.size());
        for (const TracedFovea& fovea : foveae) {
            // An untimed picture first: for each number of bounces the tracer has to find the size of a
            // dispatch.
            MACULA_TRY([[maybe_unused]] const double unused, frames.traceFovea(truth_[0].camera, fovea));
            std::vector<AgedFovea> measured;
            for (const FrameTruth& truth : truth_) {
                for (const int age : ages) {
                    MACULA_TRY(const AgedFovea aged, measureFovea(frames, fovea, truth, age));
                    measured.push_back(aged);
                }
            }
            for (const FrameRecipe& recipe : recipesOf(fovea, options_.frames))
                report_.frames.push_back(pointOf(recipe, measured));
        }
        return {};
    }

    Result<AgedFovea> measureFovea(MovingFrames& frames, const TracedFovea& fovea, const FrameTruth& truth,
                                   int age) {
        const Camera before =
            goneAround(truth.camera, scene_.traced.seenMm().centre(), -age * options_.degreesPerFrame);
        AgedFovea aged{.age = age};
        MACULA_TRY(aged.traceMs, frames.traceFovea(before, fovea));
        MACULA_TRY(aged.warped, shownIn(frames, truth, true));
        MACULA_TRY(aged.pasted, shownIn(frames, truth, false));
        progress_.advance();
        return aged;
    }

    Result<ShownFrame> shownIn(MovingFrames& frames, const FrameTruth& truth, bool isWarped) {
        if (progress_.cancelled()) return cancelledError();
        MACULA_TRY(const MadeFrame made, frames.draw(truth.camera, isWarped));
        MACULA_TRY(const FrameScores scores, frameScoresOf(truth, made.shown));
        constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
        return ShownFrame{.drawMs = made.ms,
                          .errors = {.flip = scores.full.flip.value_or(kUnknown),
                                     .fovealFlip = scores.fovea.flip.value_or(kUnknown),
                                     .maskedPsnrDb = scores.full.maskedPsnrDb}};
    }

    const BenchStudy& study_;
    const FrameTradeoffOptions& options_;
    live::SceneOnDevice scene_;
    std::vector<FrameTruth> truth_;  // by viewpoint
    splat::Splats splats_;           // of the usual model
    FrameTradeoff report_;
    Progress& progress_;
};

}  // namespace

FrameErrors meanOf(std::span<const FrameErrors> errors) {
    FrameErrors mean;
    double psnrDb = 0.0;
    std::size_t withPsnr = 0;
    for (const FrameErrors& e : errors) {
        mean.flip += e.flip / double(errors.size());
        mean.fovealFlip += e.fovealFlip / double(errors.size());
        psnrDb += e.maskedPsnrDb.value_or(0.0);
        withPsnr += e.maskedPsnrDb ? 1 : 0;
    }
    if (withPsnr > 0) mean.maskedPsnrDb = psnrDb / double(withPsnr);
    return mean;
}

std::vector<CostAndError> costsOf(std::span<const ModelPoint> models) {
    std::vector<CostAndError> costs;
    for (const ModelPoint& model : models) costs.push_back({model.preparationSeconds, model.errors.flip});
    return costs;
}

std::vector<CostAndError> costsOf(std::span<const FramePoint> frames, double FrameErrors::*error) {
    std::vector<CostAndError> costs;
    for (const FramePoint& frame : frames) costs.push_back({frame.ms(), frame.errors.*error});
    return costs;
}

void markFronts(FrameTradeoff& tradeoff) {
    for (const std::size_t i : paretoFront(costsOf(tradeoff.models))) tradeoff.models[i].onFront = true;
    for (const std::size_t i : paretoFront(costsOf(tradeoff.frames, &FrameErrors::flip)))
        tradeoff.frames[i].onFront = true;
    for (const std::size_t i : paretoFront(costsOf(tradeoff.frames, &FrameErrors::fovealFlip)))
        tradeoff.frames[i].onFovealFront = true;
}

Result<FrameTradeoff> measureFrameTradeoff(const BenchStudy& study, const FrameTradeoffOptions& options,
                                           Progress& progress) {
    MACULA_TRY_VOID(scene::checkPatientLights(study.environment, study.lights));
    MACULA_TRY(live::SceneOnDevice scene, study.putOnDevice());
    return Measurement(study, options, std::move(scene), progress).run();
}

std::vector<std::size_t> paretoFront(std::span<const CostAndError> points) {
    std::vector<std::size_t> byCost;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) byCost.push_back(i);
    }
    std::stable_sort(byCost.begin(), byCost.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(points[a].cost, points[a].error) < std::tie(points[b].cost, points[b].error);
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();  // least error of all points that cost no more
    for (const std::size_t i : byCost) {
        if (points[i].error >= least) continue;
        least = points[i].error;
        front.push_back(i);
    }
    return front;
}

}  // namespace macula::evaluate
