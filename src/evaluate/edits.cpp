#include "evaluate/edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "evaluate/measurement.h"
#include "evaluate/shown_picture.h"
#include "evaluate/viewpoints.h"
#include "image/metrics.h"
#include "live/device/scene_on_device.h"
#include "live/frame/estimated_model.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/volume/volume_fit.h"
#include "pipeline/volume/window.h"
#include "scene/choice/lights_choice.h"
#include "scene/transfer/edited_transfer.h"

namespace macula::evaluate {

namespace {

constexpr double kClipDepths[] = {0.25, 0.5};  // of the box of visible matter
constexpr double kShifts[] = {-0.1, 0.1};      // of the effective range
constexpr int kSmallPixels = 40 * 28;          // of a picture that follows an edit on two cores
constexpr int kDrawnTimes = 3;
constexpr float kOpaque = 0.9f;
constexpr float kClear = 0.1f;

// A picture, and how opaque its pixels are.
struct Shown {
    image::Image image;
    std::vector<float> opacity;
};

// Finds the opacity from the same picture over black and over white.
Shown shownBy(std::span<const std::uint8_t> overBlack, std::span<const std::uint8_t> overWhite,
              const glm::ivec2& sizePx) {
    Shown shown{.image = imageOf(overBlack, sizePx), .opacity = {}};
    for (std::size_t i = 0; i < overBlack.size(); i += 4)
        shown.opacity.push_back(1.0f - float(int(overWhite[i + 1]) - int(overBlack[i + 1])) / 255.0f);
    return shown;
}

class Measurement {
  public:
    Measurement(const BenchStudy& study, const EditsOptions& options, live::SceneOnDevice scene,
                hybrid::HybridFrame frame, Progress& progress)
        : study_(study),
          options_(options),
          scene_(std::move(scene)),
          frame_(std::move(frame)),
          estimated_(study.device),
          progress_(progress) {}

    static Result<Measurement> create(const BenchStudy& study, const EditsOptions& options,
                                      Progress& progress) {
        MACULA_TRY(live::SceneOnDevice scene, study.putOnDevice());
        MACULA_TRY(hybrid::HybridFrame frame, hybrid::HybridFrame::create(study.device, scene.tracer));
        return Measurement(study, options, std::move(scene), std::move(frame), progress);
    }

    Result<EditsReport> run() {
        const Box seenMm = scene_.traced.seenMm();
        camera_ = cameraFrom(kViewpoints.front(), seenMm, options_.verticalFovDeg, options_.sizePx);
        MACULA_TRY(const hybrid::FirstModel model,
                   hybrid::makeFirstModel(study_.device, scene_.tracer, seenMm, options_.model, progress_));
        MACULA_TRY(splat::Splats learnt, model.trainer.snapshot());
        const auto splats = std::make_shared<const splat::Splats>(std::move(learnt));
        base_.transferFunction = std::make_shared<const TransferFunction>(study_.function);
        MACULA_TRY(base_.lights, builtInLights(study_.lights));
        base_.settings = {.bounces = options_.model.bounces};
        estimated_.begin(study_.volume, base_);
        MACULA_TRY_VOID(frame_.setScene(base_.settings));
        MACULA_TRY_VOID(scene_.tracer.setSettings(base_.settings));
        const double scale =
            std::sqrt(double(kSmallPixels) / (double(options_.sizePx.x) * options_.sizePx.y));
        report_.smallPx =
            glm::max(glm::ivec2(glm::round(scale * glm::dvec2(options_.sizePx))), glm::ivec2(1));

        const std::vector<Named> edits = editsOf(seenMm);
        progress_.beginStage(Text("Comparing edits"), edits.size());
        for (const Named& edit : edits) {
            // The first edit is measured before anything has been learnt.
            if (&edit == &edits[1]) estimated_.learnt(study_.volume, base_, splats, 1.0);
            MACULA_TRY_VOID(measure(edit));
            progress_.advance();
            if (progress_.cancelled()) return cancelledError();
        }
        return std::move(report_);
    }

  private:
    struct Named {
        std::string name;
        scene::Drawing drawing;
    };

