// macula render PATH -o FILE: one picture, without a window.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "app/camera/camera_file.h"
#include "app/camera/view_directions.h"
#include "app/choice/clip_choice.h"
#include "app/choice/lights_choice.h"
#include "app/choice/nearest_name.h"
#include "app/choice/quality_choice.h"
#include "app/open_device.h"
#include "app/study/nothing_visible.h"
#include "app/study/shown_clip.h"
#include "app/study/study_input.h"
#include "app/study/study_preset.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/name_option.h"
#include "cli/number_range.h"
#include "cli/output_file.h"
#include "cli/picture_size.h"
#include "cli/render_statistics.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/trace/scene.h"
#include "pipeline/volume/volume_fit.h"
#include "pipeline/volume/window.h"

namespace macula::cli {

namespace {

struct Options {
    std::filesystem::path path;
    std::filesystem::path output;
    std::string series;
    std::string preset;
    bool fit = false;
    ViewDirection view = ViewDirection::anterior;
    std::filesystem::path camera;
    double fovDeg = 0.0;  // 0: not given
    std::string size = "768x768";
    std::string quality;
    std::optional<std::uint32_t> samplesPerPixel;  // what is given itself counts more than the quality
    double error = 0.0;                            // 0: not given
    std::optional<int> bounces;
    std::optional<bool> denoise;
    std::string window;
    trace::Settings settings;
    trace::MemoryLimits memory;
    std::string lights;  // empty: not given
    std::string clip;
    bool removeTable = false;
    dicom::ScanOptions how;
    std::string device;
    std::filesystem::path statistics;
    bool overwrite = false;
    bool keepUnfinished = false;
};

constexpr double kDefaultFovDeg = 30.0;
const glm::vec3 kBackground(0.0f);
constexpr std::uint32_t kMostSamples = 1 << 20;

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Centre and width, as DICOM has them but exactly: black at centre - width / 2, white at centre + width / 2.
Result<DisplayWindow> parseWindow(const std::string& text) {
    DisplayWindow window{.center = 0.0, .width = 0.0, .explanation = {}, .function = "LINEAR_EXACT"};
    int used = 0;
    const bool read = std::sscanf(text.c_str(), "%lf,%lf%n", &window.center, &window.width, &used) == 2 &&
                      used == static_cast<int>(text.size());
    if (!read || !std::isfinite(window.center) || !(window.width > 0.0) || !std::isfinite(window.width)) {
        return Error{ErrorCode::usage, "The window is not usable.", text,
                     "Give --window as CENTRE,WIDTH in units of the series, the width above 0."};
    }
    return window;
}

// What of the values projections show: what was asked for; or the range of a preset that was asked for,
// fitted as the preset is; else what the series says, for MIP only if that is not mostly white.
Result<std::optional<DisplayWindow>> chooseWindow(const Options& options, const TransferFunction& preset,
                                                  const Volume& volume) {
    if (!options.window.empty()) {
        MACULA_TRY(const DisplayWindow window, parseWindow(options.window));
        return std::optional(window);
    }
    if (!options.preset.empty()) return presetWindow(preset, volume);
    if (options.settings.look == trace::Look::mip) return std::optional(maximumWindow(volume));
    return std::optional<DisplayWindow>();
}

// Soft light from everywhere shows shape by shadow alone, and nothing glares: that is the clear look.
std::string lightsOf(const Options& options) {
    if (!options.lights.empty()) return options.lights;
    return options.settings.look == trace::Look::clear ? "even" : app::kDefaultLights;
}

// Nothing: one that what is seen fills.
Result<std::optional<Camera>> givenCamera(const Options& options) {
    if (options.camera.empty()) return std::optional<Camera>();
    MACULA_TRY(Camera camera, app::readCamera(options.camera));
    if (options.fovDeg > 0.0) camera.verticalFovDeg = options.fovDeg;
    return std::optional(camera);
}

Result<Camera> fittedCamera(const Options& options, const trace::PathTracer& tracer, const Volume& volume,
                            const glm::ivec2& size) {
    MACULA_TRY(std::vector<glm::dvec3> outline, tracer.outlineMm());
    if (isProjection(options.settings.look) || outline.empty()) {
        const auto corners = cornersOf(volume.worldBox());
        outline.assign(corners.begin(), corners.end());
    }
    return framePoints(outline, standardBasis(options.view),
                       options.fovDeg > 0.0 ? options.fovDeg : kDefaultFovDeg, double(size.x) / size.y);
}

Result<void> traceAll(trace::PathTracer& tracer, std::uint32_t samplesPerPixel, Progress& progress) {
    // Small portions, so that progress moves and Ctrl-C is quick.
    const std::uint32_t portion = std::clamp<std::uint32_t>(samplesPerPixel / 64, 1, 16);
    progress.beginStage("Tracing", samplesPerPixel);
    for (std::uint32_t done = 0; done < samplesPerPixel;) {
        const std::uint32_t count = std::min(portion, samplesPerPixel - done);
        MACULA_TRY(const bool whole, tracer.trace(count, [&] { return !progress.cancelled(); }));
        if (!whole || progress.cancelled()) {
            return Error{ErrorCode::cancelled, "Stopped; nothing was written.", {}, {}};
        }
        done += count;
        progress.advance(count);
    }
    return {};
}

// As many samples as it takes, and where they are needed. Who stops it may want the picture as it is then.
Result<void> traceUntilConverged(trace::PathTracer& tracer, double error, std::uint32_t mostSamples,
                                 bool keepUnfinished, Progress& progress) {
    constexpr double kPortionMs = 200.0;
    constexpr std::size_t kSteps = 1000;
    progress.beginStage("Tracing until the noise is gone", kSteps);
    std::size_t shown = 0;
    for (;;) {
        MACULA_TRY_VOID(tracer.traceFor(kPortionMs, [&] { return !progress.cancelled(); }));
        MACULA_TRY(const trace::Statistics statistics, tracer.statistics());
        if (statistics.converged) return {};
        if (progress.cancelled() && (!keepUnfinished || statistics.samplesPerPixel == 0))
            return Error{ErrorCode::cancelled, "Stopped; nothing was written.", {}, {}};
        if (progress.cancelled() || statistics.meanSamplesPerPixel >= mostSamples) break;
        // Noise falls with the root of the samples.
        const double left = statistics.estimatedError / error;
        const auto done = static_cast<std::size_t>(double(kSteps) / std::max(left * left, 1.0));
        if (done > shown) progress.advance(done - std::exchange(shown, done));
    }
    return {};
}

// What is drawn, and with what.
struct Scene {
    std::shared_ptr<const Volume> volume;
    Clip clip;
    TransferFunction preset;
    trace::Environment environment;
    std::optional<Camera> camera;  // nothing: one that fits
    glm::ivec2 sizePx{0};
    trace::Settings settings;
    std::uint32_t samplesPerPixel = 0;
    bool keepUnfinished = false;  // when it is stopped, where noise is traced away
};

// What the device has made of it, brought to the host: a lost device takes nothing of it along.
struct Drawn {
    std::string device;
    Camera camera;
    double seconds = 0.0;
    trace::Statistics statistics;
    std::vector<std::uint8_t> rgba;            // for the eye, or
    std::optional<trace::TracedImage> traced;  // linear
};

Result<Drawn> draw(const std::shared_ptr<gpu::Device>& device, const Scene& scene, const Options& options,
                   Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    Drawn drawn{.device = gpu::describe(device->info())};
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device, options.memory));
    MACULA_TRY_VOID(tracer.setVolume(scene.volume));
    MACULA_TRY_VOID(tracer.setClip(scene.clip));  // first: what it hides is not uploaded
    MACULA_TRY_VOID(tracer.setTransferFunction(scene.preset));
    MACULA_TRY_VOID(tracer.setEnvironment(scene.environment));
    MACULA_TRY_VOID(tracer.setSettings(scene.settings));
    if (scene.camera) {
        drawn.camera = *scene.camera;
    } else {
        MACULA_TRY(drawn.camera, fittedCamera(options, tracer, *scene.volume, scene.sizePx));
    }
    MACULA_TRY_VOID(
        tracer.setView({.camera = drawn.camera, .width = scene.sizePx.x, .height = scene.sizePx.y}));
    const double error = scene.settings.errorThreshold;
    MACULA_TRY_VOID(error > 0.0 ? traceUntilConverged(tracer, error, scene.samplesPerPixel,
                                                      scene.keepUnfinished, progress)
                                : traceAll(tracer, scene.samplesPerPixel, progress));
    drawn.seconds = secondsSince(start);
    MACULA_TRY_VOID(tracer.estimateError());
    MACULA_TRY(drawn.statistics, tracer.statistics());
    if (isExr(options.output)) {
        MACULA_TRY(drawn.traced, tracer.readback());
    } else {
        MACULA_TRY(drawn.rgba, tracer.readDisplay(kBackground));
    }
    return drawn;
}

