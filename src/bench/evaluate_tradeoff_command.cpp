// macula-bench evaluate tradeoff [PATH]: error of hybrid frames against time, as JSON and as curves.
#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "bench/study_report.h"
#include "cli/shared/number_range.h"
#include "cli/shared/output_options.h"
#include "evaluate/frame_tradeoff_report.h"
#include "pictures/output_files.h"

namespace macula::bench {

namespace {

struct EvaluateTradeoffOptions {
    evaluate::BenchStudyOptions study;
    evaluate::FrameTradeoffOptions tradeoff;
    std::filesystem::path plot;
    bool overwrite = false;
};

Result<void> evaluateTradeoff(const EvaluateTradeoffOptions& options) {
    pictures::OutputFiles files(options.overwrite);
    files.read(options.study.path);
    files.read(options.study.preset);
    files.read(options.study.lights);
    MACULA_TRY_VOID(files.write(options.plot));
    const auto keep = [&](const evaluate::FrameTradeoff& found) {
        return options.plot.empty() ? Result<void>()
                                    : writeTextAtomically(options.plot, toSvg(plotsOf(found)));
    };
    return printReport(options.study, options.tradeoff, evaluate::measureFrameTradeoff, keep);
}

}  // namespace

void addEvaluateTradeoff(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<EvaluateTradeoffOptions>();
    evaluate::FrameTradeoffOptions& o = options->tradeoff;
    auto* command = evaluateApp.add_subcommand(
        "tradeoff", "Error of frames against time, over all that can be traded, and what is best; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what frames are compared with, even", 2,
                   1 << 20);
    cli::addNumber(*command, "--iterations", o.model.iterations,
                   "Steps of training of the usual splats; others take a third or three times as many", 1,
                   1000000);
    command->add_option("--plot", options->plot, "Write the curves as SVG");
    cli::addOverwrite(*command, options->overwrite);
    command->callback([options, &action] {
        options->tradeoff.sizePx = {options->study.size, options->study.size};
        action = [options] { return evaluateTradeoff(*options); };
    });
}

}  // namespace macula::bench
