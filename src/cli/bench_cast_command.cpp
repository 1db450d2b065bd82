// macula bench cast [PATH]: the looks that are cast, beside VTK's CPU mapper where that is installed.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/parallel.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "evaluate/bench_study.h"
#include "evaluate/vtk_cast.h"
#include "image/image_file.h"
#include "image/metrics.h"
#include "pipeline/volume/volume_fit.h"
#include "pipeline/volume/window.h"

namespace macula::cli {

namespace {

using Json = nlohmann::ordered_json;
using trace::Look;

struct Options {
    evaluate::BenchStudyOptions study;
    std::filesystem::path pictures;  // a folder; none when empty
    int turns = 5;
    bool json = false;
};

struct Subject {
    const char* name;
    Look look;
    trace::Shading shading;
};
constexpr Subject kSubjects[] = {{"shaded", Look::dvr, trace::Shading::headlight},
                                 {"dvr", Look::dvr, trace::Shading::none},
                                 {"mip", Look::mip, trace::Shading::none},
                                 {"minip", Look::minip, trace::Shading::none},
                                 {"average", Look::average, trace::Shading::none}};

// Samples of the picture that counts as true.
constexpr int kConverged = 16;

struct Contender {
    double firstSeconds = 0.0;    // with what is made once
    std::vector<double> seconds;  // of each further picture
    image::Image picture;
    image::Image converged;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// One sample a pixel, from the first one, into a picture on the host.
Result<image::Image> drawOnce(const evaluate::BenchStudy& study, trace::PathTracer& tracer,
                              const trace::Settings& settings, int samples) {
    MACULA_TRY_VOID(tracer.setSettings(settings));
    MACULA_TRY([[maybe_unused]] const bool all, tracer.trace(samples));
    return study.readShown(tracer);
}

Result<double> timeOnce(const evaluate::BenchStudy& study, trace::PathTracer& tracer,
                        const trace::Settings& settings) {
    const auto since = std::chrono::steady_clock::now();
    MACULA_TRY([[maybe_unused]] const image::Image picture, drawOnce(study, tracer, settings, 1));
    return secondsSince(since);
}

Result<Json> errorOf(const image::Image& converged, const image::Image& picture) {
    MACULA_TRY(const image::Flip flip, image::flip(converged, picture));
    return Json(flip.mean);
}

Result<void> savePng(const std::filesystem::path& path, const image::Image& picture) {
    std::vector<std::uint8_t> rgba;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        rgba.push_back(static_cast<std::uint8_t>(std::lround(picture.pixels[i] * 255.0f)));
        if (i % 3 == 2) rgba.push_back(255);
    }
    return image::writePng(path, picture.width, picture.height, rgba);
}

Result<void> savePictures(const std::filesystem::path& folder, const std::string& name,
                          const Contender& contender) {
    if (folder.empty()) return {};
    MACULA_TRY_VOID(savePng(folder / (name + ".png"), contender.picture));
    return savePng(folder / (name + "-converged.png"), contender.converged);
}

Json toJson(const Contender& contender, Json error) {
    return {{"firstSeconds", contender.firstSeconds},
            {"secondsPerPicture", median(contender.seconds)},
            {"flipToConverged", std::move(error)}};
}

// Both, in turns. Without VTK ours alone, and why is told once.
Result<Json> measure(const Options& options, const evaluate::BenchStudy& study, const Subject& subject,
                     trace::PathTracer& tracer, std::optional<Error>& withoutVtk) {
    const Volume& volume = *study.volume;
    trace::Settings settings{.look = subject.look, .shading = subject.shading};
    if (trace::isProjection(subject.look)) {
        settings.window = subject.look == Look::mip
                              ? maximumWindow(volume)
                              : windowOver({volume.unitsFromStored()(volume.storedRange().low),
                                            volume.unitsFromStored()(volume.storedRange().high)});
    }
    Contender ours;
    MACULA_TRY(ours.firstSeconds, timeOnce(study, tracer, settings));
    std::optional<Error> failure;
    const auto turn = [&] {
        auto taken = timeOnce(study, tracer, settings);
        if (!taken) failure = taken.error();
        ours.seconds.push_back(taken ? *taken : 0.0);
    };
    std::optional<Contender> vtk;
    evaluate::VtkCast theirs;
    if (!withoutVtk) {
        auto cast = evaluate::castWithVtk({.volume = study.volume.get(),
                                           .function = fitted(study.function, *study.volume),
                                           .view = study.view,
                                           .look = subject.look,
                                           .shading = subject.shading != trace::Shading::none,
                                           .window = settings.window.value_or(DisplayWindow{}),
                                           .turns = options.turns,
                                           .threads = coreCount()},
                                          turn);
        if (cast) {
            theirs = std::move(*cast);
            vtk = Contender{theirs.firstSeconds, theirs.seconds, theirs.picture, theirs.converged};
        } else {
            withoutVtk = cast.error();
        }
    }
    while (ours.seconds.size() < std::size_t(options.turns)) turn();
    if (failure) return *failure;
    MACULA_TRY(ours.picture, drawOnce(study, tracer, settings, 1));
    MACULA_TRY(ours.converged, drawOnce(study, tracer, settings, kConverged));

    MACULA_TRY(Json error, errorOf(ours.converged, ours.picture));
    Json result = {{"look", subject.name}, {"ours", toJson(ours, error)}, {"vtk", nullptr}};
    MACULA_TRY_VOID(savePictures(options.pictures, std::string(subject.name) + "-macula", ours));
    if (vtk) {
        MACULA_TRY(Json vtkError, errorOf(vtk->converged, vtk->picture));
        result["vtk"] = toJson(*vtk, vtkError);
        MACULA_TRY(Json fineError, errorOf(vtk->converged, theirs.fine));
        result["vtk"]["stepMm"] = theirs.stepMm;
        result["vtk"]["secondsInThirdSteps"] = theirs.fineSeconds;
        result["vtk"]["flipInThirdSteps"] = fineError;
        std::vector<double> ratios;
        for (std::size_t n = 0; n < vtk->seconds.size(); ++n)
            ratios.push_back(ours.seconds[n] / vtk->seconds[n]);
        result["oursOverVtk"] = median(ratios);
        MACULA_TRY_VOID(savePictures(options.pictures, std::string(subject.name) + "-vtk", *vtk));
    }
    return result;
}

void print(const Json& result) {
    const Json& ours = result["ours"];
    const Json& vtk = result["vtk"];
    fmt::print("{:8}{:9.3f} s {:8.4f}", result["look"].get<std::string>(),
               ours["secondsPerPicture"].get<double>(), ours["flipToConverged"].get<double>());
    if (!vtk.is_null()) {
        fmt::print("{:11.3f} s {:8.4f}{:9.2f}{:11.3f} s {:8.4f}", vtk["secondsPerPicture"].get<double>(),
                   vtk["flipToConverged"].get<double>(), result["oursOverVtk"].get<double>(),
                   vtk["secondsInThirdSteps"].get<double>(), vtk["flipInThirdSteps"].get<double>());
    }
    fmt::print("\n");
    std::fflush(stdout);
}

Result<void> benchCast(const Options& options) {
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    printNotes(study.notes, study.warnings);
    MACULA_TRY(trace::PathTracer tracer, study.makeTracer());
    Json json = describe("cast", study);
    json["threads"] = coreCount();
    json["repetitions"] = options.turns;
    json["results"] = Json::array();
    std::optional<Error> withoutVtk;
    if (!options.json)
        fmt::print(
            "look       a picture     FLIP     VTK (CPU)     FLIP  ours/VTK   in 1/3 steps     FLIP\n");
    progress.beginStage("Measuring", std::size(kSubjects));
    for (const Subject& subject : kSubjects) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "The benchmark was cancelled.", {}, {}};
        MACULA_TRY(Json result, measure(options, study, subject, tracer, withoutVtk));
        if (!options.json) print(result);
        json["results"].push_back(std::move(result));
        progress.advance();
    }
    if (withoutVtk) fmt::print(stderr, "Without VTK: {} {}\n", withoutVtk->message, withoutVtk->hint);
    if (options.json) fmt::print("{}\n", jsonText(json));
    return {};
}

}  // namespace

void addBenchCast(CLI::App& bench, Action& action) {
    auto options = std::make_shared<Options>();
    auto* command =
        bench.add_subcommand("cast", "Ray-cast looks, one sample a pixel, beside VTK's CPU mapper");
    addBenchStudyOptions(*command, options->study, 512);
    command->add_option("--repetitions", options->turns, "Turns; medians are printed")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command
        ->add_option("--pictures", options->pictures,
                     "Folder for each contender's picture, and the converged one it is compared with")
        ->check(CLI::ExistingDirectory);
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &action] { action = [options] { return benchCast(*options); }; });
}

}  // namespace macula::cli
