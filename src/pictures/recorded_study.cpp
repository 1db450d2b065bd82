#include "pictures/recorded_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "base/atomic_file.h"
#include "image/image_file.h"
#include "image/masked_metrics.h"
#include "live/frame/fidelity.h"
#include "live/frame/times_report.h"
#include "live/store/study_keeper.h"
#include "pictures/output_files.h"
#include "scene/camera/camera_file.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/typed_values.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/projection_windows.h"
#include "scene/drawing/shown_clip.h"
#include "study/open/loaded_study.h"

namespace macula::pictures {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFramesFile = "frames.jsonl";
constexpr const char* kTimesFile = "times.json";

// Checks that the folder can be made, or is empty; before the study is read, which takes time.
Result<void> checkFolder(const RecordingRequest& request) {
    OutputFiles files(false);
    for (const fs::path& input : filesOf(request.state)) files.read(input);
    for (const fs::path& input : filesOf(request.additions)) files.read(input);
    for (const fs::path& input : {request.path, request.cameraPath}) files.read(input);
    std::error_code error;
    if (fs::is_directory(request.folder, error)) {
        if (!fs::is_empty(request.folder, error) || error)
            return Error{ErrorCode::outputNotWritable, Text("The folder is not empty."),
                         request.folder.string(), Text("Choose another one, or empty it.")};
        return files.write(request.folder / kFramesFile);
    }
    return files.write(request.folder);
}

// Only after the study was read, so that a study that cannot be read leaves no folder.
Result<void> makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directory(folder, error);
    if (fs::is_directory(folder, error)) return {};
    return Error{ErrorCode::outputNotWritable, Text("The folder cannot be made."), folder.string(),
                 Text("Choose another place.")};
}

Result<live::RecordingOptions> optionsOf(const RecordingRequest& request,
                                         const std::optional<Camera>& camera) {
    live::RecordingOptions options = request.recording;
    options.from = request.state.view;
    options.isParallel = request.state.isParallel;
    MACULA_TRY(options.sizePx, scene::parseSize(request.size));
    if (!request.cameraPath.empty()) {
        MACULA_TRY(options.path, scene::readCameraPath(request.cameraPath));
        if (request.state.isParallel)
            for (scene::CameraPath::Stop& stop : options.path->stops) stop.camera = inParallel(stop.camera);
    } else if (camera) {
        options.path = options.movingS > 0.0 ? scene::turntable(*camera, options.turnS, options.movingS)
                                             : scene::CameraPath{.stops = {{.atS = 0.0, .camera = *camera}}};
    }
    return options;
}

// The request without the study, which is read last.
struct RequestedStudy {
    scene::StudyState state;
    ResolvedAdditions additions;
    scene::Catalogue catalogue;
};

// Passes each note on once: to `warn` if it is among the warnings, else to `note`.
void tell(const std::vector<Text>& notes, const std::vector<Text>& warnings, const Hears& note,
          const Hears& warn) {
    for (const Text& sentence : notes) {
        const bool isWarning = std::ranges::find(warnings, sentence) != warnings.end();
        isWarning ? warn(sentence) : note(sentence);
    }
}

Result<live::FrameInput> sceneOf(const RecordingRequest& request, RequestedStudy requested, const Hears& note,
                                 const Hears& warn, Progress& progress) {
    scene::StudyState& state = requested.state;
    const study::StudyPlace place{request.path, request.series, request.state.presentation, request.how};
    MACULA_TRY(study::ReadStudy read,
               study::readStudy(place, requested.additions.needsSegmentations(), progress));
    study::LoadedStudy& study = read.input;
    study::bringTo16Bits(study);
    MACULA_TRY_VOID(completeState(state, request.state, study));
    MACULA_TRY(scene::ShownClip shown, scene::shownClip(state, *study.volume, progress));
    tell(study.notes, study.warnings, note, warn);
    std::ranges::for_each(shown.notes, note);
    MACULA_TRY(DrawnAdditions made,
               makeAdditions(requested.additions, read, state.settings.look, shown.clip, progress));
    tell(made.notes, made.warnings, note, warn);
    live::FrameInput scene;
    scene.volume = study.volume;
    scene.drawing = scene::drawingOf(
        state, requested.catalogue, scene::SeriesWindows(), study.volume,
        shown.clip.isNothing() ? nullptr : std::make_shared<const Clip>(std::move(shown.clip)));
    if (!made.additions.isNothing())
        scene::setAdditions(scene.drawing, std::make_shared<const Additions>(std::move(made.additions)));
    scene.background = scene::backgroundInWindow(scene.drawing);
    return scene;
}

// What the drawing hides and adds, as in the record of a picture (render_record.h).
nlohmann::ordered_json partsOf(const scene::Drawing& drawing) {
    const auto orNone = [](const std::string& said) { return said.empty() ? "none" : said; };
    const bool isMasked = drawing.clip && drawing.clip->mask;
    return {{"masked", orNone(isMasked ? drawing.clip->mask->remark.english() : "")},
            {"additions",
             orNone(drawing.additions ? scene::remarkOf(*drawing.additions, drawing.settings.look).english()
                                      : "")}};
}

