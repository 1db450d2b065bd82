// macula train PATH -o MODEL: a peripheral model of a series, as a file.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/model_options.h"
#include "cli/shared/number_range.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "live/device/open_device.h"
#include "live/model/model_output.h"
#include "live/model/model_training.h"
#include "live/model/training_identity.h"
#include "live/model/training_record.h"
#include "pictures/output_files.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/trace/settings.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/study_preset.h"
#include "scene/drawing/shown_clip.h"
#include "study/open/loaded_study.h"

namespace macula::cli {

namespace {

namespace fs = std::filesystem;

struct TrainOptions {
    fs::path path;
    std::string series;
    dicom::ScanOptions how;
    std::string preset;
    bool fit = false;
    std::string clip;
    bool removeTable = false;
    std::string lights = scene::kDefaultLights;
    std::string device;
    fs::path output;
    fs::path json;
    fs::path resume;             // empty: a training of its own
    double budgetSeconds = 0.0;  // 0: as long as the iterations take
    bool displayColours = false;
    std::uint64_t pauseAfter = 0;  // steps; 0: not before the end
    bool iterationsGiven = false;
    bool overwrite = false;
    hybrid::FirstModelOptions model;
};

Result<void> checkFiles(const TrainOptions& options) {
    pictures::OutputFiles files(options.overwrite);
    for (const fs::path& input : {options.path, fs::path(options.preset), fs::path(options.clip),
                                  fs::path(options.lights), options.resume})
        files.read(input);
    // A training that goes on may take the place of what it was.
    MACULA_TRY_VOID(pictures::isSameFile(options.output, options.resume) ? files.writeOn(options.output)
                                                                         : files.write(options.output));
    return files.write(options.json);
}

// All that can be wrong on the command line, before anything takes time.
Result<trace::Environment> check(const TrainOptions& options) {
    MACULA_TRY_VOID(live::checkModelName(options.output));
    MACULA_TRY_VOID(checkModelOptions(options.model));
    if (options.displayColours && live::holdsTraining(options.output))
        return Error{ErrorCode::usage,
                     Text("What goes on learning needs linear colours."),
                     {},
                     Text("Give --display-colours with {}.", splat::modelExtensions(false))};
    MACULA_TRY_VOID(checkFiles(options));
    if (!options.preset.empty()) MACULA_TRY_VOID(scene::presetToDraw(options.preset, options.fit));
    MACULA_TRY_VOID(scene::chooseClip(options.clip));
    return scene::choosePatientLights(options.lights);
}

// The training to go on with, if any.
Result<std::optional<splat::TrainingState>> savedTraining(const TrainOptions& options) {
    if (options.resume.empty()) return std::optional<splat::TrainingState>();
    MACULA_TRY(splat::TrainingState state,
               live::readTrainingToGoOn(options.resume, !options.iterationsGiven));
    return std::optional(std::move(state));
}

// A training that goes on takes the place of what it was, however far it came.
fs::path placeFor(const TrainOptions& options, bool cutShort) {
    if (!cutShort || pictures::isSameFile(options.output, options.resume)) return options.output;
    return pictures::placeOfUnfinished(options.output);
}

Result<void> train(const TrainOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY(const trace::Environment lights, check(options));
    MACULA_TRY(const std::optional<splat::TrainingState> saved, savedTraining(options));
    MACULA_TRY(gpu::LastingDevice device, live::openDevice(options.device, printNote));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(study::LoadedStudy study,
               study::loadStudy(options.path, options.series, progress, 0, options.how));
    bringTo16Bits(study);
    MACULA_TRY(const scene::StudyPreset preset, scene::choosePresetFor(study, options.preset, options.fit));
    printNotes(study.notes, study.warnings);
    MACULA_TRY(const ClipPreset clip, scene::chooseClip(options.clip));
    MACULA_TRY(const scene::ShownClip shown,
               scene::shownClip(clip, options.removeTable, *study.volume, progress));
    printNotes(shown.notes);

    const std::string key = live::trainingIdentity(*study.volume, preset.function, shown.clip, lights);
    if (saved) MACULA_TRY_VOID(live::checkTrainingIdentity(saved->options.key, key, options.resume));

    live::TrainingEnd end{.steps = saved && !options.iterationsGiven ? live::stepsLeft(*saved)
                                                                     : options.model.iterations};
    if (options.pauseAfter > 0) end.steps = std::min(end.steps, options.pauseAfter);
    if (options.budgetSeconds > 0.0) end.budget = TimeBudget(options.budgetSeconds);
    const live::StudyScene scene{
        .volume = study.volume, .function = preset.function, .clip = shown.clip, .environment = lights};
    live::LastingTraining lasting = trainLasting(device, scene, options.model, saved, end, progress);
    if (!lasting.trained) return lasting.ended.error();
    live::Trained& trained = *lasting.trained;
    trained.state.options.key = key;
    if (trained.viewsGivenUp > 0)
        printNote(
            fmt::format("{} of the {} views show little of the anatomy, or from very near: nothing "
                        "better was found.",
                        trained.viewsGivenUp, std::max(options.model.views, options.model.directions)));
    const fs::path path = placeFor(options, trained.interrupted || !lasting.ended.ok());
    MACULA_TRY(const std::size_t clamped, live::writeTrained(path, trained.state, options.displayColours));
    if (clamped > 0)
        printNote(
            fmt::format("{} splats have numbers that this format cannot hold; they were limited.", clamped));
    const bool isWhole = trained.report.steps >= trained.firstStep + end.steps;
    if (!isWhole && !trained.interrupted) printNote(whatIsWritten(trained, end.steps, path));
    if (end.budget.isLimited() && !saved) printNote(howTimeWasSpent(trained, options.model.views));
    const live::TrainingRecord record{.seriesDigest = study.seriesDigest,
                                      .preset = preset.publicName,
                                      .lights = scene::publicLightsName(options.lights),
                                      .clip = scene::publicClipName(options.clip),
                                      .tableRemoved = shown.tableRemoved,
                                      .begun = saved ? std::nullopt : std::optional(options.model),
                                      .budgetSeconds = options.budgetSeconds,
                                      .stepsBefore = saved ? saved->steps : 0};
    if (!options.json.empty()) MACULA_TRY_VOID(printOrWrite(options.json, jsonText(toJson(record, trained))));
    printWritten(path, start);
    if (trained.interrupted)
        return Error{
            ErrorCode::cancelled, Text("{}", whatIsWritten(trained, end.steps, path)), path.string(), {}};
    return lasting.ended;
}

// Returns what tells whether --iterations was given.
CLI::Option* addTrainingOptions(CLI::App& command, TrainOptions& o) {
    const ModelOptionsAdded model = addModelOptions(command, o.model);
    auto* splats = command
                       .add_option("--splats", o.model.capacity,
                                   "Most splats of the model; never fewer than it begins with")
                       ->capture_default_str()
                       ->check(CLI::Range(1u, trace::kMaxSurfacePoints));
    command
        .add_option(
            "--budget", o.budgetSeconds,
            "Seconds for points, views and training together, once the series is read. Fewer views are "
            "traced where they would leave less than half for training, which may end before the last "
            "iterations, in which rates fall and light is put right")
        ->check(between(0.1, 1e6));
    command
        .add_option("--pause-after", o.pauseAfter,
                    "Stop after so many steps of those that are planned; --resume goes on with the rest")
        ->check(CLI::Range(1, kMostIterations));
    auto* resume = command.add_option(
        "--resume", o.resume,
        "Saved training (.macula) of the same study, preset, clip and lights to go on with, to where it was "
        "planned to end, or for --iterations more");
    for (CLI::Option* ofTheStart : model.ofTheStart) resume->excludes(ofTheStart);
    resume->excludes(splats);
    return model.iterations;
}

}  // namespace

void addTrain(CLI::App& app, Action& action) {
    auto options = std::make_shared<TrainOptions>();
    TrainOptions& o = *options;
    auto* command =
        app.add_subcommand("train", "Make a peripheral model, a set of 3D Gaussians, of a series");
    command->add_option("PATH", o.path, "Folder with DICOM files, volume file, or phantom: (default)");
    command
        ->add_option("-o,--output", o.output,
                     "Model: .ply (exact), .spz (small), .glb (glTF), or .macula (with all that training "
                     "needs to go on)")
        ->required();
    command->add_flag("--display-colours", o.displayColours,
                      "Colours as displayed, for other programs: they do not know linear light and tone map");
    command->add_option("--series", o.series, "Place in the list of macula info, or series UID");
    addJoin(*command, o.how);
    command->add_option("--preset", o.preset, "Name, number or file; default by modality");
    command->add_flag("--fit", o.fit, "Stretch the preset's range to the series, for MR");
    command->add_option("--clip", o.clip, "Name from macula presets, or JSON file");
    command->add_flag("--remove-table", o.removeTable, "Leave out the table; CT only");
    command->add_option("--lights", o.lights, "Name from macula presets, light rig JSON, or panorama")
        ->capture_default_str();
    const CLI::Option* iterations = addTrainingOptions(*command, o);
    addOverwrite(*command, o.overwrite);
    command->add_option("--json", o.json, "File for what was done and how long it took; - for stdout");
    command->add_option("--device", o.device, "Number or part of the name, see macula devices");
    command->callback([options, iterations, &action] {
        options->iterationsGiven = iterations->count() > 0;
        action = [options] { return train(*options); };
    });
}

}  // namespace macula::cli