// Black, as the background is, or clear.
bool isEmpty(const Drawn& drawn) {
    if (drawn.traced)
        return std::all_of(drawn.traced->radiance.begin(), drawn.traced->radiance.end(),
                           [](const glm::vec4& pixel) { return pixel.w <= 0.0f; });
    for (std::size_t i = 0; i < drawn.rgba.size(); ++i) {
        if (i % 4 != 3 && drawn.rgba[i] != 0) return false;
    }
    return true;
}

Result<void> writePicture(const Drawn& drawn, const Options& options, const RenderRecord& record) {
    if (!drawn.traced)
        return image::writePng(options.output, record.width, record.height, drawn.rgba, metadata(record));
    const trace::TracedImage& traced = *drawn.traced;
    const std::span<const float> rgba(&traced.radiance.front().x, traced.radiance.size() * 4);
    return image::writeExr(options.output, record.width, record.height, rgba, traced.depthMm,
                           metadata(record));
}

// What the options come to.
struct Effort {
    std::uint32_t samplesPerPixel = 64;
    trace::Settings settings;
};
Result<Effort> effortOf(const Options& options) {
    Effort effort{.settings = options.settings};
    // Chance needs many samples; what has none needs a few for smooth edges.
    if (!trace::isPathTraced(options.settings.look)) effort.samplesPerPixel = 8;
    if (!options.quality.empty()) {
        MACULA_TRY(const trace::Quality quality, app::chooseQuality(options.quality));
        effort.samplesPerPixel = quality.samplesPerPixel;
        effort.settings.bounces = quality.bounces;
        effort.settings.filter = quality.filter;
        effort.settings.denoising = quality.denoising;
    }
    effort.samplesPerPixel = options.samplesPerPixel.value_or(effort.samplesPerPixel);
    effort.settings.bounces = options.bounces.value_or(effort.settings.bounces);
    if (options.denoise)
        effort.settings.denoising = *options.denoise ? trace::Denoising::on : trace::Denoising::off;
    effort.settings.errorThreshold = options.error;
    if (options.error > 0.0) effort.samplesPerPixel = options.samplesPerPixel.value_or(kMostSamples);
    return effort;
}

