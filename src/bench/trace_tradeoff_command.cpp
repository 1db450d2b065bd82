// macula-bench trace-tradeoff [PATH]: error against time, over samples, bounces, denoising and filtering.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/progress_bar.h"
#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "evaluate/benchmark_reports.h"
#include "evaluate/svg_plot.h"
#include "pictures/output_files.h"

namespace macula::bench {

namespace {

struct BenchTradeoffOptions {
    evaluate::BenchStudyOptions study;
    std::filesystem::path plot;
    bool json = false;
    bool overwrite = false;
    evaluate::TradeoffOptions tradeoff;
};

Result<void> benchTradeoff(BenchTradeoffOptions options) {
    pictures::OutputFiles files(options.overwrite);
    files.read(options.study.path);
    MACULA_TRY_VOID(files.write(options.plot));
    Progress progress(terminalProgressBar(), cli::interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    cli::printNotes(study.notes, study.warnings);
    MACULA_TRY(const evaluate::Tradeoff tradeoff, measureTradeoff(study, options.tradeoff, progress));
    if (tradeoff.convergedLost > 0) {
        cli::printNote(
            fmt::format("The converged picture lacks {} samples, which were too long or not a number.",
                        tradeoff.convergedLost));
    }
    if (options.json) {
        fmt::print("{}\n", cli::jsonText(reportOf(study, options.tradeoff, tradeoff)));
    } else {
        fmt::print("{:>10} {:>8} {:>7} {:>7} {:>9} {:>8} {:>7} {:>6}\n", "filter", "denoised", "bounces",
                   "samples", "ms", "PSNR dB", "SSIM", "FLIP");
        for (const evaluate::TradeoffPoint& p : tradeoff.points) {
            fmt::print("{:>10} {:>8} {:>7} {:>7} {:>9.1f} {:>8.2f} {:>7.4f} {:>6.4f}\n",
                       trace::nameOf(p.filter), p.isDenoised() ? "yes" : "no", p.bounces, p.samples,
                       p.totalMs(), p.psnrDb, p.ssim, p.flip);
        }
    }
    // Last: what was measured is told even where the plot cannot be written.
    if (!options.plot.empty())
        MACULA_TRY_VOID(writeTextAtomically(options.plot, toSvg(plotsOf(tradeoff, options.tradeoff))));
    return {};
}

}  // namespace

void addTraceTradeoff(CLI::App& app, cli::Action& action) {
    auto options = std::make_shared<BenchTradeoffOptions>();
    BenchTradeoffOptions& o = *options;
    auto* command = app.add_subcommand(
        "trace-tradeoff",
        "Error against a converged picture, and time, over samples, bounces, denoising and "
        "filtering");
    addBenchStudyOptions(*command, o.study, 256);
    command
        ->add_option("--converged-spp", o.tradeoff.convergedSamples,
                     "Samples of the picture that counts as the truth")
        ->capture_default_str()
        ->check(CLI::Range(64, 1 << 20));
    command->add_option("--plot", o.plot, "Write the curves as SVG");
    cli::addOverwrite(*command, o.overwrite);
    command->add_flag("--json", o.json, "Print JSON instead of a table");
    command->callback([options, &action] { action = [options] { return benchTradeoff(*options); }; });
}

}  // namespace macula::bench
