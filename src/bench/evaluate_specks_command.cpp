// macula-bench evaluate specks [PATH]: pixels that stand out of denoised pictures of few samples, as JSON.
#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <memory>

#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "bench/study_report.h"
#include "cli/shared/name_option.h"
#include "cli/shared/number_range.h"
#include "evaluate/specks.h"

namespace macula::bench {

namespace {

struct EvaluateSpecksOptions {
    evaluate::BenchStudyOptions study;
    evaluate::SpecksOptions specks;
};

}  // namespace

void addEvaluateSpecks(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<EvaluateSpecksOptions>();
    evaluate::SpecksOptions& o = options->specks;
    auto* command = evaluateApp.add_subcommand(
        "specks",
        "Pixels that stand out of denoised pictures of few samples, beside the converged one; as JSON");
    addBenchStudyOptions(*command, options->study, options->study.size);
    command
        ->add_option("--samples", o.samples, "Samples per pixel of these pictures (default: 1 2 4 16 64 256)")
        ->check(CLI::Range(1u, 1u << 20))
        ->option_text("N...");
    cli::addNumber(*command, "--truth-spp", o.convergedSamples, "Of the converged picture", 2, 1 << 20);
    command->add_option("--filter", o.filter, "How values between voxels are found, see docs/presets.md")
        ->transform(cli::asFilter())
        ->option_text(cli::kFilterNames);
    command->callback([options, &action] {
        action = [options] {
            return checkAndPrintReport(options->study, options->specks, evaluate::measureSpecks);
        };
    });
}

}  // namespace macula::bench