// Of what was given, and not of what a quality or a default says.
std::vector<std::string> optionsWithoutEffect(const Options& options) {
    const trace::Settings usual;
    const trace::Settings& given = options.settings;
    const bool isTraced = trace::isPathTraced(given.look);
    std::vector<std::string> notes;
    const auto check = [&](bool isGiven, const char* option, const char* of) {
        if (isGiven) notes.push_back(fmt::format("{} does nothing in this look: it is of {}.", option, of));
    };
    check(!options.window.empty() && !isProjection(given.look), "--window", "mip, minip and average");
    check(options.bounces && !isTraced, "--bounces", "cinematic");
    check(given.shading != usual.shading && given.look != trace::Look::dvr, "--shading", "dvr");
    check(!options.lights.empty() && !isTraced, "--lights", "cinematic and clear");
    check(given.lightRotationDeg != usual.lightRotationDeg && !isTraced, "--light-rotation",
          "cinematic and clear");
    check(given.lightStrength != usual.lightStrength && !isTraced, "--light-strength", "cinematic and clear");
    check(given.exposure != usual.exposure && isProjection(given.look), "--exposure", "all but projections");
    if (options.denoise.value_or(false) && !isTraced)
        notes.emplace_back("This look is never denoised: --denoise does nothing.");
    if (options.keepUnfinished && options.error <= 0.0)
        notes.emplace_back(
            "--keep-unfinished does nothing without --error: nothing is written when stopped.");
    return notes;
}

Result<void> checkFiles(const Options& options) {
    MACULA_TRY_VOID(checkPictureName(options.output));
    OutputFiles files(options.overwrite);
    for (const std::filesystem::path& input :
         {options.path, std::filesystem::path(options.preset), options.camera,
          std::filesystem::path(options.quality), std::filesystem::path(options.lights),
          std::filesystem::path(options.clip)})
        files.read(input);
    MACULA_TRY_VOID(files.write(options.output));
    return files.write(options.statistics);
}

