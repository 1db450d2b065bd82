#include "evaluate/motion.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "evaluate/frame_makers.h"
#include "evaluate/shown_picture.h"
#include "evaluate/viewpoints.h"
#include "image/masked_metrics.h"
#include "image/metrics.h"
#include "live/device/scene_on_device.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/splat/draw/model_painter.h"
#include "scene/choice/lights_choice.h"

namespace macula::evaluate {

namespace {

constexpr float kOpaque = 0.95f;
// Difference between a frame over black and the same over white at which half of a pixel is background.
constexpr float kBackgroundShows = 128.5f / 255.0f;

Camera movedCamera(const Camera& camera, Moved moved, double amount) {
    const CameraBasis axes = *basis(camera);
    Camera now = camera;
    if (moved == Moved::step) {
        now.positionMm += axes.right * amount;
        now.targetMm += axes.right * amount;
    } else {
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(-amount), axes.up);
        now.targetMm = now.positionMm + transformVector(turn, now.targetMm - now.positionMm);
    }
    return now;
}

struct Truth {
    image::Image image;
    std::vector<bool> isOpaque;  // the pixel and its eight neighbours
    image::Mask silhouette;      // in the middle
};

class Measurement {
  public:
    Measurement(const BenchStudy& study, const MotionOptions& options, live::SceneOnDevice scene,
                hybrid::HybridFrame withFovea, hybrid::HybridFrame bare, Progress& progress)
        : study_(study),
          options_(options),
          scene_(std::move(scene)),
          withFovea_(std::move(withFovea)),
          bare_(std::move(bare)),
          progress_(progress) {}

    static Result<Measurement> create(const BenchStudy& study, const MotionOptions& options,
                                      Progress& progress) {
        MACULA_TRY(live::SceneOnDevice scene, study.putOnDevice());
        MACULA_TRY(hybrid::HybridFrame withFovea, hybrid::HybridFrame::create(study.device, scene.tracer));
        MACULA_TRY(hybrid::HybridFrame bare, hybrid::HybridFrame::create(study.device, scene.tracer));
        return Measurement(study, options, std::move(scene), std::move(withFovea), std::move(bare), progress);
    }

    Result<MotionReport> run() {
        MACULA_TRY(fovea_, image::foveaMask({.sizePx = options_.sizePx,
                                             .verticalFovDeg = options_.verticalFovDeg,
                                             .fieldDeg = trace::kFovealFieldDeg}));
        const Box seenMm = scene_.traced.seenMm();
        MACULA_TRY(const hybrid::FirstModel model,
                   hybrid::makeFirstModel(study_.device, scene_.tracer, seenMm, options_.model, progress_));
        MACULA_TRY(splats_, model.trainer.snapshot());
        MACULA_TRY(splat::ModelPainter painter, splat::ModelPainter::create(study_.device, splats_));
        painter_.emplace(std::move(painter));
        report_.splats = splats_.size();
        const trace::Settings settings{.bounces = options_.model.bounces};
        MACULA_TRY_VOID(withFovea_.setScene(settings));
        MACULA_TRY_VOID(bare_.setScene(settings));
        MACULA_TRY_VOID(scene_.tracer.setSettings(settings));
        progress_.beginStage(Text("Comparing frames"),
                             kViewpoints.size() * (options_.stepsMm.size() + options_.turnsDeg.size()));
        for (const Viewpoint& viewpoint : kViewpoints) MACULA_TRY_VOID(measureFrom(viewpoint));
        std::size_t best = 0;
        std::size_t fovealBest = 0;
        for (const MovedFrame& f : report_.frames) {
            best += f.reprojected.flip <= std::min(f.pasted.flip, f.splats.flip) ? 1 : 0;
            fovealBest +=
                f.reprojected.fovealFlip <= std::min(f.pasted.fovealFlip, f.splats.fovealFlip) ? 1 : 0;
        }
        report_.best = double(best) / double(report_.frames.size());
        report_.fovealBest = double(fovealBest) / double(report_.frames.size());
        return std::move(report_);
    }

