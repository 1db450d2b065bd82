// macula bench foveal [PATH]: one picture for the fovea, its time and its way to a given error, as JSON.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/number_range.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "evaluate/benchmark_reports.h"
#include "pipeline/trace/settings.h"

namespace macula::cli {

namespace {

struct Options {
    evaluate::BenchStudyOptions study;
    evaluate::FovealOptions foveal;
};

Result<void> benchFoveal(const Options& options) {
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    printNotes(study.notes, study.warnings);
    MACULA_TRY(const evaluate::FovealReport report, measureFoveal(study, options.foveal, progress));
    fmt::print("{}\n", jsonText(reportOf(study, options.foveal, report)));
    return {};
}

}  // namespace

void addBenchFoveal(CLI::App& bench, Action& action) {
    auto options = std::make_shared<Options>();
    evaluate::FovealOptions& o = options->foveal;
    auto* command = bench.add_subcommand(
        "foveal",
        "One picture for the fovea, with guides and denoising, beside the scalar C++ reference; and the time "
        "to a given error; as JSON");
    addBenchStudyOptions(*command, options->study, 512);
    command->add_option("--spp", o.samples, "Samples per pixel")
        ->capture_default_str()
        ->check(CLI::Range(1, 4096));
    command->add_option("--bounces", o.bounces, "Vertices of a path")
        ->capture_default_str()
        ->check(CLI::Range(1, trace::kMaxBounces));
    command->add_option("--repetitions", o.repetitions, "Turns; medians are printed")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->add_option("--flip", o.flip, "The error to be reached, against the converged picture")
        ->capture_default_str()
        ->check(between(0.001, 1.0));
    command
        ->add_option("--converged-spp", o.convergedSamples,
                     "Samples of the picture that counts as converged; 0: only the times")
        ->capture_default_str()
        ->check(CLI::Range(0, 1 << 20));
    command->callback([options, &action] { action = [options] { return benchFoveal(*options); }; });
}

}  // namespace macula::cli
