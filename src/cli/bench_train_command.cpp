// macula bench train [PATH]: the stages of training a peripheral model, beside the C++ reference in double.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "base/atomic_file.h"
#include "base/parallel.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "evaluate/bench_study.h"
#include "evaluate/training_benchmark.h"
#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/hybrid/model/initial_splats.h"
#include "pipeline/hybrid/views/view_tracing.h"
#include "pipeline/splat/draw/model_painter.h"

namespace macula::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    evaluate::BenchStudyOptions study;
    std::filesystem::path baseline;
    std::uint32_t splats = 10000;
    int shDegree = hybrid::FirstModelOptions{}.shDegree;  // as models are trained
    int repetitions = 5;
    bool fromVolume = false;
    bool json = false;
};

// What macula train gives its views.
constexpr std::uint32_t kSamplesPerPixel = 2;

double millisecondsOf(const std::function<Result<void>()>& work, Result<void>& done) {
    const auto start = std::chrono::steady_clock::now();
    done = work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// By name, in the order of a step.
std::vector<std::pair<const char*, evaluate::StageBenchmark>> stagesOf(const evaluate::TrainingBenchmark& b) {
    return {{"project", b.project}, {"lists", b.lists}, {"deviceLists", b.deviceLists},
            {"raster", b.raster},   {"loss", b.loss},   {"backward", b.backward},
            {"adam", b.adam},       {"step", b.step}};
}

Json toJson(const evaluate::StageTime& time) {
    return {{"wallMs", time.wallMs}, {"cpuMs", time.cpuMs}};
}

Json toJson(const evaluate::TrainingBenchmark& benchmark, const glm::ivec2& sizePx) {
    Json stages = Json::object();
    for (const auto& [name, stage] : stagesOf(benchmark)) {
        stages[name] = {{"device", toJson(stage.device)},
                        {"reference", stage.reference ? toJson(*stage.reference) : Json()},
                        {"wallRatio", stage.reference ? Json(stage.wallRatio) : Json()},
                        {"cpuRatio", stage.reference ? Json(stage.cpuRatio) : Json()}};
    }
    return {{"picture", {sizePx.x, sizePx.y}},
            {"pairs", benchmark.pairs},
            {"stages", std::move(stages)},
            {"stepsPerSecond", 1000.0 / benchmark.step.device.wallMs}};
}

// The processor time of the process says little about the work of a device that is no CPU.
struct RatioName {
    const char* key;
    const char* header;
};
RatioName ratioNameOf(const gpu::Device& device) {
    return device.isCpu() ? RatioName{"cpuRatio", "CPU ratio"} : RatioName{"wallRatio", "ms ratio"};
}

// Whether it is of the shape that toJson makes.
bool hasStages(const Json& result) {
    return result.is_object() && result.contains("picture") && result.contains("stages") &&
           result["stages"].is_object() &&
           std::all_of(result["stages"].begin(), result["stages"].end(),
                       [](const Json& stage) { return stage.is_object(); });
}

Result<Json> readBaseline(const std::filesystem::path& path) {
    MACULA_TRY(const std::string text, readText(path));
    Json earlier = Json::parse(text, nullptr, false);
    if (earlier.is_object() && earlier.value("benchmark", Json()) == "train" && earlier.contains("results") &&
        earlier["results"].is_array() &&
        std::all_of(earlier["results"].begin(), earlier["results"].end(), hasStages))
        return earlier;
    return Error{ErrorCode::inputNotUsable, "The baseline is no output of macula bench train.", path.string(),
                 "Make one with: macula bench train --json > baseline.json"};
}

// Ratios are only comparable between runs that did the same. Asks for what `report` has so far.
Result<void> checkSame(const Json& earlier, const Json& report, const std::filesystem::path& baseline) {
    for (const auto& [key, what] : {std::pair{"study", "of another series"},
                                    {"preset", "of another preset"},
                                    {"deviceKind", "of another kind of device"},
                                    {"shDegree", "of another degree"},
                                    {"splats", "of another number of splats"}}) {
        if (report.contains(key) && earlier.value(key, Json()) != report[key])
            return Error{ErrorCode::inputNotUsable, fmt::format("The baseline is {}.", what),
                         baseline.string(), "Choose one that was made with the same options."};
    }
    return {};
}

// How the ratios stand against those of an earlier run, by size and stage; nothing where it has none.
void compare(const Json& earlier, const std::string& ratioKey, Json& results) {
    for (Json& result : results) {
        for (const Json& before : earlier["results"]) {
            if (before["picture"] != result["picture"]) continue;
            for (auto& [name, stage] : result["stages"].items()) {
                const Json ratio = before["stages"].value(name, Json::object()).value(ratioKey, Json());
                if (!ratio.is_number() || ratio.get<double>() <= 0.0 || !stage[ratioKey].is_number())
                    continue;
                stage[ratioKey + "OverBaseline"] = stage[ratioKey].get<double>() / ratio.get<double>();
            }
        }
    }
}

void print(const evaluate::TrainingBenchmark& benchmark, const glm::ivec2& sizePx,
           const gpu::Device& device) {
    fmt::print("{} x {}, {} pairs of splats and tiles, {:.1f} steps a second\n", sizePx.x, sizePx.y,
               benchmark.pairs, 1000.0 / benchmark.step.device.wallMs);
    fmt::print("{:>11} {:>10} {:>10} {:>13} {:>13} {:>10}\n", "stage", "ms", "CPU ms", "reference ms",
               "its CPU ms", ratioNameOf(device).header);
    for (const auto& [name, stage] : stagesOf(benchmark)) {
        fmt::print("{:>11} {:>10.2f} {:>10.2f}", name, stage.device.wallMs, stage.device.cpuMs);
        if (stage.reference)
            fmt::print(" {:>13.1f} {:>13.1f} {:>10.4f}", stage.reference->wallMs, stage.reference->cpuMs,
                       device.isCpu() ? stage.cpuRatio : stage.wallRatio);
        fmt::print("\n");
    }
}

// The median of `repetitions` turns, after one that compiles kernels.
Result<double> medianMs(int repetitions, const std::function<Result<void>()>& work) {
    Result<void> done = work();
    std::vector<double> times;
    for (int i = 0; i < repetitions && done; ++i) times.push_back(millisecondsOf(work, done));
    if (!done) return done.error();
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

class Bench {
  public:
    Bench(const evaluate::BenchStudy& study, const Options& options, trace::PathTracer tracer,
          Progress& progress)
        : study_(study), options_(options), tracer_(std::move(tracer)), progress_(progress) {}

    Result<Json> run() {
        progress_.beginStage("Finding points", 1);
        MACULA_TRY_VOID(findModel());
        Json json = {{"splats", model_.size()}, {"results", Json::array()}};
        const glm::ivec2 whole(options_.study.size);
        // Small pictures come first in training.
        for (const glm::ivec2& size : {whole, (whole + 1) / 2}) {
            MACULA_TRY(const evaluate::TrainingBenchmark benchmark, measure(size));
            if (!options_.json && options_.baseline.empty()) print(benchmark, size, *study_.device);
            json["results"].push_back(toJson(benchmark, size));
        }
        if (options_.fromVolume) {
            MACULA_TRY(json["fromVolume"], measureBeginning());
        }
        return json;
    }

  private:
    Result<void> findModel() {
        MACULA_TRY(const trace::SurfacePoints points,
                   tracer_.surfacePoints({.count = options_.splats}, [&] { return !progress_.cancelled(); }));
        if (points.points.empty())
            return Error{ErrorCode::inputNotUsable,
                         "Nothing of the series can be seen.",
                         {},
                         "Choose another preset."};
        model_ = hybrid::initialSplats(points);
        model_.setShDegree(options_.shDegree);
        return {};
    }

    Result<hybrid::TracedView> traceOne(const glm::ivec2& sizePx) {
        MACULA_TRY(auto traced,
                   hybrid::traceViews(tracer_, std::span(&study_.view.camera, 1),
                                      {.sizePx = sizePx, .samplesPerPixel = kSamplesPerPixel}, progress_));
        return std::move(traced.views.front());
    }

    Result<evaluate::TrainingBenchmark> measure(const glm::ivec2& sizePx) {
        MACULA_TRY(hybrid::TracedView traced, traceOne(sizePx));
        MACULA_TRY(const splat::RasterView view, splat::rasterView(traced.camera, sizePx, model_.originMm));
        progress_.beginStage("Measuring", static_cast<std::size_t>(options_.repetitions));
        return evaluate::benchmarkTraining(
            study_.device, model_, {.view = view, .pixels = std::move(traced.rgba)},
            {.trainer = hybrid::trainerOptions({}), .repetitions = options_.repetitions}, progress_);
    }

    // From a volume that is on the device.
    Result<Json> measureBeginning() {
        progress_.beginStage("Measuring the beginning", 1);
        MACULA_TRY(const splat::RasterView view,
                   splat::rasterView(study_.view.camera, glm::ivec2(options_.study.size), model_.originMm));
        const auto firstPicture = [&]() -> Result<void> {
            MACULA_TRY_VOID(findModel());
            MACULA_TRY(auto painter, splat::ModelPainter::create(study_.device, model_));
            MACULA_TRY([[maybe_unused]] const auto picture, painter.draw(view));
            return {};
        };
        const auto tracing = [&]() -> Result<void> {
            MACULA_TRY([[maybe_unused]] const auto traced, traceOne(view.sizePx));
            return {};
        };
        MACULA_TRY(const double pointsMs, medianMs(options_.repetitions, [&] { return findModel(); }));
        MACULA_TRY(const double firstPictureMs, medianMs(options_.repetitions, firstPicture));
        MACULA_TRY(const double viewMs, medianMs(options_.repetitions, tracing));
        if (!options_.json && options_.baseline.empty())
            fmt::print(
                "From a volume on the device: splats from points after {:.0f} ms, their first picture after "
                "{:.0f} ms; tracing a view ({} samples, denoised a little) takes {:.0f} ms\n",
                pointsMs, firstPictureMs, kSamplesPerPixel, viewMs);
        return Json{{"firstSplatsMs", pointsMs},
                    {"firstPictureMs", firstPictureMs},
                    {"tracedViewMs", viewMs},
                    {"samplesPerPixel", kSamplesPerPixel}};
    }

    const evaluate::BenchStudy& study_;
    const Options& options_;
    trace::PathTracer tracer_;
    Progress& progress_;
    splat::Splats model_;
};

Result<void> benchTrain(const Options& options) {
    Progress progress(terminalProgressBar(), interruptToken());
    const bool compares = !options.baseline.empty();
    Json baseline;
    if (compares) {
        MACULA_TRY(baseline, readBaseline(options.baseline));
    }
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    printNotes(study.notes, study.warnings);
    Json json = describe("train", study);
    json["deviceKind"] = gpu::deviceTypeName(study.device->info().type);
    json["referenceThreads"] = coreCount();
    json["repetitions"] = options.repetitions;
    json["shDegree"] = options.shDegree;
    if (compares) MACULA_TRY_VOID(checkSame(baseline, json, options.baseline));
    MACULA_TRY(trace::PathTracer tracer, study.makeTracer());
    Bench bench(study, options, std::move(tracer), progress);
    MACULA_TRY(const Json measured, bench.run());
    json.update(measured);
    if (compares) {
        MACULA_TRY_VOID(checkSame(baseline, json, options.baseline));
        compare(baseline, ratioNameOf(*study.device).key, json["results"]);
    }
    if (!options.json && !compares) return {};
    fmt::print("{}\n", jsonText(json));
    return {};
}

}  // namespace

void addBenchTrain(CLI::App& bench, Action& action) {
    auto options = std::make_shared<Options>();
    Options& o = *options;
    auto* command = bench.add_subcommand(
        "train",
        "The stages of training a peripheral model, in full and half size, beside the C++ reference in "
        "double");
    addBenchStudyOptions(*command, o.study, 512);
    command->add_option("--splats", o.splats, "Of the model, made of as many points on what can be seen")
        ->capture_default_str()
        ->check(CLI::Range(1u, trace::kMaxSurfacePoints));
    command->add_option("--degree", o.shDegree, "Of spherical harmonics")
        ->capture_default_str()
        ->check(CLI::Range(0, 1));
    command->add_option("--repetitions", o.repetitions, "Turns; medians are printed")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->add_flag("--from-volume", o.fromVolume,
                      "Measure too how long the first splats, their first picture, and a traced view take");
    command->add_flag("--json", o.json, "Print JSON instead of tables");
    command->add_option("--baseline", o.baseline, "JSON output of an earlier run to compare ratios with");
    command->callback([options, &action] { action = [options] { return benchTrain(*options); }; });
}

}  // namespace macula::cli