  private:
    Result<void> measureFrom(const Viewpoint& viewpoint) {
        const Camera before =
            cameraFrom(viewpoint, scene_.traced.seenMm(), options_.verticalFovDeg, options_.sizePx);
        MACULA_TRY_VOID(traceFovea(before));
        for (const double mm : options_.stepsMm)
            MACULA_TRY_VOID(
                measureMove(before, {.moved = Moved::step, .amount = mm, .from = viewpoint.name}));
        for (const double degrees : options_.turnsDeg)
            MACULA_TRY_VOID(
                measureMove(before, {.moved = Moved::turn, .amount = degrees, .from = viewpoint.name}));
        return {};
    }

    Result<void> traceFovea(const Camera& camera) {
        const int sidePx = foveaSidePx(options_.sizePx, options_.verticalFovDeg);
        const trace::View whole{.camera = camera, .width = options_.sizePx.x, .height = options_.sizePx.y};
        Watch watch;
        MACULA_TRY_VOID(
            withFovea_.aim({.whole = whole, .sidePx = sidePx, .samplesPerPixel = options_.foveaSamples}));
        MACULA_TRY_VOID(evaluate::traceFovea(withFovea_, progress_));
        report_.foveaMs = watch.lap().wallMs;
        return {};
    }

    Result<void> measureMove(const Camera& before, MovedFrame frame) {
        const Camera now = movedCamera(before, frame.moved, frame.amount);
        MACULA_TRY(const Truth truth, traceTruth(now));
        MACULA_TRY(const Shown splats, drawnBy(bare_, now, now));
        MACULA_TRY(const Shown reprojected, drawnBy(withFovea_, now, now));
        MACULA_TRY(const Shown pasted, drawnBy(withFovea_, before, now));
        frame.drawMs = reprojected.drawMs;
        frame.splatsDrawMs = splats.drawMs;
        MACULA_TRY(frame.splats, scoreOf(splats, splats, truth));
        MACULA_TRY(frame.reprojected, scoreOf(reprojected, splats, truth));
        MACULA_TRY(frame.pasted, scoreOf(pasted, splats, truth));
        const std::string name = fmt::format("{}-{}-{:g}", frame.from, nameOf(frame.moved), frame.amount);
        MACULA_TRY_VOID(keep(name + "-splats", splats.overBlack));
        MACULA_TRY_VOID(keep(name + "-reprojected", reprojected.overBlack));
        MACULA_TRY_VOID(keep(name + "-pasted", pasted.overBlack));
        MACULA_TRY_VOID(keep(name + "-traced", truth.image));
        report_.frames.push_back(frame);
        progress_.advance();
        return progress_.cancelled() ? Result<void>(cancelledError()) : Result<void>();
    }

    Result<Truth> traceTruth(const Camera& now) {
        const glm::ivec2 size = options_.sizePx;
        MACULA_TRY_VOID(scene_.tracer.setView({.camera = now, .width = size.x, .height = size.y}));
        MACULA_TRY(const bool isWhole,
                   scene_.tracer.trace(options_.truthSamples, [&] { return !progress_.cancelled(); }));
        if (!isWhole) return cancelledError();
        MACULA_TRY(const trace::TracedImage traced, scene_.tracer.readback());
        MACULA_TRY(const gpu::Image* shown, scene_.tracer.display(glm::vec3(0.0f)));
        MACULA_TRY(const auto rgba, gpu::read<std::uint8_t>(*shown));
        std::vector<float> coverage;
        coverage.reserve(traced.radiance.size());
        for (const glm::vec4& pixel : traced.radiance) coverage.push_back(pixel.w);
        Truth truth{.image = imageOf(rgba, size),
                    .isOpaque = std::vector<bool>(traced.radiance.size(), false),
                    .silhouette = image::silhouetteMask(coverage, size.x, size.y)};
        for (std::size_t i = 0; i < fovea_.size(); ++i)
            if (fovea_[i] == 0) truth.silhouette[i] = 0;
        for (int y = 1; y + 1 < size.y; ++y) {
            for (int x = 1; x + 1 < size.x; ++x) {
                bool isOpaque = true;
                for (int k = 0; k < 9; ++k)
                    isOpaque =
                        isOpaque && traced.radiance[indexOf(x + k % 3 - 1, y + k / 3 - 1)].w >= kOpaque;
                truth.isOpaque[indexOf(x, y)] = isOpaque;
            }
        }
        return truth;
    }