Result<void> write(const fs::path& folder, const scene::Drawing& drawing,
                   const live::LiveRecording& recording) {
    const nlohmann::ordered_json parts = partsOf(drawing);
    std::string lines;
    std::size_t pictures = 0;
    for (const live::RecordedFrame& frame : recording.frames) {
        nlohmann::ordered_json line{{"atS", frame.atS}, {"phase", nameOf(frame.phase)}};
        line.update(toJson(frame.shown));
        line.update(parts);
        line["camera"] = scene::toJson(frame.camera);
        if (!frame.rgba.empty()) {
            const std::string name = fmt::format("frame-{:04}.png", ++pictures);
            line["file"] = name;
            const auto bytes = std::as_bytes(std::span(frame.rgba));
            MACULA_TRY_VOID(
                image::writePng(folder / name, frame.sizePx.x, frame.sizePx.y,
                                {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}));
        }
        lines += line.dump() + "\n";
    }
    MACULA_TRY_VOID(writeTextAtomically(folder / kFramesFile, lines));
    return writeTextAtomically(folder / kTimesFile, timesOf(recording).dump(4) + "\n");
}

// Whether the frame is a small picture only because the model was not fit to be shown yet.
bool isBeforeModel(const live::FrameShown& frame) {
    using hybrid::ModelStage;
    const bool isComing =
        frame.model.stage == ModelStage::searching || frame.model.stage == ModelStage::resuming ||
        frame.model.stage == ModelStage::learning || frame.model.stage == ModelStage::resting;
    return isComing && frame.picture == live::OnScreen::preview && trace::isPathTraced(frame.look) &&
           !isParallel(frame.camera) && !hybrid::isFitToBeShown(frame.model);
}

}  // namespace

Result<live::LiveRecording> recordStudy(const RecordingRequest& request, const Hears& note, const Hears& warn,
                                        Progress& progress) {
    RequestedStudy requested;
    MACULA_TRY(requested.state, stateOf(request.state));
    MACULA_TRY(requested.additions, resolveAdditions(request.additions, request.path, requested.state));
    MACULA_TRY(live::RecordingOptions options, optionsOf(request, requested.state.camera));
    MACULA_TRY(requested.catalogue, scene::builtInCatalogue());
    if (!request.lights.empty()) {
        MACULA_TRY(requested.state.lights, scene::findLights(requested.catalogue, request.lights));
    }
    MACULA_TRY_VOID(checkFolder(request));
    MACULA_TRY(live::FrameInput scene, sceneOf(request, std::move(requested), note, warn, progress));
    MACULA_TRY_VOID(makeFolder(request.folder));
    const scene::Drawing drawing = scene.drawing;
    if (request.sessions)
        options.keeper = std::make_shared<live::StudyKeeper>(
            session::StoreOptions{.folder = *request.sessions},
            [&warn](const Error& error) { warn(Text("{} {}", error.message, error.hint)); });
    MACULA_TRY(live::LiveRecording recording, live::recordLive(std::move(scene), options, progress));
    options.keeper.reset();  // waits until what was learnt is stored
    if (recording.isFull) note(Text("Pictures left out: there were too many. Lower --pictures or --size."));
    MACULA_TRY_VOID(write(request.folder, drawing, recording));
    return recording;
}

nlohmann::ordered_json timesOf(const live::LiveRecording& recording) {
    auto json = nlohmann::ordered_json::array();
    for (const live::RecordedTimes& of : recording.times)
        json.push_back({{"phase", nameOf(of.phase)},
                        {"seconds", of.watchedS},
                        {"stages", live::toJson(of.stages, 1000.0 * of.watchedS)}});
    return json;
}

std::string timesText(const live::LiveRecording& recording) {
    std::string text;
    for (const auto& of : timesOf(recording))
        text += fmt::format("\n{}, {:.1f} s\n{}", of.at("phase").get<std::string>(),
                            of.at("seconds").get<double>(), live::tableOf(of.at("stages")));
    return text;
}

MotionFigures motionFigures(const live::LiveRecording& recording) {
    MotionFigures figures;
    std::vector<double> latenciesMs;
    double firstS = 0.0;
    double lastS = 0.0;
    std::uint64_t lastSequence = 0;
    for (const live::RecordedFrame& frame : recording.frames) {
        // A view that is shown again is not a new frame.
        if (frame.phase != live::RecordingPhase::moving || frame.shown.inputSequence == lastSequence)
            continue;
        lastSequence = frame.shown.inputSequence;
        if (latenciesMs.empty()) firstS = frame.atS;
        lastS = frame.atS;
        latenciesMs.push_back(frame.shown.latencyMs);
        if (frame.shown.foveaAgeMs) ++figures.withFovea;
        if (isBeforeModel(frame.shown)) ++figures.beforeModel;
    }
    figures.frames = latenciesMs.size();
    if (latenciesMs.empty()) return figures;
    if (lastS > firstS) figures.framesPerSecond = double(figures.frames - 1) / (lastS - firstS);
    figures.latencyMs = image::percentile(latenciesMs, 0.5);
    figures.lateMs = image::percentile(latenciesMs, 0.95);
    return figures;
}

std::string textOf(const MotionFigures& figures) {
    if (figures.frames == 0) return "No frame followed the camera.";
    const bool isTooEarly = figures.withFovea == 0 && figures.beforeModel > 0;
    return fmt::format(
        "In motion {:.1f} frames/s, {:.0f} ms from pose to picture (95 % below {:.0f} ms), {} of {} with a "
        "fovea.{}",
        figures.framesPerSecond, figures.latencyMs, figures.lateMs, figures.withFovea, figures.frames,
        isTooEarly ? " The model was not sharp enough to be shown: give it longer by --learn." : "");
}

}  // namespace macula::pictures
