#include "pictures/recorded_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "base/atomic_file.h"
#include "image/image_file.h"
#include "image/masked_metrics.h"
#include "live/frame/frame_json.h"
#include "live/frame/times_report.h"
#include "live/store/model_keeper.h"
#include "pictures/output_files.h"
#include "scene/camera/camera_file.h"
#include "scene/choice/catalogue.h"
#include "scene/choice/typed_values.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/projection_windows.h"
#include "scene/drawing/shown_clip.h"
#include "study/open/read_study.h"
#include "study/open/study_input.h"

namespace macula::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFramesFile = "frames.jsonl";
constexpr const char* kTimesFile = "times.json";

// Whether it can be made, or is there and empty. Before the study is read, which takes time.
Result<void> checkFolder(const RecordingWish& wish) {
    OutputFiles files(false);
    for (const fs::path& input : filesOf(wish.state)) files.read(input);
    for (const fs::path& input : filesOf(wish.additions)) files.read(input);
    for (const fs::path& input : {wish.path, wish.cameraPath}) files.read(input);
    std::error_code error;
    if (fs::is_directory(wish.folder, error)) {
        if (!fs::is_empty(wish.folder, error) || error)
            return Error{ErrorCode::outputNotWritable, "The folder is not empty.", wish.folder.string(),
                         "Choose another one, or empty it."};
        return files.write(wish.folder / kFramesFile);
    }
    return files.write(wish.folder);
}

// When nothing else is wrong: nothing is left of what could not be read.
Result<void> makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directory(folder, error);
    if (fs::is_directory(folder, error)) return {};
    return Error{ErrorCode::outputNotWritable, "The folder cannot be made.", folder.string(),
                 "Choose another place."};
}

Result<RecordingOptions> optionsOf(const RecordingWish& wish, const std::optional<Camera>& camera) {
    RecordingOptions options = wish.recording;
    options.from = wish.state.view;
    options.isParallel = wish.state.isParallel;
    MACULA_TRY(options.sizePx, parseSize(wish.size));
    if (!wish.cameraPath.empty()) {
        MACULA_TRY(options.path, readCameraPath(wish.cameraPath));
        if (wish.state.isParallel)
            for (CameraPath::Stop& stop : options.path->stops) stop.camera = inParallel(stop.camera);
    } else if (camera) {
        options.path = options.movingS > 0.0 ? turntable(*camera, options.turnS, options.movingS)
                                             : CameraPath{.stops = {{.atS = 0.0, .camera = *camera}}};
    }
    return options;
}

// All but the study, which is read last.
struct Wished {
    StudyState state;
    AdditionChoice additions;
    Catalogue catalogue;
};

// Each once: as a warning if it is among them, else as a note.
void tell(const std::vector<std::string>& notes, const std::vector<std::string>& warnings, const Hears& note,
          const Hears& warn) {
    for (const std::string& sentence : notes) {
        const bool isWarning = std::ranges::find(warnings, sentence) != warnings.end();
        isWarning ? warn(sentence) : note(sentence);
    }
}

Result<FrameInput> sceneOf(const RecordingWish& wish, Wished wished, const Hears& note, const Hears& warn,
                           Progress& progress) {
    StudyState& state = wished.state;
    const StudyPlace place{wish.path, wish.series, wish.state.presentation, wish.how};
    MACULA_TRY(ReadStudy read, readStudy(place, wished.additions.needsSegmentations(), progress));
    StudyInput& study = read.input;
    bringTo16Bits(study);
    MACULA_TRY_VOID(completeState(state, wish.state, study));
    MACULA_TRY(ShownClip shown, shownClip(state, *study.volume, progress));
    tell(study.notes, study.warnings, note, warn);
    std::ranges::for_each(shown.notes, note);
    MACULA_TRY(MadeAdditions made,
               makeAdditions(wished.additions, read, state.settings.look, shown.clip, progress));
    tell(made.notes, made.warnings, note, warn);
    FrameInput scene;
    scene.volume = study.volume;
    scene.drawing =
        drawingOf(state, wished.catalogue, SeriesWindows(), study.volume,
                  shown.clip.isNothing() ? nullptr : std::make_shared<const Clip>(std::move(shown.clip)));
    if (!made.additions.isNothing())
        setAdditions(scene.drawing, std::make_shared<const Additions>(std::move(made.additions)));
    scene.background = backgroundInWindow(scene.drawing);
    return scene;
}

