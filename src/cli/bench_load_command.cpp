// macula bench load PATH: reading headers and loading a series, beside DCMTK and ITK.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/study/study_input.h"
#include "base/atomic_file.h"
#include "base/parallel.h"
#include "base/progress_bar.h"
#include "base/sha256.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "dicom/loader.h"
#include "dicom/scan.h"
#include "evaluate/header_benchmark.h"
#include "evaluate/load_benchmark.h"

namespace macula::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::filesystem::path path;
    std::string series;
    std::filesystem::path baseline;
    int rounds = 5;
    bool json = false;
};

Json toJson(const std::optional<evaluate::LoadBenchmark::Contender>& contender) {
    if (!contender) return nullptr;
    return {{"seconds", contender->seconds},
            {"peakBytes", contender->peakBytes},
            {"secondsOverOurs", contender->secondsOverOurs}};
}

// The ratios that mean something on any machine: larger is better.
constexpr const char* kRatios[] = {"headersOverDcmtk", "itkOverOurs", "dcmtkOverOurs"};

Result<void> compare(const std::filesystem::path& baseline, Json& results) {
    MACULA_TRY(const std::string text, readText(baseline));
    const Json earlier = Json::parse(text, nullptr, false);
    if (earlier.is_discarded() || !earlier.is_object() || earlier.value("benchmark", Json()) != "load" ||
        !earlier.contains("results") || !earlier["results"].is_object()) {
        return Error{ErrorCode::inputNotUsable, "The baseline is no output of macula bench load.",
                     baseline.string(), "Make one with: macula bench load PATH --json > baseline.json"};
    }
    for (const char* name : kRatios) {
        const Json before = earlier["results"].value(name, Json());
        if (!before.is_number() || !results[name].is_number() || before.get<double>() <= 0.0) continue;
        results[std::string(name) + "OverBaseline"] = results[name].get<double>() / before.get<double>();
    }
    return {};
}

// One file for each slice, in their order; nothing when slices are interpolated, or share a file.
std::vector<std::filesystem::path> filesOf(const dicom::Stack& stack) {
    std::vector<std::filesystem::path> files;
    if (!stack.isEven()) return files;
    for (const dicom::Frame& frame : stack.frames) {
        if (frame.instance->frames != 1) return {};
        files.push_back(frame.instance->file);
    }
    return files;
}

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

Result<void> benchLoad(const Options& options) {
    Progress progress(terminalProgressBar(), interruptToken());
    const std::size_t threads = coreCount();
    MACULA_TRY(const evaluate::HeaderBenchmark headers,
               evaluate::benchmarkHeaders(options.path, threads, options.rounds, progress));
    MACULA_TRY(const dicom::Scan scan, dicom::scanFolder(options.path, progress));
    MACULA_TRY(const dicom::Choice chosen, app::chooseVolume(scan, options.series));
    evaluate::LoadBenchmarkOptions loading{
        .files = filesOf(*chosen.stack),
        .load = [&](Progress& quiet) { return dicom::loadVolume(*chosen.series, *chosen.stack, quiet); },
        .threads = threads,
        .rounds = options.rounds};
    MACULA_TRY(const evaluate::LoadBenchmark load, evaluate::benchmarkLoading(loading, progress));
    if (!options.json && options.baseline.empty()) {
        print(headers, load);
        return {};
    }
    const auto ratio = [](const auto& contender) {
        return contender ? Json(contender->secondsOverOurs) : Json();
    };
    Json json = {{"benchmark", "load"},
                 {"version", MACULA_VERSION},
                 {"threads", threads},
                 {"rounds", options.rounds},
                 {"study", sha256Hex(chosen.series->seriesInstanceUid)},
                 {"voxels", load.voxels},
                 {"headers",
                  {{"files", headers.files},
                   {"oursPerSecond", headers.headersPerSecond},
                   {"dcmtkPerSecond", headers.bareDcmtkPerSecond},
                   {"scanPerSecond", headers.scanPerSecond}}},
                 {"loading",
                  {{"bytesBefore", load.bytesBefore},
                   {"ours", toJson(load.ours)},
                   {"itk", toJson(load.itk)},
                   {"dcmtk", toJson(load.dcmtk)},
                   {"voxelsWhereItkDiffers", load.itk ? Json(load.differingVoxels) : Json()}}},
                 {"results",
                  {{"headersOverDcmtk", headers.headersPerSecond / headers.bareDcmtkPerSecond},
                   {"itkOverOurs", ratio(load.itk)},
                   {"dcmtkOverOurs", ratio(load.dcmtk)}}}};
    if (!options.baseline.empty()) MACULA_TRY_VOID(compare(options.baseline, json["results"]));
    fmt::print("{}\n", jsonText(json));
    return {};
}

}  // namespace

void addBenchLoad(CLI::App& bench, Action& action) {
    auto options = std::make_shared<Options>();
    auto* command =
        bench.add_subcommand("load", "Reading headers and loading a series, beside DCMTK and ITK");
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

}  // namespace macula::cli