Result<void> render(const Options& options) {
    const auto begin = std::chrono::steady_clock::now();
    // All that can be wrong on the command line first, then the device, then the study: the slowest comes
    // last.
    MACULA_TRY_VOID(checkFiles(options));
    MACULA_TRY(const glm::ivec2 size, parseSize(options.size));
    MACULA_TRY(const Effort effort, effortOf(options));
    MACULA_TRY(const trace::Environment environment, app::chooseLights(lightsOf(options)));
    if (!options.window.empty()) MACULA_TRY_VOID(parseWindow(options.window));
    if (!options.preset.empty()) MACULA_TRY_VOID(app::presetToDraw(options.preset, options.fit));
    ClipPreset clip;
    if (!options.clip.empty()) {
        MACULA_TRY(clip, app::chooseClip(options.clip));
    }
    MACULA_TRY(const std::optional<Camera> camera, givenCamera(options));
    MACULA_TRY(gpu::LastingDevice device, app::openDevice(options.device, printNote));

    Progress progress(terminalProgressBar(), interruptToken());
    auto start = std::chrono::steady_clock::now();
    MACULA_TRY(app::StudyInput study, app::loadStudy(options.path, options.series, progress, 0, options.how));
    bringTo16Bits(study);
    RenderRecord record;
    record.loadSeconds = secondsSince(start);
    MACULA_TRY(const app::StudyPreset preset, app::choosePresetFor(study, options.preset, options.fit));
    printNotes(study.notes, study.warnings);
    for (std::string& note : optionsWithoutEffect(options)) {
        printNote(note);
        study.notes.push_back(std::move(note));
    }
    record.seriesDigest = study.seriesDigest;
    record.preset = preset.publicName;
    record.lights = app::publicLightsName(lightsOf(options));
    record.clip = app::publicClipName(options.clip);
    record.width = size.x;
    record.height = size.y;
    record.settings = effort.settings;
    MACULA_TRY(record.settings.window, chooseWindow(options, preset.function, *study.volume));
    record.notes = study.notes;
    record.presetFitted = preset.function.fitToVolume.has_value();
    if (isProjection(options.settings.look))
        record.window = record.settings.window.value_or(seriesWindow(*study.volume));

    MACULA_TRY(app::ShownClip shown, app::shownClip(clip, options.removeTable, *study.volume, progress));
    printNotes(shown.notes);
    record.notes.insert(record.notes.end(), shown.notes.begin(), shown.notes.end());
    record.tableRemoved = shown.tableRemoved;
    const Scene scene{.volume = study.volume,
                      .clip = std::move(shown.clip),
                      .preset = preset.function,
                      .environment = environment,
                      .camera = camera,
                      .sizePx = size,
                      .settings = record.settings,
                      .samplesPerPixel = effort.samplesPerPixel,
                      .keepUnfinished = options.keepUnfinished};
    Drawn drawn;
    const auto drawOn = [&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(drawn, draw(on, scene, options, progress));
        return {};
    };
    MACULA_TRY_VOID(device.run(drawOn));
    record.device = drawn.device;
    record.camera = drawn.camera;
    record.traceSeconds = drawn.seconds;
    record.statistics = drawn.statistics;
    if (options.error > 0.0 && !record.statistics.converged) {
        record.notes.emplace_back("The picture is noisier than was asked for.");
        printNote(record.notes.back());
    }
    if (isEmpty(drawn)) {
        record.notes.push_back(app::whyNothingIsVisible(*study.volume));
        printWarning(record.notes.back());
    }
    for (const Message& message : record.statistics.messages) {
        record.notes.push_back(message.sentence);
        printNote(fmt::format("{} {}", message.sentence, message.action));
    }
    if (record.statistics.nonFiniteSamples > 0) {
        record.notes.push_back(fmt::format("{} samples were not finite and were dropped; please report this.",
                                           record.statistics.nonFiniteSamples));
        printNote(record.notes.back());
    }
    if (record.statistics.abandonedSamples > 0) {
        record.notes.push_back(fmt::format("{} light paths were too long for the device and were dropped.",
                                           record.statistics.abandonedSamples));
        printNote(record.notes.back());
    }
    MACULA_TRY_VOID(writePicture(drawn, options, record));
    if (!options.statistics.empty()) MACULA_TRY_VOID(writeStatistics(record, options.statistics));
    printWritten(options.output, begin);
    if (progress.cancelled() && !record.statistics.converged && options.error > 0.0)
        return Error{
            ErrorCode::cancelled, "Stopped; the picture is written as it was then, with noise.", {}, {}};
    return {};
}

