// macula-bench evaluate init, refine, live [PATH...]: how good peripheral models are, by the protocol of
// docs/peripheral-model.md.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <filesystem>
#include <memory>

#include "base/progress_bar.h"
#include "bench/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/model_options.h"
#include "cli/shared/number_range.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "evaluate/study_evaluation.h"
#include "image/image_file.h"
#include "live/device/open_device.h"
#include "pictures/output_files.h"
#include "pipeline/trace/settings.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"

namespace macula::bench {

namespace {

namespace fs = std::filesystem;

// More pixels are none of lavapipe's storage buffers, which would be found out after the training.
constexpr int kMostTruthSizePx = 2800;

struct EvaluateOptions {
    evaluate::StudyEvaluationOptions studies{.lights = scene::kDefaultLights};
    std::string device;
    int truthSizePx = 0;  // 0: as the views
    fs::path json;
    fs::path pictures;
    bool overwrite = false;
};

// Numbered, because a name may say whose it is.
fs::path pictureOf(const EvaluateOptions& options, std::size_t scene, std::size_t view) {
    return options.pictures / fmt::format("scene{:02}-view{:02}.png", scene, view);
}

Result<void> checkFiles(const EvaluateOptions& options) {
    const evaluate::StudyEvaluationOptions& studies = options.studies;
    pictures::OutputFiles files(options.overwrite);
    for (const fs::path& path : studies.paths) files.read(path);
    for (const std::string& preset : studies.presets) files.read(preset);
    files.read(studies.clip);
    files.read(studies.lights);
    MACULA_TRY_VOID(files.write(options.json));
    if (options.pictures.empty()) return {};
    for (std::size_t scene = 0; scene < studies.scenes(); ++scene) {
        for (std::size_t view = 0; view < studies.evaluation.truthViews; ++view)
            MACULA_TRY_VOID(files.write(pictureOf(options, scene, view)));
    }
    return {};
}

// All that can be wrong on the command line, before anything takes time.
Result<void> check(const EvaluateOptions& options) {
    MACULA_TRY_VOID(cli::checkModelOptions(options.studies.evaluation.model));
    MACULA_TRY_VOID(check(options.studies));
    std::error_code error;
    if (!options.pictures.empty() && !fs::is_directory(options.pictures, error))
        return Error{ErrorCode::outputNotWritable, Text("The folder for pictures does not exist."),
                     options.pictures.string(), Text("Create it, or choose another one.")};
    return checkFiles(options);
}

Result<void> writePictures(const EvaluateOptions& options, std::size_t scene,
                           const evaluate::SceneEvaluation& evaluation) {
    if (options.pictures.empty()) return {};
    const glm::ivec2 size = options.studies.evaluation.truth.sizePx;
    for (std::size_t view = 0; view < evaluation.pictures.size(); ++view) {
        MACULA_TRY_VOID(
            image::writePng(pictureOf(options, scene, view), 2 * size.x, size.y, evaluation.pictures[view]));
    }
    return {};
}

Result<void> tell(const evaluate::EvaluationReport& report, const fs::path& json) {
    if (json != "-") fmt::print("{}", tableOf(report));
    return json.empty() ? Result<void>() : cli::printOrWrite(json, cli::jsonText(toJson(report)));
}

Result<void> evaluateAll(EvaluateOptions options) {
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY_VOID(check(options));
    evaluate::StudyEvaluationOptions& studies = options.studies;
    evaluate::EvaluationOptions& evaluation = studies.evaluation;
    evaluation.truth.sizePx =
        glm::ivec2(options.truthSizePx > 0 ? options.truthSizePx : evaluation.model.sizePx);
    evaluation.truth.bounces = evaluation.model.bounces;
    MACULA_TRY(gpu::LastingDevice device, live::openDevice(options.device, cli::printNote));
    evaluate::EvaluationReport report{.device = {},
                                      .lights = scene::publicLightsName(studies.lights),
                                      .clip = scene::publicClipName(studies.clip),
                                      .options = evaluation,
                                      .scenes = {}};
    Progress progress(terminalProgressBar(), cli::interruptToken());
    const evaluate::EvaluationListener listener{
        .noted = [](const auto& notes, const auto& warnings) { cli::printNotes(notes, warnings); },
        .evaluated = [&](std::size_t scene,
                         const auto& evaluated) { return writePictures(options, scene, evaluated); }};
    const Result<void> ended = evaluateStudies(studies, device, listener, progress, report);
    if (report.scenes.empty()) return ended;
    const bool isFile = !options.json.empty() && options.json != "-";
    const fs::path json = ended || !isFile ? options.json : pictures::placeOfUnfinished(options.json);
    MACULA_TRY_VOID(tell(report, json));
    if (!ended)
        cli::printNote(fmt::format("Only {} of {} scenes were finished; their numbers are kept.",
                                   report.scenes.size(), studies.scenes()));
    if (isFile) cli::printWritten(json, start);
    return ended;
}

void addProtocolOptions(CLI::App& command, EvaluateOptions& o) {
    evaluate::EvaluationOptions& e = o.studies.evaluation;
    cli::addModelOptions(command, e.model);
    command
        .add_option("--truth-views", e.truthViews,
                    "Views that are compared; fewer are some from each distance")
        ->capture_default_str()
        ->check(CLI::Range(1, cli::kMostViews));
    e.truth.samplesPerPixel = 256;
    command
        .add_option("--truth-spp", e.truth.samplesPerPixel,
                    "Samples per pixel of what is compared with, even; the protocol wants 1024")
        ->capture_default_str()
        ->check(CLI::Range(2, 1 << 20));
    command.add_option("--truth-size", o.truthSizePx, "Its width and height in pixels (default: as --size)")
        ->check(CLI::Range(16, kMostTruthSizePx));
    CLI::Option* cache = command.add_option(
        "--cache", e.cache, "Folder to keep what is compared with, and to go on from; it shows the patient");
    command
        .add_flag(
            "--keep-views", e.keepViews,
            "Keep there what is learnt from, too, when all of it is made: 4 MiB for a view of 512 x 512. "
            "Seconds are then those of what was not there")
        ->needs(cache);
}

void addRefinementOptions(CLI::App& command, evaluate::RefinementPlan& plan) {
    command.add_option("--more-views", plan.views, "Views that are traced for going on")
        ->capture_default_str()
        ->check(CLI::Range(1, cli::kMostViews));
    command
        .add_option("--more-spp", plan.samplesPerPixel,
                    "Samples per pixel of these; few will do, because views light each other")
        ->capture_default_str()
        ->check(CLI::Range(1, cli::kMostSamplesOfView));
    command.add_option("--more-iterations", plan.iterations, "Steps of training that follow")
        ->capture_default_str()
        ->check(CLI::Range(1, cli::kMostIterations));
    command.add_option("--snapshot-every", plan.snapshotEvery, "Steps after which the model is compared")
        ->capture_default_str()
        ->check(CLI::Range(1, cli::kMostIterations));
    command.add_option("--splats", plan.capacity, "Most splats that it may come to have, if it has fewer")
        ->capture_default_str()
        ->check(CLI::Range(1u, trace::kMaxSurfacePoints));
}

// What the verbs have in common.
CLI::App* addVerb(CLI::App& evaluateApp, const std::string& name, const std::string& help,
                  const std::shared_ptr<EvaluateOptions>& options, cli::Action& action) {
    EvaluateOptions& o = *options;
    auto* command = evaluateApp.add_subcommand(name, help);
    command->add_option("PATH", o.studies.paths,
                        "Folders with DICOM files, volume files, or phantom: (default), each a scene");
    command->add_option("--series", o.studies.series,
                        "Place in the list of macula info, or series UID: once for each PATH");
    cli::addJoin(*command, o.studies.how);
    command->add_option("--preset", o.studies.presets,
                        "Name, number or file; several times: every PATH with every preset");
    command->add_flag("--fit", o.studies.fit, "Stretch the presets' range to the series, for MR");
    command->add_option("--clip", o.studies.clip, "Name from macula presets, or JSON file");
    command->add_flag("--remove-table", o.studies.removeTable, "Leave out the table; CT only");
    command->add_option("--lights", o.studies.lights, "Name from macula presets, light rig JSON, or panorama")
        ->capture_default_str();
    addProtocolOptions(*command, o);
    command->add_option("--pictures", o.pictures,
                        "Folder for what was compared: the truth, and beside it the model");
    command->add_option("--json", o.json, "File for all numbers; - for stdout, without the table");
    cli::addOverwrite(*command, o.overwrite);
    command->add_option("--device", o.device, "Number or part of the name, see macula devices");
    command->callback([options, &action] { action = [options] { return evaluateAll(*options); }; });
    return command;
}

}  // namespace

void addEvaluate(CLI::App& app, cli::Action& action) {
    auto* evaluateApp = app.add_subcommand("evaluate", "Measure how good peripheral models are");
    evaluateApp->require_subcommand(1);
    addVerb(*evaluateApp, "init",
            "First models: made of a few views, compared with traced pictures from elsewhere",
            std::make_shared<EvaluateOptions>(), action);
    auto refined = std::make_shared<EvaluateOptions>();
    evaluate::RefinementPlan& plan = refined->studies.evaluation.refinement.emplace();
    auto* refine =
        addVerb(*evaluateApp, "refine",
                "Models that go on: a first one, then more views and more splats, compared on the way",
                refined, action);
    addRefinementOptions(*refine, plan);
    auto taught = std::make_shared<EvaluateOptions>();
    evaluate::LivePlan& live = taught->studies.evaluation.live.emplace();
    auto* byItself =
        addVerb(*evaluateApp, "live", "Models as the window makes them by itself, compared on the way",
                taught, action);
    byItself->add_option("--seconds", live.seconds, "How long it learns, unless it rests before")
        ->capture_default_str()
        ->check(cli::between(0.0, 86400.0));
    byItself->add_option("--snapshot-every", live.snapshotEvery, "Seconds after which it is compared")
        ->capture_default_str()
        ->check(cli::between(0.1, 86400.0));
    addEvaluateEdits(*evaluateApp, action);
    addEvaluateLivePicture(*evaluateApp, action);
    addEvaluateSpecks(*evaluateApp, action);
    addEvaluateInterpolation(*evaluateApp, action);
    addEvaluateMotion(*evaluateApp, action);
    addEvaluateQuality(*evaluateApp, action);
    addEvaluateTradeoff(*evaluateApp, action);
}

}  // namespace macula::bench
