// macula train PATH -o MODEL: a peripheral model of a series, as a file.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/choice/clip_choice.h"
#include "app/choice/lights_choice.h"
#include "app/model/model_key.h"
#include "app/model/model_training.h"
#include "app/open_device.h"
#include "app/study/shown_clip.h"
#include "app/study/study_input.h"
#include "app/study/study_preset.h"
#include "base/atomic_file.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/model_options.h"
#include "cli/number_range.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "pipeline/splat/draw/displayed.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/files/training_file.h"
#include "pipeline/trace/settings.h"

namespace macula::cli {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Options {
    fs::path path;
    std::string series;
    dicom::ScanOptions how;
    std::string preset;
    bool fit = false;
    std::string clip;
    bool removeTable = false;
    std::string lights = app::kDefaultLights;
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

Result<void> checkModelName(const fs::path& path) {
    if (splat::modelFormatOf(path) != nullptr) return {};
    return Error{ErrorCode::usage, "The model's name says no format.", path.string(),
                 "End it with " + splat::modelExtensions(true) + "."};
}

Result<void> checkFiles(const Options& options) {
    OutputFiles files(options.overwrite);
    for (const fs::path& input : {options.path, fs::path(options.preset), fs::path(options.clip),
                                  fs::path(options.lights), options.resume})
        files.read(input);
    // A training that goes on may take the place of what it was.
    MACULA_TRY_VOID(isSameFile(options.output, options.resume) ? files.writeOn(options.output)
                                                               : files.write(options.output));
    return files.write(options.json);
}

// All that can be wrong on the command line, before anything takes time.
Result<trace::Environment> check(const Options& options) {
    MACULA_TRY_VOID(checkModelName(options.output));
    MACULA_TRY_VOID(checkModelOptions(options.model));
    if (options.displayColours && splat::modelFormatOf(options.output)->keepsTraining)
        return Error{ErrorCode::usage,
                     "What goes on learning needs linear colours.",
                     {},
                     "Give --display-colours with .ply or .spz."};
    MACULA_TRY_VOID(checkFiles(options));
    if (!options.preset.empty()) MACULA_TRY_VOID(app::presetToDraw(options.preset, options.fit));
    if (!options.clip.empty()) MACULA_TRY_VOID(app::chooseClip(options.clip));
    return app::choosePatientLights(options.lights);
}

// The training to go on with, if any.
Result<std::optional<splat::TrainingState>> savedTraining(const Options& options) {
    if (options.resume.empty()) return std::optional<splat::TrainingState>();
    MACULA_TRY(splat::TrainingState state, splat::readTraining(options.resume));
    const auto isPicture = [](const splat::TrainingState::View& view) {
        return view.given->kind == splat::ViewKind::picture;
    };
    if (std::none_of(state.views.begin(), state.views.end(), isPicture))
        return Error{ErrorCode::inputNotUsable, "The saved training has no views to learn from.",
                     options.resume.string(), "Train anew, with --views above 0."};
    if (!options.iterationsGiven && state.steps >= app::plannedSteps(state))
        return Error{ErrorCode::usage,
                     fmt::format("The saved training has all of its {} steps.", app::plannedSteps(state)),
                     {},
                     "Give --iterations for as many more."};
    return std::optional(std::move(state));
}

std::uint64_t stepsToCome(const Options& options, const std::optional<splat::TrainingState>& saved) {
    const bool isRest = saved && !options.iterationsGiven;
    const std::uint64_t wanted = isRest ? app::plannedSteps(*saved) - saved->steps : options.model.iterations;
    return options.pauseAfter > 0 ? std::min(wanted, options.pauseAfter) : wanted;
}

// What the model begins with is told of a training that began here; a saved one does not say all of it.
nlohmann::ordered_json toJson(const app::Trained& trained, const app::StudyInput& study,
                              const std::string& preset, bool tableRemoved, const Options& options,
                              std::uint64_t stepsBefore) {
    const hybrid::FirstModelOptions& m = options.model;
    nlohmann::ordered_json json{{"version", MACULA_VERSION},
                                {"device", trained.device},
                                {"study", study.seriesDigest},
                                {"preset", preset},
                                {"lights", app::publicLightsName(options.lights)},
                                {"clip", app::publicClipName(options.clip)},
                                {"tableRemoved", tableRemoved}};
    if (options.resume.empty())
        json.update({{"points", m.points.count},
                     {"views", m.views},
                     {"viewsTraced", trained.viewsTraced},
                     {"directions", m.directions},
                     {"viewsGivenUp", trained.viewsGivenUp},
                     {"samplesPerPixel", m.samplesPerPixel},
                     {"size", m.sizePx},
                     {"bounces", m.bounces}});
    if (options.budgetSeconds > 0.0) json["budgetSeconds"] = options.budgetSeconds;
    json.update({{"iterationsBefore", stepsBefore},
                 {"iterations", trained.report.steps},
                 {"plannedIterations", app::plannedSteps(trained.state)},
                 {"interrupted", trained.interrupted},
                 {"splats", trained.report.splats},
                 {"loss", trained.report.loss},
                 {"meanDifference", trained.report.l1},
                 {"seconds",
                  {{"points", trained.pointsSeconds},
                   {"views", trained.viewsSeconds},
                   {"training", trained.trainSeconds}}}});
    return json;
}

// With all that training needs to go on, or the splats alone.
Result<void> write(const fs::path& path, const Options& options, const splat::TrainingState& state) {
    if (splat::modelFormatOf(path)->keepsTraining) return splat::writeTraining(path, state);
    MACULA_TRY(
        const std::size_t clamped,
        splat::writeModel(path, options.displayColours ? splat::asDisplayed(state.splats) : state.splats));
    if (clamped > 0)
        printNote(
            fmt::format("{} splats have numbers that this format cannot hold; they were limited.", clamped));
    return {};
}

// A training that goes on takes the place of what it was, however far it came.
fs::path placeFor(const Options& options, bool cutShort) {
    if (!cutShort || isSameFile(options.output, options.resume)) return options.output;
    return placeOfUnfinished(options.output);
}

std::string howTimeWasSpent(const app::Trained& trained, std::size_t views) {
    return fmt::format("Points took {:.1f} s, views {:.1f} s ({} of {} traced), training {:.1f} s.",
                       trained.pointsSeconds, trained.viewsSeconds, trained.viewsTraced, views,
                       trained.trainSeconds);
}

// Of a training that did not come to its end.
std::string whatIsWritten(const app::Trained& trained, std::uint64_t steps, const fs::path& path) {
    std::string sentence = fmt::format("Stopped after {} of {} steps; the model is written as it is then.",
                                       trained.report.steps - trained.firstStep, steps);
    if (splat::modelFormatOf(path)->keepsTraining) sentence += " --resume goes on with it.";
    return sentence;
}

Result<void> train(const Options& options) {
    const auto start = Clock::now();
    MACULA_TRY(const trace::Environment lights, check(options));
    MACULA_TRY(const std::optional<splat::TrainingState> saved, savedTraining(options));
    MACULA_TRY(gpu::LastingDevice device, app::openDevice(options.device, printNote));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(app::StudyInput study, app::loadStudy(options.path, options.series, progress, 0, options.how));
    bringTo16Bits(study);
    MACULA_TRY(const app::StudyPreset preset, app::choosePresetFor(study, options.preset, options.fit));
    printNotes(study.notes, study.warnings);
    ClipPreset clip;
    if (!options.clip.empty()) {
        MACULA_TRY(clip, app::chooseClip(options.clip));
    }
    MACULA_TRY(const app::ShownClip shown,
               app::shownClip(clip, options.removeTable, *study.volume, progress));
    printNotes(shown.notes);

    const std::string key = app::trainingKey(*study.volume, preset.function, shown.clip, lights);
    if (saved) MACULA_TRY_VOID(app::checkTrainingKey(saved->options.key, key, options.resume));

    app::TrainingEnd end{.steps = stepsToCome(options, saved)};
    if (options.budgetSeconds > 0.0) end.budget = TimeBudget(options.budgetSeconds);
    std::optional<app::Trained> begun;  // no device takes it along
    const Result<void> ended = device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        if (begun) {
            MACULA_TRY_VOID(app::trainToTheEnd(on, *begun, end, progress));
        } else if (saved) {
            MACULA_TRY(begun, app::trainOn(on, *saved, end, progress));
        } else {
            const app::StudyScene scene{.volume = study.volume,
                                        .function = preset.function,
                                        .clip = shown.clip,
                                        .environment = lights};
            MACULA_TRY(begun, app::trainFirst(on, scene, options.model, end, progress));
        }
        return begun->failure ? Result<void>(*begun->failure) : Result<void>();
    });
    if (!begun) return ended.error();
    app::Trained& trained = *begun;
    trained.state.options.key = key;
    if (trained.viewsGivenUp > 0)
        printNote(
            fmt::format("{} of the {} views show little of the anatomy, or from very near: nothing "
                        "better was found.",
                        trained.viewsGivenUp, std::max(options.model.views, options.model.directions)));
    const fs::path path = placeFor(options, trained.interrupted || !ended.ok());
    MACULA_TRY_VOID(write(path, options, trained.state));
    const bool isWhole = trained.report.steps >= trained.firstStep + end.steps;
    if (!isWhole && !trained.interrupted) printNote(whatIsWritten(trained, end.steps, path));
    if (end.budget.isLimited() && !saved) printNote(howTimeWasSpent(trained, options.model.views));
    const std::uint64_t stepsBefore = saved ? saved->steps : 0;
    const std::string text =
        jsonText(toJson(trained, study, preset.publicName, shown.tableRemoved, options, stepsBefore)) + "\n";
    if (options.json == "-") fmt::print("{}", text);
    if (!options.json.empty() && options.json != "-")
        MACULA_TRY_VOID(writeTextAtomically(options.json, text));
    printWritten(path, start);
    if (trained.interrupted)
        return Error{ErrorCode::cancelled, whatIsWritten(trained, end.steps, path), path.string(), {}};
    return ended;
}

// Returns what tells whether --iterations was given.
CLI::Option* addTrainingOptions(CLI::App& command, Options& o) {
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
    auto options = std::make_shared<Options>();
    Options& o = *options;
    auto* command =
        app.add_subcommand("train", "Make a peripheral model, a set of 3D Gaussians, of a series");
    command->add_option("PATH", o.path, "Folder with DICOM files, volume file, or phantom: (default)");
    command
        ->add_option("-o,--output", o.output,
                     "Model: .ply (exact), .spz (small), or .macula (with all that training needs to go on)")
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