std::map<std::string, int> looksByName() {
    std::map<std::string, int> looks;
    for (const trace::LookTraits& look : trace::kLooks) looks.emplace(look.name, static_cast<int>(look.look));
    return looks;
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    Options& o = *options;
    auto* command = app.add_subcommand("render", "Draw a series to a picture");
    command->add_option(
        "PATH", o.path,
        "Folder with DICOM files, volume file (NIfTI, NRRD, MetaImage), or phantom: (default)");
    command
        ->add_option("-o,--output", o.output,
                     "Picture to write: OUT.png for display, OUT.exr for linear light and depth")
        ->required();
    addJoin(*command, o.how);
    command->add_option("--series", o.series,
                        "Place in the list of macula info, or series UID (default: the best)");
    command->add_option(
        "--preset", o.preset,
        "Name or number from macula presets, or preset file (default: by what the series shows)");
    command->add_flag("--fit", o.fit,
                      "Stretch the preset's range to the series, for MR: see docs/presets.md");
    auto* view = command->add_option("--view", o.view, "Where the viewer stands (default: anterior)")
                     ->transform(asViewDirection())
                     ->option_text(kViewDirectionNames);
    command
        ->add_option("--camera", o.camera,
                     "JSON file: positionMm, targetMm, up, verticalFovDeg; patient LPS mm")
        ->excludes(view);
    command
        ->add_option("--fov", o.fovDeg,
                     "Vertical field of view in degrees (default: that of --camera, or 30)")
        ->check(between(0.1, 170.0));
    command->add_option("--size", o.size, "Picture size in pixels (default: 768x768)")->option_text("WxH");
    command
        ->add_option("--look", o.settings.look, "How it is drawn, see docs/presets.md (default: cinematic)")
        ->transform(oneOf(looksByName()))
        ->option_text("cinematic|clear|dvr|mip|minip|average");
    command
        ->add_option("--window", o.window,
                     "Of mip, minip and average (default: range of --preset, else window of the series)")
        ->option_text("CENTRE,WIDTH");
    command->add_flag_callback(
        "--shading", [&o] { o.settings.shading = trace::Shading::headlight; },
        "Light dvr from the eye, with the preset's ambient and diffuse parts");
    command->add_option(
        "--quality", o.quality,
        "draft, normal, high, reference, or JSON file: samples, bounces, filter and denoising at once");
    command
        ->add_option("--spp", o.samplesPerPixel,
                     "Samples per pixel (default: 64, or 8 for looks without chance)")
        ->check(CLI::Range(1u, kMostSamples));
    command
        ->add_option("--error", o.error,
                     "Trace until noise is this small, 0.01 of black to white; then --spp is about the most")
        ->check(between(1e-4, 1.0));
    command->add_option("--bounces", o.bounces, "Scattering events per path of cinematic (default: 4)")
        ->check(CLI::Range(1, trace::kMaxBounces));
    command->add_flag_function(
        "--denoise,!--no-denoise", [&o](std::int64_t count) { o.denoise = count > 0; },
        "Filter the noise out, guided by what is seen, or not; the picture says that it is denoised");
    command->add_option("--seed", o.settings.seed,
                        "Of the random numbers; the same seed gives the same picture");
    command->add_option("--lights", o.lights,
                        "Name from macula presets, light rig JSON, or HDR or EXR panorama");
    command
        ->add_option("--light-rotation", o.settings.lightRotationDeg,
                     "Degrees to turn the lights about the vertical, towards the patient's left")
        ->check(between(-360.0, 360.0));
    command->add_option("--light-strength", o.settings.lightStrength, "Multiplies the lights (default: 1)")
        ->check(between(0.0, trace::kMaxGain));
    command
        ->add_option("--exposure", o.settings.exposure,
                     "Multiplies the picture before the tone map (default: 1)")
        ->check(between(1e-6, trace::kMaxGain));
    command->add_flag(
        "--remove-table", o.removeTable,
        "Leave out the table and what else lies beside the patient; CT only. What went is said");
    command->add_option("--clip", o.clip,
                        "Name from macula presets, or JSON file: what is shown of the volume");
    command
        ->add_option_function<std::uint64_t>(
            "--voxel-memory", [&o](std::uint64_t mebibytes) { o.memory.voxelBytes = mebibytes << 20; },
            "At most so many MiB of the device for voxels (default: what is free)")
        ->check(CLI::Range(1, 1 << 20));
    command->add_option("--device", o.device, "Number or part of the name, see macula devices");
    command->add_flag("--keep-unfinished", o.keepUnfinished,
                      "When --error is stopped (Ctrl-C), write the picture as it is then");
    addOverwrite(*command, o.overwrite);
    command->add_option("--json", o.statistics, "Write what was done and how long it took; - for stdout");
    command->callback([options, &action] { action = [options] { return render(*options); }; });
}

}  // namespace macula::cli
