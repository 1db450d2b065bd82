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
#include "cli/lights_choice.h"
#include "cli/output_file.h"
#include "cli/preset_choice.h"
#include "cli/study_input.h"
#include "cli/svg_plot.h"
#include "cli/tradeoff.h"
#include "presets/default_preset.h"

namespace macula::cli {

namespace {

struct Options {
    std::filesystem::path path;
    std::string series;
    std::string preset;
    std::string lights = kDefaultLights;
    std::string device;
    int size = 256;
    std::filesystem::path plot;
    bool json = false;
    TradeoffOptions tradeoff;
};

bool isDenoised(const TradeoffPoint& point) {
    return point.denoising == trace::Denoising::on;
}

double totalMs(const TradeoffPoint& point) {
    return point.traceMs + point.displayMs;
}

// FLIP and PSNR over time, a curve for each number of bounces; dashed where denoised.
std::vector<Plot> plotsOf(const Tradeoff& tradeoff, const TradeoffOptions& options) {
    std::vector<Plot> plots;
    for (const trace::Filter filter : {trace::Filter::stochastic, trace::Filter::trilinear}) {
        Plot flip{.title = fmt::format("Error against time, {} filtering", trace::nameOf(filter)),
                  .xTitle = "ms, for tracing and display",
                  .yTitle = "FLIP to the converged picture",
                  .logarithmicX = true,
                  .logarithmicY = true,
                  .curves = {}};
        Plot psnr = flip;
        psnr.title = fmt::format("PSNR against time, {} filtering", trace::nameOf(filter));
        psnr.yTitle = "PSNR in dB, where matter is";
        psnr.logarithmicY = false;
        for (const bool denoised : {false, true}) {
            for (const int bounces : options.bounces) {
                Curve curve{.name = fmt::format("{} bounce{}{}", bounces, bounces == 1 ? "" : "s",
                                                denoised ? ", denoised" : ""),
                            .x = {},
                            .y = {},
                            .dashed = denoised};
                Curve inDb = curve;
                for (const TradeoffPoint& point : tradeoff.points) {
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

nlohmann::ordered_json toJson(const TradeoffPoint& point) {
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
    if (!options.plot.empty()) MACULA_TRY_VOID(checkFolderOf(options.plot));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(StudyInput study, loadStudy(options.path, options.series, progress));
    bringTo16Bits(study);
    const std::string preset =
        options.preset.empty() ? presets::defaultTransfer(*study.volume) : options.preset;
    MACULA_TRY(const presets::ImportedPreset chosen, choosePreset(preset));
    MACULA_TRY(const trace::Environment environment, chooseLights(options.lights));
    MACULA_TRY(const gpu::Instance instance, gpu::Instance::create());
    gpu::DeviceOptions deviceOptions;
    deviceOptions.preferred = options.device;
    MACULA_TRY(const auto device, gpu::Device::create(instance, deviceOptions));
    options.tradeoff.view = {.camera = frameBox(study.volume->worldBox(), ViewDirection::anterior, 30.0, 1.0),
                             .width = options.size,
                             .height = options.size};
    MACULA_TRY(const Tradeoff tradeoff, measureTradeoff(device, study.volume, chosen.function, environment,
                                                        options.tradeoff, progress));

    if (!options.plot.empty())
        MACULA_TRY_VOID(writeTextAtomically(options.plot, toSvg(plotsOf(tradeoff, options.tradeoff))));
    if (!options.json) {
        fmt::print("{:>10} {:>8} {:>7} {:>7} {:>9} {:>8} {:>7} {:>6}\n", "filter", "denoised", "bounces",
                   "samples", "ms", "PSNR dB", "SSIM", "FLIP");
        for (const TradeoffPoint& p : tradeoff.points) {
            fmt::print("{:>10} {:>8} {:>7} {:>7} {:>9.1f} {:>8.2f} {:>7.4f} {:>6.4f}\n",
                       trace::nameOf(p.filter), isDenoised(p) ? "yes" : "no", p.bounces, p.samples,
                       totalMs(p), p.psnrDb, p.ssim, p.flip);
        }
        return {};
    }
    nlohmann::ordered_json json{{"benchmark", "trace-tradeoff"},
                                {"version", MACULA_VERSION},
                                {"device", device->info().name},
                                {"driver", device->info().driver},
                                {"study", study.seriesDigest},
                                {"preset", publicPresetName(preset)},
                                {"picture", {options.size, options.size}},
                                {"converged",
                                 {{"samples", options.tradeoff.convergedSamples},
                                  {"bounces", options.tradeoff.convergedBounces},
                                  {"ms", tradeoff.convergedMs},
                                  {"flipOfItsHalf", tradeoff.convergedFlip}}},
                                {"results", nlohmann::ordered_json::array()}};
    for (const TradeoffPoint& point : tradeoff.points) json["results"].push_back(toJson(point));
    fmt::print("{}\n", json.dump(4));
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
    command->add_option("path", o.path, "Folder or file with DICOM; the built-in phantom when absent");
    command->add_option("--series", o.series, "Which series: its number in `macula info`, or its UID");
    command->add_option("--preset", o.preset, "Preset by name, number or file; default by modality");
    command->add_option("--lights", o.lights, "Light rig by name or file")->capture_default_str();
    command->add_option("--size", o.size, "Width and height in pixels")
        ->capture_default_str()
        ->check(CLI::Range(16, 4096));
    command
        ->add_option("--converged-spp", o.tradeoff.convergedSamples,
                     "Samples of the picture that counts as the truth")
        ->capture_default_str()
        ->check(CLI::Range(64, 1 << 20));
    command->add_option("--device", o.device, "Device by number or part of its name");
    command->add_option("--plot", o.plot, "Write the curves as SVG");
    command->add_flag("--json", o.json, "Print JSON instead of a table");
    command->callback([options, &action] { action = [options] { return benchTradeoff(*options); }; });
}

}  // namespace macula::cli