    std::size_t indexOf(int x, int y) const {
        return std::size_t(y) * std::size_t(options_.sizePx.x) + std::size_t(x);
    }

    // A drawn frame, with the weights of its fovea; these are empty without one.
    struct Shown {
        image::Image overBlack;
        image::Image overWhite;
        std::vector<float> weights;
        double drawMs = 0.0;
    };

    // Draws splats for the eye `now`, and the fovea for `foveaFor`.
    Result<Shown> drawnBy(hybrid::HybridFrame& frame, const Camera& foveaFor, const Camera& now) {
        const hybrid::Periphery periphery = peripheryFor(*painter_, splats_.originMm, foveaFor, now);
        Shown shown;
        const auto draw = [&](float background) -> Result<image::Image> {
            Watch watch;
            MACULA_TRY(const hybrid::Frame drawn,
                       frame.draw({.eyes = {foveaFor},
                                   .sizePx = options_.sizePx,
                                   .display = {.background = glm::vec3(background), .exposure = 1.0f}},
                                  periphery));
            MACULA_TRY(const auto rgba, gpu::read<std::uint8_t>(*drawn.pictures.front()));
            shown.drawMs = watch.lap().wallMs;
            MACULA_TRY(shown.weights, foveaWeightsOf(drawn, options_.sizePx));
            return imageOf(rgba, options_.sizePx);
        };
        MACULA_TRY(shown.overWhite, draw(1.0f));
        MACULA_TRY(shown.overBlack, draw(0.0f));
        return shown;
    }

    Result<FrameScore> scoreOf(const Shown& shown, const Shown& splats, const Truth& truth) const {
        FrameScore score;
        for (std::size_t i = 0; i < truth.isOpaque.size(); ++i) {
            const std::size_t green = 3 * i + 1;
            const bool showsThrough =
                shown.overWhite.pixels[green] - shown.overBlack.pixels[green] > kBackgroundShows;
            score.through += truth.isOpaque[i] && showsThrough ? 1 : 0;
        }
        if (!shown.weights.empty()) {
            MACULA_TRY(score.seam, image::seamVisibility(truth.image, shown.overBlack, shown.weights));
            MACULA_TRY(score.mixed,
                       image::edgeVisibility(truth.image, shown.overBlack, image::mixedMask(shown.weights)));
        }
        MACULA_TRY(score.silhouette, image::edgeVisibility(truth.image, shown.overBlack, truth.silhouette));
        MACULA_TRY(score.darker, image::darkerThanBoth(shown.overBlack, truth.image, splats.overBlack, fovea_,
                                                       FrameScore::kDarkerBy));
        MACULA_TRY(const image::Flip flip, image::flip(truth.image, shown.overBlack));
        score.flip = flip.mean;
        MACULA_TRY(const auto fovealFlip, image::meanOf(flip.perPixel, fovea_));
        score.fovealFlip = fovealFlip.value_or(0.0);
        return score;
    }

    Result<void> keep(const std::string& name, const image::Image& picture) const {
        if (options_.pictures.empty()) return {};
        return writePng(options_.pictures / (name + ".png"), picture);
    }

    const BenchStudy& study_;
    const MotionOptions& options_;
    live::SceneOnDevice scene_;
    hybrid::HybridFrame withFovea_;
    hybrid::HybridFrame bare_;
    splat::Splats splats_;
    std::optional<splat::ModelPainter> painter_;
    image::Mask fovea_;  // in the middle of every frame
    MotionReport report_;
    Progress& progress_;
};

}  // namespace

std::string_view nameOf(Moved moved) {
    switch (moved) {
        case Moved::step:
            return "step";
        case Moved::turn:
            return "turn";
    }
    return {};
}

Result<MotionReport> measureMotion(const BenchStudy& study, const MotionOptions& options,
                                   Progress& progress) {
    MACULA_TRY_VOID(scene::checkPatientLights(study.environment, study.lights));
    MACULA_TRY(Measurement measurement, Measurement::create(study, options, progress));
    return measurement.run();
}

}  // namespace macula::evaluate
