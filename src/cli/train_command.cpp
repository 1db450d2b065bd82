// macula train PATH -o MODEL: a peripheral model of a series, as a file.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/atomic_file.h"
#include "base/progress_bar.h"
#include "cli/clip_choice.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/lights_choice.h"
#include "cli/model_options.h"
#include "cli/open_device.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/shown_clip.h"
#include "cli/study_input.h"
#include "cli/study_preset.h"
#include "pipeline/hybrid/first_model.h"
#include "pipeline/hybrid/traced_scene.h"
#include "pipeline/splat/model_file.h"
#include "pipeline/splat/training_file.h"
#include "pipeline/trace/settings.h"

namespace macula::cli {

namespace {

namespace fs = std::filesystem;

struct Options {
    fs::path path;
    std::string series;
    std::string preset;
    bool fit = false;
    std::string clip;
    bool removeTable = false;
    std::string lights = kDefaultLights;
    std::string device;
    fs::path output;
    fs::path json;
    double budgetSeconds = 0.0;  // 0: as long as the iterations take
    hybrid::FirstModelOptions model;
};

std::string extensionOf(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

Result<void> checkModelName(const fs::path& path) {
    const std::string extension = extensionOf(path);
    if (extension == ".ply" || extension == ".spz" || extension == ".macula") return {};
    return Error{ErrorCode::usage, "The model's name says no format.", path.string(),
                 "End it with .ply, .spz or .macula."};
}

// All that can be wrong on the command line, before anything takes time.
Result<trace::Environment> check(const Options& options) {
    MACULA_TRY_VOID(checkFolderOf(options.output));
    MACULA_TRY_VOID(checkModelName(options.output));
    MACULA_TRY_VOID(checkModelOptions(options.model));
    if (!options.json.empty() && options.json != "-") MACULA_TRY_VOID(checkFolderOf(options.json));
    if (!options.preset.empty()) MACULA_TRY_VOID(presetToDraw(options.preset, options.fit));
    if (!options.clip.empty()) MACULA_TRY_VOID(chooseClip(options.clip));
    return choosePatientLights(options.lights);
}

// What is on the host when the device is done: a lost device takes nothing of it along.
struct Trained {
    std::string device;
    splat::TrainingState state;
    splat::TrainingReport report;
    double pointsSeconds = 0.0;
    double viewsSeconds = 0.0;
    double trainSeconds = 0.0;
    std::size_t viewsGivenUp = 0;
};

Result<Trained> trainOn(const std::shared_ptr<gpu::Device>& device,
                        const std::shared_ptr<const Volume>& volume, const TransferFunction& function,
                        const Clip& clip, const trace::Environment& lights, const Options& options,
                        Progress& progress) {
    MACULA_TRY(const hybrid::TracedScene scene, hybrid::TracedScene::create(volume, function, clip, lights));
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device));
    MACULA_TRY_VOID(tracer.setVolume(volume));
    MACULA_TRY_VOID(tracer.setClip(clip));
    MACULA_TRY_VOID(tracer.setTransferFunction(function));
    MACULA_TRY_VOID(tracer.setEnvironment(lights));
    hybrid::FirstModelOptions wanted = options.model;
    if (options.budgetSeconds > 0.0) wanted.budgetMs = 1000.0 * options.budgetSeconds;
    MACULA_TRY(const hybrid::FirstModel model,
               hybrid::makeFirstModel(device, tracer, scene.seenMm(), wanted, progress));
    Trained trained{.device = gpu::describe(device->info()),
                    .report = model.trainer.report(),
                    .pointsSeconds = model.pointsSeconds,
                    .viewsSeconds = model.viewsSeconds,
                    .trainSeconds = model.trainSeconds,
                    .viewsGivenUp = model.viewsGivenUp};
    MACULA_TRY(trained.state, model.trainer.state());
    return trained;
}

nlohmann::ordered_json toJson(const Trained& trained, const StudyInput& study, const std::string& preset,
                              bool tableRemoved, const Options& options) {
    const hybrid::FirstModelOptions& m = options.model;
    return {{"version", MACULA_VERSION},
            {"device", trained.device},
            {"study", study.seriesDigest},
            {"preset", preset},
            {"lights", publicLightsName(options.lights)},
            {"clip", publicClipName(options.clip)},
            {"tableRemoved", tableRemoved},
            {"points", m.points.count},
            {"views", m.views},
            {"directions", m.directions},
            {"viewsGivenUp", trained.viewsGivenUp},
            {"samplesPerPixel", m.samplesPerPixel},
            {"size", m.sizePx},
            {"bounces", m.bounces},
            {"iterations", trained.report.steps},
            {"splats", trained.report.splats},
            {"loss", trained.report.loss},
            {"meanDifference", trained.report.l1},
            {"seconds",
             {{"points", trained.pointsSeconds},
              {"views", trained.viewsSeconds},
              {"training", trained.trainSeconds}}}};
}

// With all that training needs to go on, or the splats alone.
Result<void> write(const fs::path& path, const splat::TrainingState& state) {
    if (extensionOf(path) == ".macula") return splat::writeTraining(path, state);
    MACULA_TRY(const std::size_t clamped, splat::writeModel(path, state.splats));
    if (clamped > 0)
        printNote(
            fmt::format("{} splats have numbers that this format cannot hold; they were limited.", clamped));
    return {};
}

Result<void> train(const Options& options) {
    MACULA_TRY(const trace::Environment lights, check(options));
    MACULA_TRY(gpu::LastingDevice device, openDevice(options.device));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(StudyInput study, loadStudy(options.path, options.series, progress));
    bringTo16Bits(study);
    MACULA_TRY(const StudyPreset preset, choosePresetFor(study, options.preset, options.fit));
    ClipPreset clip;
    if (!options.clip.empty()) {
        MACULA_TRY(clip, chooseClip(options.clip));
    }
    MACULA_TRY(const ShownClip shown, shownClip(clip, options.removeTable, *study.volume, progress));

    Trained trained;
    MACULA_TRY_VOID(device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(trained,
                   trainOn(on, study.volume, preset.function, shown.clip, lights, options, progress));
        return {};
    }));
    if (trained.viewsGivenUp > 0)
        printNote(
            fmt::format("{} of the {} views show little of the anatomy, or from very near: nothing "
                        "better was found.",
                        trained.viewsGivenUp, std::max(options.model.views, options.model.directions)));
    MACULA_TRY_VOID(write(options.output, trained.state));
    const std::string text =
        toJson(trained, study, preset.publicName, shown.tableRemoved, options).dump(4) + "\n";
    if (options.json == "-") fmt::print("{}", text);
    if (!options.json.empty() && options.json != "-")
        MACULA_TRY_VOID(writeTextAtomically(options.json, text));
    return {};
}

