#include "evaluate/live_picture.h"

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "evaluate/frame_scores.h"
#include "evaluate/measurement.h"
#include "evaluate/shown_picture.h"
#include "image/metrics.h"
#include "pipeline/hybrid/views/truth_pictures.h"
#include "pipeline/splat/draw/displayed.h"
#include "pipeline/trace/device_scene.h"

namespace macula::evaluate {

namespace {

// All but the camera, which the recording moves.
Result<live::FrameInput> sceneOf(const BenchStudy& study) {
    live::FrameInput scene;
    scene.volume = study.volume;
    MACULA_TRY(scene.drawing, drawingOf(study));
    scene.background = glm::vec3(0.0f);  // as in frameTruthOf
    return scene;
}

image::Image shownIn(const live::RecordedFrame& frame, const glm::ivec2& sizePx) {
    const auto bytes = std::as_bytes(std::span(frame.rgba));
    image::Image image =
        imageOf({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, frame.sizePx);
    return frame.sizePx == sizePx ? image : scaledTo(image, sizePx);  // as a window does
}

class Measurement {
  public:
    Measurement(const BenchStudy& study, const LivePictureOptions& options, Progress& progress)
        : study_(study),
          options_(options),
          sizePx_(study.view.width, study.view.height),
          progress_(progress) {}

    Result<LivePictureReport> run() {
        MACULA_TRY(const live::FrameInput scene, sceneOf(study_));
        settings_ = scene.drawing.settings;
        // Fails before the recording, not after it, if nothing can be seen.
        MACULA_TRY(const hybrid::TracedScene first, sceneWith(study_.function));
        std::optional<hybrid::TracedScene> second;
        if (study_.then) {
            MACULA_TRY(second, sceneWith(study_.then->function));
        }
        MACULA_TRY(recording_, live::recordLive(scene, recordingOf(scene.drawing), progress_));
        LivePictureReport report{.motion = pictures::motionFigures(recording_),
                                 .firstModelS = firstModelS(recording_),
                                 .bounces = settings_.bounces,
                                 .isFull = recording_.isFull};
        MACULA_TRY(trace::PathTracer tracer, study_.makeTracer());
        MACULA_TRY(report.rest, compare(live::RecordingPhase::resting, first, tracer));
        if (second) {
            MACULA_TRY_VOID(tracer.scene().setTransferFunction(study_.then->function));
            MACULA_TRY(RestCourse rest, compare(live::RecordingPhase::changed, *second, tracer));
            report.change = {.preset = study_.then->publicName,
                             .times = *changeTimes(recording_),
                             .rest = std::move(rest)};
        }
        return report;
    }

  private:
    Result<hybrid::TracedScene> sceneWith(const TransferFunction& function) const {
        return live::visibleScene(
            {.volume = study_.volume, .function = function, .clip = {}, .environment = study_.environment});
    }

    live::RecordingOptions recordingOf(const scene::Drawing& drawing) const {
        live::RecordingOptions recording = options_.recording;
        recording.sizePx = sizePx_;
        if (study_.then) {
            recording.thenDrawing = drawing;
            recording.thenDrawing->transferFunction =
                std::make_shared<const TransferFunction>(study_.then->function);
        }
        return recording;
    }

    // Compares the kept pictures of the phase with a reference from where the camera stopped.
    Result<RestCourse> compare(live::RecordingPhase phase, const hybrid::TracedScene& scene,
                               trace::PathTracer& tracer) {
        const hybrid::TruthOptions wanted{.sizePx = sizePx_,
                                          .samplesPerPixel = options_.truthSamples,
                                          .bounces = settings_.bounces,
                                          .exposure = settings_.exposure};
        const Camera& camera = recording_.inputs.back().camera;
        MACULA_TRY(const std::vector<hybrid::TruthPicture> traced,
                   hybrid::truthPictures(tracer, scene, std::span(&camera, 1), wanted,
                                         hybrid::PictureCache({}), progress_));
        const FrameTruth truth = frameTruthOf(traced.front());
        RestCourse course;
        MACULA_TRY(course.referenceFlip, flipOfHalf(traced.front(), truth));
        const double startS = *beginS(recording_, phase);
        progress_.beginStage(Text("Comparing pictures"), recording_.frames.size());
        for (const live::RecordedFrame& frame : recording_.frames) {
            if (progress_.cancelled()) return cancelledError();
            progress_.advance();
            if (frame.phase != phase || frame.rgba.empty()) continue;
            MACULA_TRY(const RestPicture picture, scoreOf(frame, frame.atS - startS, truth));
            course.pictures.push_back(picture);
        }
        return course;
    }

    Result<double> flipOfHalf(const hybrid::TruthPicture& traced, const FrameTruth& truth) const {
        const auto half = splat::displayed(traced.halves[0].rgba, splat::ColourSpace::linear, {});
        MACULA_TRY(const image::Flip flip, image::flip(truth.shown, imageOf(half, sizePx_)));
        return flip.mean;
    }

    Result<RestPicture> scoreOf(const live::RecordedFrame& frame, double atS, const FrameTruth& truth) const {
        const image::Image shown = shownIn(frame, sizePx_);
        MACULA_TRY(const image::Flip flip, image::flip(truth.shown, shown));
        RestPicture picture{.atS = atS,
                            .picture = frame.shown.picture,
                            .samplesPerPixel = frame.shown.samplesPerPixel,
                            .flip = flip.mean};
        MACULA_TRY(picture.maskedPsnrDb, image::maskedPsnr(truth.shown, shown, truth.covered));
        if (picture.maskedPsnrDb && !std::isfinite(*picture.maskedPsnrDb)) picture.maskedPsnrDb.reset();
        return picture;
    }

    const BenchStudy& study_;
    const LivePictureOptions& options_;
    const glm::ivec2 sizePx_;
    Progress& progress_;
    trace::Settings settings_;  // of both drawings
    live::LiveRecording recording_;
};

}  // namespace

Result<void> check(const BenchStudyOptions& study, const LivePictureOptions& options) {
    for (const std::string& preset : {study.preset, study.thenPreset}) {
        if (!preset.empty()) MACULA_TRY_VOID(scene::presetToDraw(preset, false));
    }
    MACULA_TRY_VOID(builtInLights(study.lights));
    if (options.truthSamples % 2 != 0)
        return Error{ErrorCode::usage,
                     Text("What is compared with is traced in two halves."),
                     {},
                     Text("Give --truth-spp an even number.")};
    return {};
}

Result<LivePictureReport> measureLivePicture(const BenchStudy& study, const LivePictureOptions& options,
                                             Progress& progress) {
    Measurement measurement(study, options, progress);
    return measurement.run();
}

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const pictures::MotionFigures& motion) {
    const auto ms = [&](double value) { return motion.frames > 0 ? Json(value) : Json(); };
    return {{"frames", motion.frames},
            {"framesWithFovea", motion.withFovea},
            {"framesPerSecond", motion.framesPerSecond},
            {"latencyMs", {{"median", ms(motion.latencyMs)}, {"p95", ms(motion.lateMs)}}}};
}

Json toJson(const RestPicture& picture) {
    return {{"atS", picture.atS},
            {"picture", nameOf(picture.picture)},
            {"samplesPerPixel", picture.samplesPerPixel > 0 ? Json(picture.samplesPerPixel) : Json()},
            {"flip", picture.flip},
            {"maskedPsnrDb", orNull(picture.maskedPsnrDb)}};
}

Json toJson(const RestCourse& rest) {
    Json series = Json::array();
    for (const RestPicture& picture : rest.pictures) series.push_back(toJson(picture));
    return {{"toFlip002S", orNull(nearFromS(rest.pictures))},
            {"lastFlip", rest.pictures.empty() ? Json() : Json(rest.pictures.back().flip)},
            {"referenceFlip", rest.referenceFlip},
            {"worstSetback", orNull(worstSetback(rest.pictures))},
            {"worstRise", orNull(worstRise(rest.pictures))},
            {"series", std::move(series)}};
}

Json toJson(const PresetChange& change) {
    return {{"preset", change.preset},
            {"firstNewS", orNull(change.times.firstNewS)},
            {"firstFullS", orNull(change.times.firstFullS)},
            {"stale", {{"longestMs", 1e3 * change.times.longestStaleS}, {"wasSaid", change.times.wasSaid}}},
            {"rest", toJson(change.rest)}};
}

}  // namespace

Json toJson(const LivePictureReport& report) {
    return {{"motion", toJson(report.motion)},
            {"firstModelS", orNull(report.firstModelS)},
            {"rest", toJson(report.rest)},
            {"change", report.change ? toJson(*report.change) : Json()},
            {"picturesLeftOut", report.isFull}};
}

Json reportOf(const BenchStudy& study, const LivePictureOptions& options, const LivePictureReport& report) {
    const live::RecordingOptions& recording = options.recording;
    Json json = describe("live-picture", study);
    json["bounces"] = report.bounces;
    json["truthSamplesPerPixel"] = options.truthSamples;
    json["turnS"] = recording.turnS;
    json["movingS"] = recording.movingS;
    json["learningS"] = recording.learningS;
    json["restingS"] = recording.restingS;
    json["picturesPerS"] = recording.picturesPerS;
    json.update(toJson(report));
    return json;
}

}  // namespace macula::evaluate