    std::vector<Named> editsOf(const Box& seenMm) const {
        std::vector<Named> edits{{"opening", base_}, {"none", base_}};
        for (const double depth : kClipDepths) {
            // Anterior is -y: the plane removes what lies in front of it.
            Clip clip;
            clip.planes.push_back({.normal = {0.0, 1.0, 0.0},
                                   .offsetMm = seenMm.low.y + depth * (seenMm.high.y - seenMm.low.y)});
            Named edit{fmt::format("clip {:g}", depth), base_};
            edit.drawing.clip = std::make_shared<const Clip>(std::move(clip));
            edits.push_back(std::move(edit));
        }
        edits.push_back(edits.back());
        edits.back().name += " grey";
        Clip grey = *edits.back().drawing.clip;
        grey.greyFaces = seriesWindow(*study_.volume);
        edits.back().drawing.clip = std::make_shared<const Clip>(std::move(grey));
        const TransferFunction fitted = macula::fitted(study_.function, *study_.volume);
        const ValueRange range = rangeOf(fitted);
        for (const double part : kShifts) {
            const double by = part * (range.high - range.low);
            Named edit{fmt::format("shift {:.0f}", by), base_};
            edit.drawing.transferFunction =
                std::make_shared<const TransferFunction>(scene::shifted(fitted, by));
            edits.push_back(std::move(edit));
        }
        if (study_.then) {
            Named edit{"preset " + study_.then->publicName, base_};
            edit.drawing.transferFunction = std::make_shared<const TransferFunction>(study_.then->function);
            edits.push_back(std::move(edit));
        }
        return edits;
    }

    static ValueRange rangeOf(const TransferFunction& function) {
        if (function.effectiveRange) return *function.effectiveRange;
        return {function.opacity.front().value, function.opacity.back().value};
    }

    Result<void> measure(const Named& named) {
        Edit edit{.name = named.name};
        MACULA_TRY(const Shown estimated, estimate(named.drawing, edit));
        trace::PathTracer& tracer = scene_.tracer;
        MACULA_TRY_VOID(tracer.scene().setClip(named.drawing.clip ? *named.drawing.clip : Clip{}));
        MACULA_TRY_VOID(tracer.scene().setTransferFunction(*named.drawing.transferFunction));
        MACULA_TRY(const Shown traced, trace(options_.sizePx, options_.truthSamples));
        MACULA_TRY(Shown small, trace(report_.smallPx, 1));
        small = scaledUp(small);
        MACULA_TRY(edit.estimated, scoreOf(estimated, traced));
        MACULA_TRY(edit.small, scoreOf(small, traced));
        MACULA_TRY_VOID(keep(named.name, {{"", &estimated}, {"-small", &small}, {"-traced", &traced}}));
        report_.edits.push_back(std::move(edit));
        return {};
    }

    Result<Shown> estimate(const scene::Drawing& drawing, Edit& edit) {
        estimated_.forget();
        if (!estimated_.canTell(study_.volume, drawing))
            return Error{ErrorCode::inputNotUsable, Text("This preset cannot be estimated."), {}, {}};
        Timeline timeline;
        Watch watch;
        {
            const Timeline::Watch stages(timeline);
            MACULA_TRY_VOID(estimated_.make(drawing));
        }
        edit.estimateMs = watch.lap().wallMs;
        edit.stages = timeline.stages();
        edit.splats = estimated_.splatCount();
        MACULA_TRY([[maybe_unused]] const auto compiled, drawn(0.0f));
        watch.lap();
        for (int i = 0; i < kDrawnTimes; ++i) MACULA_TRY_VOID(drawn(0.0f));
        edit.drawMs = watch.lap().wallMs / kDrawnTimes;
        MACULA_TRY(const auto overBlack, drawn(0.0f));
        MACULA_TRY(const auto overWhite, drawn(1.0f));
        return shownBy(overBlack, overWhite, options_.sizePx);
    }