void addTrainingOptions(CLI::App& command, Options& o) {
    addModelOptions(command, o.model);
    command
        .add_option("--splats", o.model.capacity, "Most splats of the model; never fewer than it begins with")
        ->capture_default_str()
        ->check(CLI::Range(1u, trace::kMaxSurfacePoints));
    command
        .add_option(
            "--budget", o.budgetSeconds,
            "Seconds of training, after points and views are there; ends it even before all iterations")
        ->check(CLI::Range(0.1, 1e6));
}

}  // namespace

void addTrain(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    Options& o = *options;
    auto* command =
        app.add_subcommand("train", "Make a peripheral model, a set of 3D Gaussians, of a series");
    command->add_option("PATH", o.path, "Folder with DICOM files, volume file, or phantom: (default)");
    command
        ->add_option("-o,--output", o.output,
                     "Model: .ply (exact), .spz (small), or .macula (with all that training needs to go on)")
        ->required();
    command->add_option("--series", o.series, "Place in the list of macula info, or series UID");
    command->add_option("--preset", o.preset, "Name, number or file; default by modality");
    command->add_flag("--fit", o.fit, "Stretch the preset's range to the series, for MR");
    command->add_option("--clip", o.clip, "Name from macula presets, or JSON file");
    command->add_flag("--remove-table", o.removeTable, "Leave out the table; CT only");
    command->add_option("--lights", o.lights, "Name from macula presets, light rig JSON, or panorama")
        ->capture_default_str();
    addTrainingOptions(*command, o);
    command->add_option("--json", o.json, "File for what was done and how long it took; - for stdout");
    command->add_option("--device", o.device, "Number or part of the name, see macula devices");
    command->callback([options, &action] { action = [options] { return train(*options); }; });
}

}  // namespace macula::cli
