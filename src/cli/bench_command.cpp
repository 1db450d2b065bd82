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
#include "cli/lights_choice.h"
#include "cli/preset_choice.h"
#include "cli/study_input.h"
#include "pipeline/trace/benchmark.h"
#include "presets/default_preset.h"

namespace macula::cli {

namespace {

struct Options {
    std::filesystem::path path;
    std::string series;
    std::string preset;
    std::string lights = kDefaultLights;
    std::string device;
    int size = 512;
    std::filesystem::path baseline;
    trace::BenchmarkOptions benchmark;
};

nlohmann::ordered_json toJson(const trace::BenchmarkReport::Contender& contender) {
    return {{"msPerSamplePerPixel", contender.wallMsPerSample},
            {"wallMsPerPicture", contender.wallMsPerPicture},
            {"cpuMsPerPicture", contender.cpuMsPerPicture}};
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
    MACULA_TRY(StudyInput study, loadStudy(options.path, options.series, progress));
    bringTo16Bits(study);
    const std::string preset =
        options.preset.empty() ? presets::defaultTransfer(*study.volume) : options.preset;
    MACULA_TRY(const presets::ImportedPreset chosen, choosePreset(preset));
    const TransferFunction& function = chosen.function;
    MACULA_TRY(const trace::Environment environment, chooseLights(options.lights));
    MACULA_TRY(const gpu::Instance instance, gpu::Instance::create());
    gpu::DeviceOptions deviceOptions;
    deviceOptions.preferred = options.device;
    MACULA_TRY(const auto device, gpu::Device::create(instance, deviceOptions));
    options.benchmark.view = {
        .camera = frameBox(study.volume->worldBox(), ViewDirection::anterior, 30.0, 1.0),
        .width = options.size,
        .height = options.size};
    MACULA_TRY(const auto reports,
               trace::benchmark(device, study.volume, function, environment, options.benchmark, progress));

    const glm::ivec3 voxels = study.volume->size();
    nlohmann::ordered_json json{{"benchmark", "trace"},
                                {"version", MACULA_VERSION},
                                {"device", device->info().name},
                                {"driver", device->info().driver},
                                {"referenceThreads", coreCount()},
                                {"study", study.seriesDigest},
                                {"voxels", {voxels.x, voxels.y, voxels.z}},
                                {"preset", publicPresetName(preset)},
                                {"picture", {options.size, options.size}},
                                {"bounces", options.benchmark.settings.bounces},
                                {"samplesPerPixel", options.benchmark.samplesPerPixel},
                                {"repetitions", options.benchmark.repetitions},
                                {"results", nlohmann::ordered_json::array()}};
    for (const trace::BenchmarkReport& report : reports) {
        json["results"].push_back({{"filter", trace::nameOf(report.filter)},
                                   {"device", toJson(report.device)},
                                   {"reference", toJson(report.reference)},
                                   {"wallRatio", report.wallRatio},
                                   {"cpuRatio", report.cpuRatio}});
    }
    if (!options.baseline.empty()) MACULA_TRY_VOID(compare(options.baseline, json["results"]));
    fmt::print("{}\n", json.dump(4));
    return {};
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    auto* bench = app.add_subcommand("bench", "Measure speed");
    bench->require_subcommand(1);
    auto* command =
        bench->add_subcommand("trace", "The path tracer beside the scalar C++ reference, as JSON");
    command->add_option("path", options->path, "Folder or file with DICOM; the built-in phantom when absent");
    command->add_option("--series", options->series, "Which series: its number in `macula info`, or its UID");
    command->add_option("--preset", options->preset, "Preset by name, number or file; default by modality");
    command->add_option("--lights", options->lights, "Light rig by name or file")->capture_default_str();
    command->add_option("--size", options->size, "Width and height in pixels")
        ->capture_default_str()
        ->check(CLI::Range(8, 4096));
    command->add_option("--spp", options->benchmark.samplesPerPixel, "Samples per pixel of one turn")
        ->capture_default_str()
        ->check(CLI::Range(1, 4096));
    command->add_option("--bounces", options->benchmark.settings.bounces, "Vertices of a path")
        ->capture_default_str()
        ->check(CLI::Range(1, trace::kMaxBounces));
    command->add_option("--repetitions", options->benchmark.repetitions, "Turns; medians are printed")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->add_option("--device", options->device, "Device by number or part of its name");
    command->add_option("--baseline", options->baseline, "Output of an earlier run to compare ratios with");
    command->callback([options, &action] { action = [options] { return benchTrace(*options); }; });
    addBenchTradeoff(*bench, action);
    addBenchLoad(*bench, action);
}

}  // namespace macula::cli
