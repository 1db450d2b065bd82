// macula-bench evaluate live-picture [PATH]: what the live picture is worth over time, as JSON.
#include <CLI/App.hpp>
#include <memory>

#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "bench/study_report.h"
#include "cli/shared/number_range.h"
#include "evaluate/live_picture_report.h"

namespace macula::bench {

namespace {

struct EvaluateLivePictureOptions {
    evaluate::BenchStudyOptions study;
    evaluate::LivePictureOptions live;
};

}  // namespace

void addEvaluateLivePicture(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<EvaluateLivePictureOptions>();
    evaluate::LivePictureOptions& o = options->live;
    auto* command = evaluateApp.add_subcommand(
        "live-picture", "The live picture in motion, at rest and after a change, over time; as JSON");
    addBenchStudyOptions(*command, options->study, options->study.size);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what pictures are compared with, even", 2,
                   1 << 20);
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
        options->live.recording.device = options->study.device;
        action = [options] {
            return checkAndPrintReport(options->study, options->live, evaluate::measureLivePicture);
        };
    });
}

}  // namespace macula::bench
