// macula bench trace-tradeoff [PATH]: error against time, over samples, bounces, denoising and filtering.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "evaluate/bench_study.h"
#include "evaluate/svg_plot.h"
#include "evaluate/tradeoff.h"

namespace macula::cli {

namespace {

struct Options {
    evaluate::BenchStudyOptions study;
    std::filesystem::path plot;
    bool json = false;
    bool overwrite = false;
    evaluate::TradeoffOptions tradeoff;
};

bool isDenoised(const evaluate::TradeoffPoint& point) {
    return point.denoising == trace::Denoising::on;
}

double totalMs(const evaluate::TradeoffPoint& point) {
    return point.traceMs + point.displayMs;
}

// FLIP and PSNR over time, a curve for each number of bounces; dashed where denoised.
std::vector<evaluate::Plot> plotsOf(const evaluate::Tradeoff& tradeoff,
                                    const evaluate::TradeoffOptions& options) {
    std::vector<evaluate::Plot> plots;
    for (const trace::Filter filter : {trace::Filter::stochastic, trace::Filter::trilinear}) {
        evaluate::Plot flip{.title = fmt::format("Error against time, {} filtering", trace::nameOf(filter)),
                            .xTitle = "ms, for tracing and display",
                            .yTitle = "FLIP to the converged picture",
                            .logarithmicX = true,
                            .logarithmicY = true,
                            .curves = {}};
        evaluate::Plot psnr = flip;
        psnr.title = fmt::format("PSNR against time, {} filtering", trace::nameOf(filter));
        psnr.yTitle = "PSNR in dB, where matter is";
        psnr.logarithmicY = false;
        for (const bool denoised : {false, true}) {
            for (const int bounces : options.bounces) {
                evaluate::Curve curve{.name = fmt::format("{} bounce{}{}", bounces, bounces == 1 ? "" : "s",
                                                          denoised ? ", denoised" : ""),
                                      .x = {},
                                      .y = {},
                                      .dashed = denoised};
                evaluate::Curve inDb = curve;
                for (const evaluate::TradeoffPoint& point : tradeoff.points) {
                    if (point.filter != filter || point.bounces != bounces || isDenoised(point) != denoised)
                        continue;
                    curve.x.push_back(totalMs(point));
                    curve.y.push_back(point.flip);
                    inDb.x.push_back(totalMs(point));
                    inDb.y.push_back(point.psnrDb);
                }
                flip.curves.push_back(std::move(curve));
                psnr.curves.push_back(std::move(inDb));
            }
        }
        plots.push_back(std::move(flip));
        plots.push_back(std::move(psnr));
    }
    return plots;
}

nlohmann::ordered_json toJson(const evaluate::TradeoffPoint& point) {
    return {{"filter", trace::nameOf(point.filter)},
            {"denoised", isDenoised(point)},
            {"bounces", point.bounces},
            {"samples", point.samples},
            {"traceMs", point.traceMs},
            {"displayMs", point.displayMs},
            {"psnrDb", point.psnrDb},
            {"ssim", point.ssim},
            {"flip", point.flip}};
}

Result<void> benchTradeoff(Options options) {
    OutputFiles files(options.overwrite);
    files.read(options.study.path);
    MACULA_TRY_VOID(files.write(options.plot));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    printNotes(study.notes, study.warnings);
    MACULA_TRY(const evaluate::Tradeoff tradeoff, measureTradeoff(study, options.tradeoff, progress));
    if (tradeoff.convergedLost > 0) {
        printNote(fmt::format("The converged picture lacks {} samples, which were too long or not a number.",
                              tradeoff.convergedLost));
    }
    if (options.json) {
        nlohmann::ordered_json json = describe("trace-tradeoff", study);
        json["converged"] = {{"samples", options.tradeoff.convergedSamples},
                             {"bounces", options.tradeoff.convergedBounces},
                             {"lost", tradeoff.convergedLost},
                             {"ms", tradeoff.convergedMs},
                             {"flipOfItsHalf", tradeoff.convergedFlip}};
        json["results"] = nlohmann::ordered_json::array();
        for (const evaluate::TradeoffPoint& point : tradeoff.points) json["results"].push_back(toJson(point));
        fmt::print("{}\n", jsonText(json));
    } else {
        fmt::print("{:>10} {:>8} {:>7} {:>7} {:>9} {:>8} {:>7} {:>6}\n", "filter", "denoised", "bounces",
                   "samples", "ms", "PSNR dB", "SSIM", "FLIP");
        for (const evaluate::TradeoffPoint& p : tradeoff.points) {
            fmt::print("{:>10} {:>8} {:>7} {:>7} {:>9.1f} {:>8.2f} {:>7.4f} {:>6.4f}\n",
                       trace::nameOf(p.filter), isDenoised(p) ? "yes" : "no", p.bounces, p.samples,
                       totalMs(p), p.psnrDb, p.ssim, p.flip);
        }
    }
    // Last: what was measured is told even where the plot cannot be written.
    if (!options.plot.empty())
        MACULA_TRY_VOID(writeTextAtomically(options.plot, toSvg(plotsOf(tradeoff, options.tradeoff))));
    return {};
}

}  // namespace

void addBenchTradeoff(CLI::App& bench, Action& action) {
    auto options = std::make_shared<Options>();
    Options& o = *options;
    auto* command = bench.add_subcommand(
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
    addOverwrite(*command, o.overwrite);
    command->add_flag("--json", o.json, "Print JSON instead of a table");
    command->callback([options, &action] { action = [options] { return benchTradeoff(*options); }; });
}

}  // namespace macula::cli