    Result<std::vector<std::uint8_t>> drawn(float background) {
        const hybrid::Periphery periphery{
            .draw = [&](const Camera& eye, const glm::ivec2& sizePx) { return estimated_.draw(eye, sizePx); },
            .gain = float(estimated_.gain()),
            .isLikeness = false};
        MACULA_TRY(const hybrid::Frame frame,
                   frame_.draw({.eyes = {camera_},
                                .sizePx = options_.sizePx,
                                .display = {.background = glm::vec3(background), .exposure = 1.0f}},
                               periphery));
        return gpu::read<std::uint8_t>(*frame.pictures.front());
    }

    Result<Shown> trace(const glm::ivec2& sizePx, std::uint32_t samples) {
        trace::PathTracer& tracer = scene_.tracer;
        trace::Settings settings = base_.settings;
        if (samples == 1) settings.denoising = trace::Denoising::on;
        MACULA_TRY_VOID(tracer.setSettings(settings));
        tracer.forgetViews();
        MACULA_TRY_VOID(tracer.setView({.camera = camera_, .width = sizePx.x, .height = sizePx.y}));
        MACULA_TRY(const bool isWhole, tracer.trace(samples, [&] { return !progress_.cancelled(); }));
        if (!isWhole) return cancelledError();
        MACULA_TRY(const gpu::Image* overBlack, tracer.display(glm::vec3(0.0f)));
        MACULA_TRY(const auto black, gpu::read<std::uint8_t>(*overBlack));
        MACULA_TRY(const gpu::Image* overWhite, tracer.display(glm::vec3(1.0f)));
        MACULA_TRY(const auto white, gpu::read<std::uint8_t>(*overWhite));
        return shownBy(black, white, sizePx);
    }

    Result<void> keep(std::string name,
                      std::initializer_list<std::pair<const char*, const Shown*>> all) const {
        if (options_.pictures.empty()) return {};
        std::replace(name.begin(), name.end(), ' ', '-');
        for (const auto& [suffix, shown] : all)
            MACULA_TRY_VOID(writePng(options_.pictures / (name + suffix + ".png"), shown->image));
        return {};
    }

    Shown scaledUp(const Shown& small) const {
        Shown large{.image = scaledTo(small.image, options_.sizePx), .opacity = {}};
        for (int y = 0; y < options_.sizePx.y; ++y) {
            for (int x = 0; x < options_.sizePx.x; ++x) {
                const int sx = x * report_.smallPx.x / options_.sizePx.x;
                const int sy = y * report_.smallPx.y / options_.sizePx.y;
                large.opacity.push_back(
                    small.opacity[std::size_t(sy) * std::size_t(report_.smallPx.x) + std::size_t(sx)]);
            }
        }
        return large;
    }

    static Result<EditScore> scoreOf(const Shown& shown, const Shown& traced) {
        EditScore score;
        MACULA_TRY(const image::Flip flip, image::flip(traced.image, shown.image));
        score.flip = flip.mean;
        const double each = 1.0 / double(traced.opacity.size());
        for (std::size_t i = 0; i < traced.opacity.size(); ++i) {
            if (traced.opacity[i] > kOpaque && shown.opacity[i] < kClear) score.lacks += each;
            if (traced.opacity[i] < kClear && shown.opacity[i] > kOpaque) score.remains += each;
        }
        return score;
    }

    const BenchStudy& study_;
    const EditsOptions& options_;
    live::SceneOnDevice scene_;
    hybrid::HybridFrame frame_;
    live::EstimatedModel estimated_;
    scene::Drawing base_;
    Camera camera_;
    EditsReport report_;
    Progress& progress_;
};

}  // namespace

Result<EditsReport> measureEdits(const BenchStudy& study, const EditsOptions& options, Progress& progress) {
    MACULA_TRY_VOID(scene::checkPatientLights(study.environment, study.lights));
    if (usesGradientOpacity(study.function) || (study.then && usesGradientOpacity(study.then->function)))
        return Error{ErrorCode::usage,
                     Text("Presets with a gradient opacity are not estimated."),
                     {},
                     Text("Choose another preset.")};
    MACULA_TRY(Measurement measurement, Measurement::create(study, options, progress));
    return measurement.run();
}

}  // namespace macula::evaluate
