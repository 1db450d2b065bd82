// macula-bench evaluate edits, live-picture, motion, quality, specks, tradeoff [PATH]: what is measured of
// one study, as JSON.
#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "bench/study_report.h"
#include "cli/shared/model_options.h"
#include "cli/shared/name_option.h"
#include "cli/shared/number_range.h"
#include "cli/shared/output_options.h"
#include "evaluate/edits.h"
#include "evaluate/frame_tradeoff.h"
#include "evaluate/live_picture.h"
#include "evaluate/specks.h"
#include "pictures/output_files.h"

namespace macula::bench {

namespace {

constexpr int kMostTruthSamples = 1 << 20;

void addIterations(CLI::App& command, std::uint64_t& iterations, const char* help) {
    cli::addNumber(command, "--iterations", iterations, help, 1, 1000000);
}

// The folder of `pictures` is made if it is missing.
template <class Options, class Measure>
Result<void> printReportWithPictures(const StudyAnd<Options>& options, Measure measure) {
    if (!options.measured.pictures.empty())
        MACULA_TRY_VOID(pictures::makePictureFolder(options.measured.pictures));
    return printReport(options, measure);
}

struct TradeoffOutput {
    std::filesystem::path plot;
    bool overwrite = false;
};

Result<void> evaluateTradeoff(const StudyAnd<evaluate::FrameTradeoffOptions>& options,
                              const TradeoffOutput& output) {
    pictures::OutputFiles files(output.overwrite);
    files.read(options.study.path);
    files.read(options.study.preset);
    files.read(options.study.lights);
    MACULA_TRY_VOID(files.write(output.plot));
    const auto keep = [&](const evaluate::FrameTradeoff& found) {
        return output.plot.empty() ? Result<void>() : writeTextAtomically(output.plot, toSvg(plotsOf(found)));
    };
    return printReport(options, evaluate::measureFrameTradeoff, keep);
}

}  // namespace

void addEvaluateEdits(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<StudyAnd<evaluate::EditsOptions>>();
    evaluate::EditsOptions& o = options->measured;
    auto* command = evaluateApp.add_subcommand(
        "edits",
        "What is shown while a clip, the curve or the preset is changed, before it is traced; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what pictures are compared with", 1,
                   kMostTruthSamples);
    addIterations(*command, o.model.iterations, "Steps of training of the splats");
    command->add_option("--then-preset", options->study.thenPreset, "Preset that is changed to");
    command->add_option("--pictures", o.pictures, "Folder for the pictures that are compared");
    command->callback([options, &action] {
        options->measured.sizePx = glm::ivec2(options->study.size);
        action = [options] { return printReportWithPictures(*options, evaluate::measureEdits); };
    });
}

void addEvaluateLivePicture(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<StudyAnd<evaluate::LivePictureOptions>>();
    evaluate::LivePictureOptions& o = options->measured;
    auto* command = evaluateApp.add_subcommand(
        "live-picture", "The live picture in motion, at rest and after a change, over time; as JSON");
    addBenchStudyOptions(*command, options->study, options->study.size);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what pictures are compared with, even", 2,
                   kMostTruthSamples);
    command->add_option("--then-preset", options->study.thenPreset,
                        "Preset that is drawn after the rest, for as long again");
    const auto addReal = [&](const char* name, double& value, double low, const char* help) {
        command->add_option(name, value, help)->check(cli::between(low, 3600.0))->capture_default_str();
    };
    addReal("--turn", o.recording.turnS, 0.5, "Seconds for a turn around the patient");
    addReal("--seconds", o.recording.movingS, 0.1, "How long the camera moves");
    addReal("--learn", o.recording.learningS, 0.0, "Seconds for the model to learn before that");
    addReal("--rest", o.recording.restingS, 0.0, "Seconds after it has stopped");
    addReal("--pictures", o.recording.picturesPerS, 0.1, "How many are compared, for each second");
    command->callback([options, &action] {
        options->measured.recording.device = options->study.device;
        action = [options] { return checkAndPrintReport(*options, evaluate::measureLivePicture); };
    });
}

void addEvaluateMotion(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<StudyAnd<evaluate::MotionOptions>>();
    evaluate::MotionOptions& o = options->measured;
    auto* command = evaluateApp.add_subcommand(
        "motion", "Frames after the eye has moved: reprojected, not reprojected, and splats alone; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    cli::addNumber(*command, "--spp", o.foveaSamples, "Samples per pixel of the fovea", 1, 4096);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what frames are compared with", 1,
                   kMostTruthSamples);
    addIterations(*command, o.model.iterations, "Steps of training of the splats");
    command->add_option("--pictures", o.pictures, "Folder for the frames that are compared");
    command->callback([options, &action] {
        options->measured.sizePx = glm::ivec2(options->study.size);
        action = [options] { return printReportWithPictures(*options, evaluate::measureMotion); };
    });
}

void addEvaluateQuality(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<StudyAnd<evaluate::QualityOptions>>();
    evaluate::QualityOptions& o = options->measured;
    auto* command = evaluateApp.add_subcommand(
        "quality", "Frames traced, of splats, and of both, compared with traced pictures; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    cli::addNumber(*command, "--spp", o.foveaSamples,
                   "Samples per pixel of the fovea; four times as many in -hq", 1, 1024);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what frames are compared with, even", 2,
                   kMostTruthSamples);
    cli::addNumber(*command, "--views", o.views, "Views that are compared; fewer are some from each distance",
                   1, cli::kMostViews);
    addIterations(*command, o.iterations, "Steps of training of the first splats; -hq and refined take more");
    command->callback([options, &action] {
        options->measured.sizePx = glm::ivec2(options->study.size);
        action = [options] { return printReport(*options, evaluate::measureQuality); };
    });
}

void addEvaluateSpecks(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<StudyAnd<evaluate::SpecksOptions>>();
    evaluate::SpecksOptions& o = options->measured;
    auto* command = evaluateApp.add_subcommand(
        "specks",
        "Pixels that stand out of denoised pictures of few samples, beside the converged one; as JSON");
    addBenchStudyOptions(*command, options->study, options->study.size);
    command
        ->add_option("--samples", o.samples, "Samples per pixel of these pictures (default: 1 2 4 16 64 256)")
        ->check(CLI::Range(1u, 1u << 20))
        ->option_text("N...");
    cli::addNumber(*command, "--truth-spp", o.convergedSamples, "Of the converged picture", 2,
                   kMostTruthSamples);
    command->add_option("--filter", o.filter, "How values between voxels are found, see docs/presets.md")
        ->transform(cli::asFilter())
        ->option_text(cli::kFilterNames);
    command->callback([options, &action] {
        action = [options] { return checkAndPrintReport(*options, evaluate::measureSpecks); };
    });
}

void addEvaluateTradeoff(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<StudyAnd<evaluate::FrameTradeoffOptions>>();
    auto output = std::make_shared<TradeoffOutput>();
    evaluate::FrameTradeoffOptions& o = options->measured;
    auto* command = evaluateApp.add_subcommand(
        "tradeoff", "Error of frames against time, over all that can be traded, and what is best; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what frames are compared with, even", 2,
                   kMostTruthSamples);
    addIterations(*command, o.model.iterations,
                  "Steps of training of the usual splats; others take a third or three times as many");
    command->add_option("--plot", output->plot, "Write the curves as SVG");
    cli::addOverwrite(*command, output->overwrite);
    command->callback([options, output, &action] {
        options->measured.sizePx = glm::ivec2(options->study.size);
        action = [options, output] { return evaluateTradeoff(*options, *output); };
    });
}

}  // namespace macula::bench
