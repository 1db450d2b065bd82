// macula-bench train [PATH]: the stages of training a peripheral model, beside the C++ reference in double.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <utility>

#include "base/progress_bar.h"
#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "evaluate/baseline.h"
#include "evaluate/benchmark_reports.h"

namespace macula::bench {

namespace {

struct BenchTrainOptions {
    evaluate::BenchStudyOptions study;
    evaluate::StudyTrainingOptions training;
    std::filesystem::path baseline;
    bool fromVolume = false;
    bool json = false;
};

void print(const evaluate::SizedTrainingBenchmark& sized, const gpu::Device& device) {
    const evaluate::TrainingBenchmark& benchmark = sized.training;
    fmt::print("{} x {}, {} pairs of splats and tiles, {:.1f} steps a second\n", sized.sizePx.x,
               sized.sizePx.y, benchmark.pairs, stepsPerSecond(benchmark));
    fmt::print("{:>11} {:>10} {:>10} {:>13} {:>13} {:>10}\n", "stage", "ms", "CPU ms", "reference ms",
               "its CPU ms", device.isCpu() ? "CPU ratio" : "ms ratio");
    for (const auto& [name, stage] : stagesOf(benchmark)) {
        fmt::print("{:>11} {:>10.2f} {:>10.2f}", name, stage.device.wallMs, stage.device.cpuMs);
        if (stage.reference)
            fmt::print(" {:>13.1f} {:>13.1f} {:>10.4f}", stage.reference->wallMs, stage.reference->cpuMs,
                       device.isCpu() ? stage.ratio.cpu : stage.ratio.wall);
        fmt::print("\n");
    }
}

void print(const evaluate::BeginningBenchmark& beginning) {
    fmt::print(
        "From a volume on the device: splats from points after {:.0f} ms, their first picture after "
        "{:.0f} ms; tracing a view ({} samples, denoised a little) takes {:.0f} ms\n",
        beginning.firstSplatsMs, beginning.firstPictureMs, evaluate::StudyTrainingBench::kSamplesPerPixel,
        beginning.tracedViewMs);
}

Result<evaluate::StudyTrainingReport> measure(const evaluate::BenchStudy& study,
                                              const BenchTrainOptions& options, Progress& progress) {
    const bool isTold = !options.json && options.baseline.empty();
    MACULA_TRY(auto bench, evaluate::StudyTrainingBench::create(study, options.training, progress));
    evaluate::StudyTrainingReport report{.splats = bench.splats()};
    const glm::ivec2 whole(options.study.size);
    // Small pictures come first in training.
    for (const glm::ivec2& size : {whole, (whole + 1) / 2}) {
        MACULA_TRY(evaluate::SizedTrainingBenchmark sized, bench.measure(size));
        if (isTold) print(sized, *study.device);
        report.results.push_back(std::move(sized));
    }
    if (options.fromVolume) {
        MACULA_TRY(report.fromVolume, bench.measureBeginning(whole));
        if (isTold) print(*report.fromVolume);
    }
    return report;
}

Result<void> benchTrain(const BenchTrainOptions& options) {
    Progress progress(terminalProgressBar(), cli::interruptToken());
    std::optional<evaluate::Baseline> baseline;
    if (!options.baseline.empty()) {
        MACULA_TRY(baseline, evaluate::Baseline::read(options.baseline, "train"));
    }
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    cli::printNotes(study.notes, study.warnings);
    nlohmann::ordered_json json = beginningOf(study, options.training);
    if (baseline) MACULA_TRY_VOID(baseline->checkSame(json));
    MACULA_TRY(const evaluate::StudyTrainingReport report, measure(study, options, progress));
    json.update(toJson(report));
    if (baseline) {
        MACULA_TRY_VOID(baseline->checkSame(json));
        const std::string_view ratio = evaluate::trainingRatioOf(*study.device);
        baseline->compare(std::span(&ratio, 1), json["results"]);
    }
    if (options.json || baseline) fmt::print("{}\n", cli::jsonText(json));
    return {};
}

}  // namespace

void addTrain(CLI::App& app, cli::Action& action) {
    auto options = std::make_shared<BenchTrainOptions>();
    BenchTrainOptions& o = *options;
    auto* command = app.add_subcommand(
        "train",
        "The stages of training a peripheral model, in full and half size, beside the C++ reference in "
        "double");
    addBenchStudyOptions(*command, o.study, 512);
    command
        ->add_option("--splats", o.training.splats,
                     "Of the model, made of as many points on what can be seen")
        ->capture_default_str()
        ->check(CLI::Range(1u, trace::kMaxSurfacePoints));
    command->add_option("--degree", o.training.shDegree, "Of spherical harmonics")
        ->capture_default_str()
        ->check(CLI::Range(0, 1));
    command->add_option("--repetitions", o.training.repetitions, "Turns; medians are printed")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->add_flag("--from-volume", o.fromVolume,
                      "Measure too how long the first splats, their first picture, and a traced view take");
    command->add_flag("--json", o.json, "Print JSON instead of tables");
    command->add_option("--baseline", o.baseline, "JSON output of an earlier run to compare ratios with");
    command->callback([options, &action] { action = [options] { return benchTrain(*options); }; });
}

}  // namespace macula::bench
