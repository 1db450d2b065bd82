// macula-bench trace [PATH]: the tracer's speed beside the scalar reference, as JSON.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/progress_bar.h"
#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/name_option.h"
#include "cli/shared/report.h"
#include "evaluate/baseline.h"
#include "evaluate/benchmark_reports.h"

namespace macula::bench {

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
    Progress progress(terminalProgressBar(), cli::interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    cli::printNotes(study.notes, study.warnings);
    MACULA_TRY(const auto results, evaluate::benchmarkTracing(study, options.benchmark, progress));
    nlohmann::ordered_json json = reportOf(study, options.benchmark, results);
    if (baseline) baseline->compare(evaluate::kTraceRatios, json["results"]);
    fmt::print("{}\n", cli::jsonText(json));
    return {};
}

}  // namespace

void addTrace(CLI::App& app, cli::Action& action) {
    auto options = std::make_shared<BenchOptions>();
    auto* command = app.add_subcommand("trace", "The path tracer beside the scalar C++ reference, as JSON");
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
        ->transform(cli::asFilter())
        ->option_text(cli::kFilterNames);
    command->add_option("--repetitions", options->benchmark.repetitions, "Turns; medians are printed")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->add_option("--baseline", options->baseline, "Output of an earlier run to compare ratios with");
    command->callback([options, &action] { action = [options] { return benchTrace(*options); }; });
}

}  // namespace macula::bench
