// macula bench trace [PATH]: the tracer's speed beside the scalar reference, as JSON.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/parallel.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "evaluate/bench_study.h"
#include "evaluate/trace_benchmark.h"

namespace macula::cli {

namespace {

struct Options {
    evaluate::BenchStudyOptions study;
    std::filesystem::path baseline;
    evaluate::TraceBenchmarkOptions benchmark;
};

nlohmann::ordered_json toJson(const evaluate::TraceBenchmark::Contender& contender) {
    return {{"secondsPerSample", contender.secondsPerSample},
            {"cpuSecondsPerSample", contender.cpuSecondsPerSample},
            {"microsecondsPerPixel", contender.microsecondsPerPixel}};
}

// How the ratios stand against those of an earlier run, by filter; nothing when that file has none.
Result<void> compare(const std::filesystem::path& baseline, nlohmann::ordered_json& results) {
    MACULA_TRY(const std::string text, readText(baseline));
    const auto earlier = nlohmann::ordered_json::parse(text, nullptr, false);
    if (earlier.is_discarded() || !earlier.contains("results") || !earlier["results"].is_array()) {
        return Error{ErrorCode::inputNotUsable, "The baseline is no output of macula bench.",
                     baseline.string(), "Make one with: macula bench trace > baseline.json"};
    }
    for (auto& result : results) {
        for (const auto& before : earlier["results"]) {
            const bool usable =
                before.is_object() && before.contains("cpuRatio") && before["cpuRatio"].is_number();
            if (!usable || before.value("filter", nlohmann::ordered_json()) != result["filter"]) continue;
            result["cpuRatioOverBaseline"] =
                result["cpuRatio"].get<double>() / before["cpuRatio"].get<double>();
        }
    }
    return {};
}

Result<void> benchTrace(Options options) {
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    printNotes(study.notes, study.warnings);
    options.benchmark.view = study.view;
    MACULA_TRY(const auto reports,
               evaluate::benchmarkTracing(study.device, study.volume, study.function, study.environment,
                                          options.benchmark, progress));

    nlohmann::ordered_json json = describe("trace", study);
    json["referenceThreads"] = coreCount();
    json["bounces"] = options.benchmark.settings.bounces;
    json["samplesPerPixel"] = options.benchmark.samplesPerPixel;
    json["repetitions"] = options.benchmark.repetitions;
    json["results"] = nlohmann::ordered_json::array();
    for (const evaluate::TraceBenchmark& report : reports) {
        json["results"].push_back({{"filter", trace::nameOf(report.filter)},
                                   {"device", toJson(report.device)},
                                   {"reference", toJson(report.reference)},
                                   {"wallRatio", report.wallRatio},
                                   {"cpuRatio", report.cpuRatio}});
    }
    if (!options.baseline.empty()) MACULA_TRY_VOID(compare(options.baseline, json["results"]));
    fmt::print("{}\n", jsonText(json));
    return {};
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    auto* bench = app.add_subcommand("bench", "Measure speed");
    bench->require_subcommand(1);
    auto* command =
        bench->add_subcommand("trace", "The path tracer beside the scalar C++ reference, as JSON");
    addBenchStudyOptions(*command, options->study, 512);
    command->add_option("--spp", options->benchmark.samplesPerPixel, "Samples per pixel of one turn")
        ->capture_default_str()
        ->check(CLI::Range(1, 4096));
    command->add_option("--bounces", options->benchmark.settings.bounces, "Vertices of a path")
        ->capture_default_str()
        ->check(CLI::Range(1, trace::kMaxBounces));
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
}

}  // namespace macula::cli
