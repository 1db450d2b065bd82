// macula-bench evaluate quality [PATH]: frames made in several ways, compared with traced ones, as JSON.
#include <CLI/App.hpp>
#include <memory>

#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "bench/study_report.h"
#include "cli/shared/model_options.h"
#include "cli/shared/number_range.h"

namespace macula::bench {

namespace {

struct EvaluateQualityOptions {
    evaluate::BenchStudyOptions study;
    evaluate::QualityOptions quality;
};

}  // namespace

void addEvaluateQuality(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<EvaluateQualityOptions>();
    evaluate::QualityOptions& o = options->quality;
    auto* command = evaluateApp.add_subcommand(
        "quality", "Frames traced, of splats, and of both, compared with traced pictures; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    cli::addNumber(*command, "--spp", o.foveaSamples,
                   "Samples per pixel of the fovea; four times as many in -hq", 1, 1024);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what frames are compared with, even", 2,
                   1 << 20);
    cli::addNumber(*command, "--views", o.views, "Views that are compared; fewer are some from each distance",
                   1, cli::kMostViews);
    cli::addNumber(*command, "--iterations", o.iterations,
                   "Steps of training of the first splats; -hq and refined take more", 1, 1000000);
    command->callback([options, &action] {
        options->quality.sizePx = {options->study.size, options->study.size};
        action = [options] {
            return printReport(options->study, options->quality, evaluate::measureQuality);
        };
    });
}

}  // namespace macula::bench
