// macula bench trace [PATH]: the tracer's speed beside the scalar reference, as JSON.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/name_option.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "evaluate/baseline.h"
#include "evaluate/benchmark_reports.h"

namespace macula::cli {

namespace {

struct BenchOptions {
    evaluate::BenchStudyOptions study;
    std::filesystem::path baseline;
    evaluate::TraceBenchmarkOptions benchmark;
};

Result<void> benchTrace(BenchOptions options) {
    std::optional<evaluate::Baseline> baseline;
    if (!options.baseline.empty()) {
        MACULA_TRY(baseline, evaluate::Baseline::read(options.baseline, "trace"));
    }
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    printNotes(study.notes, study.warnings);
    MACULA_TRY(const auto results, evaluate::benchmarkTracing(study, options.benchmark, progress));
    nlohmann::ordered_json json = reportOf(study, options.benchmark, results);
    if (baseline) baseline->compare(evaluate::kTraceRatios, json["results"]);
    fmt::print("{}\n", jsonText(json));
    return {};
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
    auto options = std::make_shared<BenchOptions>();
    auto* bench = app.add_subcommand("bench", "Measure speed");
    bench->require_subcommand(1);
    auto* command =
        bench->add_subcommand("trace", "The path tracer beside the scalar C++ reference, as JSON");
    addBenchStudyOptions(*command, options->study, 512);
    addBenchCamera(*command, options->study);
    command->add_option("--spp", options->benchmark.samplesPerPixel, "Samples per pixel of one turn")
        ->capture_default_str()
        ->check(CLI::Range(1, 4096));
    command->add_option("--bounces", options->benchmark.bounces, "Vertices of a path")
        ->capture_default_str()
        ->check(CLI::Range(1, trace::kMaxBounces));
    command
        ->add_option("--filter", options->benchmark.filter,
                     "How values between voxels are found (default: one way after the other)")
        ->transform(asFilter())
        ->option_text(kFilterNames);
    command->add_option("--repetitions", options->benchmark.repetitions, "Turns; medians are printed")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->add_option("--baseline", options->baseline, "Output of an earlier run to compare ratios with");
    command->callback([options, &action] { action = [options] { return benchTrace(*options); }; });
    addBenchCast(*bench, action);
    addBenchFoveal(*bench, action);
    addBenchTradeoff(*bench, action);
    addBenchLoad(*bench, action);
    addBenchTrain(*bench, action);
    addBenchSession(*bench, action);
    addBenchXr(*bench, action);
}

}  // namespace macula::cli
