// macula evaluate quality [PATH]: frames made in several ways, compared with traced ones, as JSON.
#include <CLI/App.hpp>
#include <memory>

#include "cli/command.h"
#include "cli/model_options.h"
#include "cli/number_range.h"
#include "cli/study_options.h"
#include "cli/study_report.h"

namespace macula::cli {

namespace {

struct EvaluateQualityOptions {
    evaluate::BenchStudyOptions study;
    evaluate::QualityOptions quality;
};

}  // namespace

void addEvaluateQuality(CLI::App& evaluateApp, Action& action) {
    auto options = std::make_shared<EvaluateQualityOptions>();
    evaluate::QualityOptions& o = options->quality;
    auto* command = evaluateApp.add_subcommand(
        "quality", "Frames traced, of splats, and of both, compared with traced pictures; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    addNumber(*command, "--spp", o.foveaSamples, "Samples per pixel of the fovea; four times as many in -hq",
              1, 1024);
    addNumber(*command, "--truth-spp", o.truthSamples, "Of what frames are compared with, even", 2, 1 << 20);
    addNumber(*command, "--views", o.views, "Views that are compared; fewer are some from each distance", 1,
              kMostViews);
    addNumber(*command, "--iterations", o.iterations,
              "Steps of training of the first splats; -hq and refined take more", 1, 1000000);
    command->callback([options, &action] {
        options->quality.sizePx = {options->study.size, options->study.size};
        action = [options] {
            return printReport(options->study, options->quality, evaluate::measureQuality);
        };
    });
}

}  // namespace macula::cli
