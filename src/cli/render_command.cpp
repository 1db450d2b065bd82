// macula render PATH -o FILE: one picture, without a window.
#include <CLI/App.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "app/camera/camera_file.h"
#include "app/choice/clip_choice.h"
#include "app/choice/lights_choice.h"
#include "app/elapsed.h"
#include "app/frame/projection_windows.h"
#include "app/open_device.h"
#include "app/output/output_files.h"
#include "app/picture/drawn_picture.h"
#include "app/picture/picture_file.h"
#include "app/picture/render_record.h"
#include "app/study/shown_clip.h"
#include "app/study/study_input.h"
#include "app/study/study_preset.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/output_options.h"
#include "cli/render_options.h"
#include "cli/report.h"
#include "cli/typed_values.h"
#include "pipeline/volume/window.h"

namespace macula::cli {

namespace {

// Nothing: one that what is seen fills.
Result<std::optional<Camera>> givenCamera(const RenderOptions& options) {
    if (options.camera.empty()) return std::optional<Camera>();
    MACULA_TRY(Camera camera, app::readCamera(options.camera));
    if (options.fovDeg > 0.0) camera.verticalFovDeg = options.fovDeg;
    return std::optional(camera);
}

Result<void> checkFiles(const RenderOptions& options) {
    MACULA_TRY_VOID(app::checkPictureName(options.output));
    app::OutputFiles files(options.overwrite);
    for (const std::filesystem::path& input :
         {options.path, std::filesystem::path(options.preset), options.camera,
          std::filesystem::path(options.effort.quality), std::filesystem::path(options.lights),
          std::filesystem::path(options.clip)})
        files.read(input);
    MACULA_TRY_VOID(files.write(options.output));
    return files.write(options.json);
}

// Of what was given, and not of what a quality or a default says.
std::vector<std::string> optionsWithoutEffect(const RenderOptions& options) {
    const trace::Settings usual;
    const trace::Settings& given = options.settings;
    const bool isTraced = trace::isPathTraced(given.look);
    std::vector<std::string> notes;
    const auto check = [&](bool isGiven, const char* option, const std::string& of) {
        if (isGiven) notes.push_back(fmt::format("{} does nothing in this look: it is of {}.", option, of));
    };
    check(!options.window.empty() && !isProjection(given.look), "--window", looksListed(trace::isProjection));
    check(options.effort.bounces && !isTraced, "--bounces", "cinematic");
    check(given.shading != usual.shading && given.look != trace::Look::dvr, "--shading", "dvr");
    const std::string traced = looksListed(trace::isPathTraced);
    check(!options.lights.empty() && !isTraced, "--lights", traced);
    check(given.lightRotationDeg != usual.lightRotationDeg && !isTraced, "--light-rotation", traced);
    check(given.lightStrength != usual.lightStrength && !isTraced, "--light-strength", traced);
    check(given.exposure != usual.exposure && isProjection(given.look), "--exposure", "all but projections");
    if (options.effort.denoise.value_or(false) && !isTraced)
        notes.emplace_back("This look is never denoised: --denoise does nothing.");
    if (options.keepUnfinished && options.effort.error <= 0.0)
        notes.emplace_back(
            "--keep-unfinished does nothing without --error: nothing is written when stopped.");
    return notes;
}

// What of the values projections show: what was asked for; or the range of a preset that was asked for,
// fitted as the preset is; else as in the window.
Result<std::optional<DisplayWindow>> projectionWindow(const RenderOptions& options,
                                                      const TransferFunction& preset, const Volume& volume) {
    if (!isProjection(options.settings.look)) return std::optional<DisplayWindow>();
    if (!options.window.empty()) {
        MACULA_TRY(const DisplayWindow window, parseWindow(options.window));
        return std::optional(window);
    }
    std::optional<DisplayWindow> window;
    if (!options.preset.empty()) window = presetWindow(preset, volume);
    return window ? window : std::optional(app::SeriesWindows().of(options.settings.look, volume));
}

// All that can be wrong on the command line, the study not yet read.
Result<app::PictureRequest> requested(const RenderOptions& options, const std::string& lights) {
    MACULA_TRY_VOID(checkFiles(options));
    app::PictureRequest request{.scene = {}, .from = options.view, .keepUnfinished = options.keepUnfinished};
    MACULA_TRY(request.sizePx, parseSize(options.size));
    MACULA_TRY(app::Effort effort, app::effortOf(options.effort, options.settings));
    request.samplesPerPixel = effort.samplesPerPixel;
    request.settings = std::move(effort.settings);
    MACULA_TRY(request.scene.environment, app::chooseLights(lights));
    if (!options.window.empty()) MACULA_TRY_VOID(parseWindow(options.window));
    if (!options.preset.empty()) MACULA_TRY_VOID(app::presetToDraw(options.preset, options.fit));
    MACULA_TRY(request.camera, givenCamera(options));
    if (options.fovDeg > 0.0) request.verticalFovDeg = options.fovDeg;
    request.isLinear = app::isExr(options.output);
    request.memory = options.memory;
    return request;
}

Result<void> render(const RenderOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    // All that can be wrong on the command line first, then the device, then the study: the slowest comes
    // last.
    const std::string lights =
        options.lights.empty() ? std::string(app::defaultLightsFor(options.settings.look)) : options.lights;
    MACULA_TRY(app::PictureRequest request, requested(options, lights));
    MACULA_TRY(const ClipPreset clip, app::chooseClip(options.clip));
    MACULA_TRY(gpu::LastingDevice device, app::openDevice(options.device, printNote));

    Progress progress(terminalProgressBar(), interruptToken());
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY(app::StudyInput study, app::loadStudy(options.path, options.series, progress, 0, options.how));
    bringTo16Bits(study);
    app::RenderRecord record{.seriesDigest = study.seriesDigest,
                             .lights = app::publicLightsName(lights),
                             .clip = app::publicClipName(options.clip),
                             .loadSeconds = app::secondsSince(start)};
    MACULA_TRY(app::StudyPreset preset, app::choosePresetFor(study, options.preset, options.fit));
    printNotes(study.notes, study.warnings);
    record.notes = study.notes;
    const auto tell = [&](const std::string& note) {
        printNote(note);
        record.notes.push_back(note);
    };
    for (const std::string& note : optionsWithoutEffect(options)) tell(note);
    record.preset = preset.publicName;
    record.presetFitted = preset.function.fitToVolume.has_value();
    MACULA_TRY(record.window, projectionWindow(options, preset.function, *study.volume));

    MACULA_TRY(app::ShownClip shown, app::shownClip(clip, options.removeTable, *study.volume, progress));
    for (const std::string& note : shown.notes) tell(note);
    record.tableRemoved = shown.tableRemoved;
    request.scene.volume = study.volume;
    request.scene.function = std::move(preset.function);
    request.scene.clip = std::move(shown.clip);
    request.settings.window = record.window;

    app::DrawnPicture drawn;
    MACULA_TRY_VOID(device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(drawn, app::drawPicture(on, request, progress));
        return {};
    }));
    record.add(request, drawn);
    for (const app::PictureNote& note : notesOf(drawn, request)) {
        const std::string line = note.action.empty() ? note.sentence : note.sentence + " " + note.action;
        note.isWarning ? printWarning(line) : printNote(line);
    }
    MACULA_TRY_VOID(app::writePicture(options.output, drawn, request.sizePx, metadata(record)));
    if (!options.json.empty()) MACULA_TRY_VOID(printOrWrite(options.json, jsonText(toJson(record))));
    printWritten(options.output, begin);
    if (progress.cancelled() && !drawn.statistics.converged && options.effort.error > 0.0)
        return Error{
            ErrorCode::cancelled, "Stopped; the picture is written as it was then, with noise.", {}, {}};
    return {};
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    auto options = std::make_shared<RenderOptions>();
    auto* command = app.add_subcommand("render", "Draw a series to a picture");
    addRenderOptions(*command, *options);
    command->callback([options, &action] { action = [options] { return render(*options); }; });
}

}  // namespace macula::cli
