// macula-bench load PATH: reading headers and loading a series, beside DCMTK and ITK.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/parallel.h"
#include "base/progress_bar.h"
#include "base/sha256.h"
#include "bench/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "dicom/loader.h"
#include "dicom/scan.h"
#include "evaluate/baseline.h"
#include "evaluate/benchmark_reports.h"
#include "study/open/loaded_study.h"

namespace macula::bench {

namespace {

struct BenchLoadOptions {
    std::filesystem::path path;
    std::string series;
    std::filesystem::path baseline;
    int rounds = 5;
    bool json = false;
};

void print(const evaluate::HeaderBenchmark& headers, const evaluate::LoadBenchmark& load) {
    constexpr double kMiB = 1 << 20;
    fmt::print(
        "Headers: {:.0f}/s, a bare DCMTK loop {:.0f}/s: {:.2f} times as fast; {:.0f} files/s with sorting\n",
        headers.headersPerSecond, headers.bareDcmtkPerSecond,
        headers.headersPerSecond / headers.bareDcmtkPerSecond, headers.scanPerSecond);
    fmt::print("Loading: {:.3f} s, {:.0f} MiB at most\n", load.ours.seconds,
               double(load.ours.peakBytes) / kMiB);
    for (const auto& [name, contender] :
         {std::pair{"ITK", &load.itk}, std::pair{"A bare DCMTK loop", &load.dcmtk}}) {
        if (!*contender) {
            fmt::print("{}: cannot read this series\n", name);
            continue;
        }
        fmt::print("{}: {:.3f} s, {:.0f} MiB at most; {:.2f} times our time\n", name, (*contender)->seconds,
                   double((*contender)->peakBytes) / kMiB, (*contender)->secondsOverOurs);
    }
    if (load.itk && load.differingVoxels > 0) {
        fmt::print("ITK's value differs in {} of {} voxels\n", load.differingVoxels, load.voxels);
    }
}

Result<void> benchLoad(const BenchLoadOptions& options) {
    std::optional<evaluate::Baseline> baseline;
    if (!options.baseline.empty()) {
        MACULA_TRY(baseline, evaluate::Baseline::read(options.baseline, "load"));
    }
    Progress progress(terminalProgressBar(), cli::interruptToken());
    const std::size_t threads = coreCount();
    MACULA_TRY(const evaluate::HeaderBenchmark headers,
               evaluate::benchmarkHeaders(options.path, threads, options.rounds, progress));
    MACULA_TRY(const dicom::Scan scan, dicom::scanFolder(options.path, progress));
    MACULA_TRY(const dicom::ChosenStack chosen, study::chooseVolume(scan, options.series));
    const evaluate::LoadBenchmarkOptions loading{
        .files = evaluate::filesOf(*chosen.stack),
        .load = [&](Progress& quiet) { return dicom::loadVolume(*chosen.series, *chosen.stack, quiet); },
        .threads = threads,
        .rounds = options.rounds};
    MACULA_TRY(const evaluate::LoadBenchmark load, evaluate::benchmarkLoading(loading, progress));
    if (!options.json && !baseline) {
        print(headers, load);
        return {};
    }
    auto json = evaluate::reportOf(sha256Hex(chosen.series->seriesInstanceUid), headers, loading, load);
    if (baseline) baseline->compare(evaluate::kLoadRatios, json["results"]);
    fmt::print("{}\n", cli::jsonText(json));
    return {};
}

}  // namespace

void addLoad(CLI::App& app, cli::Action& action) {
    auto options = std::make_shared<BenchLoadOptions>();
    auto* command = app.add_subcommand("load", "Reading headers and loading a series, beside DCMTK and ITK");
    command->add_option("PATH", options->path, "Folder with DICOM files")->required();
    command->add_option("--series", options->series,
                        "Place in the list of macula info, or series UID (default: the best)");
    command->add_option("--repetitions", options->rounds, "Turns; medians are printed")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->add_flag("--json", options->json, "Print JSON");
    command->add_option("--baseline", options->baseline,
                        "JSON output of an earlier run to compare ratios with");
    command->callback([options, &action] { action = [options] { return benchLoad(*options); }; });
}

}  // namespace macula::bench