// Of the drawing, as the report of a picture has it.
nlohmann::ordered_json partsOf(const Drawing& drawing) {
    const auto orNone = [](const std::string& said) { return said.empty() ? "none" : said; };
    const bool isMasked = drawing.clip && drawing.clip->mask;
    return {
        {"masked", orNone(isMasked ? drawing.clip->mask->remark : "")},
        {"additions", orNone(drawing.additions ? remarkOf(*drawing.additions, drawing.settings.look) : "")}};
}

Result<void> write(const fs::path& folder, const Drawing& drawing, const LiveRecording& recording) {
    const nlohmann::ordered_json parts = partsOf(drawing);
    std::string lines;
    std::size_t pictures = 0;
    for (const RecordedFrame& frame : recording.frames) {
        nlohmann::ordered_json line{{"atS", frame.atS}, {"phase", nameOf(frame.phase)}};
        line.update(toJson(frame.shown));
        line.update(parts);
        line["camera"] = toJson(frame.camera);
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

// Small pictures stood where a model would, and with it a fovea, had it learnt for longer.
bool isBeforeModel(const FrameShown& frame) {
    using hybrid::ModelStage;
    const bool isComing =
        frame.model.stage == ModelStage::searching || frame.model.stage == ModelStage::resuming ||
        frame.model.stage == ModelStage::learning || frame.model.stage == ModelStage::resting;
    return isComing && frame.picture == OnScreen::preview && trace::isPathTraced(frame.look) &&
           !isParallel(frame.camera) && !hybrid::isFitToBeShown(frame.model);
}

}  // namespace

Result<LiveRecording> recordStudy(const RecordingWish& wish, const Hears& note, const Hears& warn,
                                  Progress& progress) {
    Wished wished;
    MACULA_TRY(wished.state, stateOf(wish.state));
    MACULA_TRY(wished.additions, additionChoice(wish.additions, wish.path, wished.state));
    MACULA_TRY(RecordingOptions options, optionsOf(wish, wished.state.camera));
    MACULA_TRY(wished.catalogue, builtInCatalogue());
    if (!wish.lights.empty()) {
        MACULA_TRY(wished.state.lights, findLights(wished.catalogue, wish.lights));
    }
    MACULA_TRY_VOID(checkFolder(wish));
    MACULA_TRY(FrameInput scene, sceneOf(wish, std::move(wished), note, warn, progress));
    MACULA_TRY_VOID(makeFolder(wish.folder));
    const Drawing drawing = scene.drawing;
    if (wish.sessions)
        options.keeper = std::make_shared<ModelKeeper>(
            session::StoreOptions{.folder = *wish.sessions},
            [&warn](const Error& error) { warn(error.message + " " + error.hint); });
    MACULA_TRY(LiveRecording recording, recordLive(std::move(scene), options, progress));
    options.keeper.reset();  // what was learnt is saved
    if (recording.isFull) note("Pictures left out: there were too many. Lower --pictures or --size.");
    MACULA_TRY_VOID(write(wish.folder, drawing, recording));
    return recording;
}

nlohmann::ordered_json timesOf(const LiveRecording& recording) {
    auto json = nlohmann::ordered_json::array();
    for (const RecordedTimes& of : recording.times)
        json.push_back({{"phase", nameOf(of.phase)},
                        {"seconds", of.watchedS},
                        {"stages", toJson(of.stages, 1000.0 * of.watchedS)}});
    return json;
}

std::string timesText(const LiveRecording& recording) {
    std::string text;
    for (const auto& of : timesOf(recording))
        text += fmt::format("\n{}, {:.1f} s\n{}", of.at("phase").get<std::string>(),
                            of.at("seconds").get<double>(), tableOf(of.at("stages")));
    return text;
}

MotionFigures motionFigures(const LiveRecording& recording) {
    MotionFigures figures;
    std::vector<double> latenciesMs;
    double firstS = 0.0;
    double lastS = 0.0;
    std::uint64_t lastSequence = 0;
    for (const RecordedFrame& frame : recording.frames) {
        // A view that is shown once more is no new frame that follows the camera.
        if (frame.phase != RecordingPhase::moving || frame.shown.inputSequence == lastSequence) continue;
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

}  // namespace macula::app
