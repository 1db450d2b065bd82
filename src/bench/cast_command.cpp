// macula-bench cast [PATH]: the looks that are cast, beside VTK's CPU mapper where that is installed.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/progress_bar.h"
#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "evaluate/benchmark_reports.h"

namespace macula::bench {

namespace {

struct BenchCastOptions {
    evaluate::BenchStudyOptions study;
    std::filesystem::path pictures;  // a folder; none when empty
    int turns = 5;
    bool json = false;
};

void print(const evaluate::CastBenchmark& result) {
    fmt::print("{:8}{:9.3f} s {:8.4f}", result.subject, result.ours.secondsPerPicture, result.ours.flip);
    if (const auto& vtk = result.vtk) {
        fmt::print("{:11.3f} s {:8.4f}{:9.2f}{:11.3f} s {:8.4f}", vtk->time.secondsPerPicture, vtk->time.flip,
                   result.oursOverVtk, vtk->secondsInThirdSteps, vtk->flipInThirdSteps);
    }
    fmt::print("\n");
    std::fflush(stdout);
}

Result<void> benchCast(const BenchCastOptions& options) {
    Progress progress(terminalProgressBar(), cli::interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    cli::printNotes(study.notes, study.warnings);
    MACULA_TRY(evaluate::CastBench bench, evaluate::CastBench::create(study, options.turns));
    std::vector<evaluate::CastBenchmark> results;
    if (!options.json)
        fmt::print(
            "look       a picture     FLIP     VTK (CPU)     FLIP  ours/VTK   in 1/3 steps     FLIP\n");
    progress.beginStage(Text("Measuring"), evaluate::kCastSubjects.size());
    for (const evaluate::CastSubject& subject : evaluate::kCastSubjects) {
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("The benchmark was cancelled."), {}, {}};
        MACULA_TRY(evaluate::CastBenchmark result, bench.measure(subject));
        if (!options.pictures.empty()) MACULA_TRY_VOID(writePictures(result, options.pictures));
        if (!options.json) print(result);
        results.push_back(std::move(result));
        progress.advance();
    }
    if (const auto& why = bench.withoutVtk())
        fmt::print(stderr, "Without VTK: {} {}\n", why->message.english(), why->hint.english());
    if (options.json) fmt::print("{}\n", cli::jsonText(reportOf(study, options.turns, results)));
    return {};
}

}  // namespace

void addCast(CLI::App& app, cli::Action& action) {
    auto options = std::make_shared<BenchCastOptions>();
    auto* command = app.add_subcommand("cast", "Ray-cast looks, one sample a pixel, beside VTK's CPU mapper");
    addBenchStudyOptions(*command, options->study, 512);
    addBenchCamera(*command, options->study);
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

}  // namespace macula::bench
