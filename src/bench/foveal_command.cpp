// macula-bench foveal [PATH]: one picture for the fovea, its time and its way to a given error, as JSON.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>

#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "bench/study_report.h"
#include "cli/shared/name_option.h"
#include "cli/shared/number_range.h"
#include "pipeline/trace/settings.h"

namespace macula::bench {

void addFoveal(CLI::App& app, cli::Action& action) {
    auto options = std::make_shared<StudyAnd<evaluate::FovealOptions>>();
    evaluate::FovealOptions& o = options->measured;
    auto* command = app.add_subcommand(
        "foveal",
        "One picture for the fovea, with guides and denoising, beside the scalar C++ reference; and the time "
        "to a given error; as JSON");
    addBenchStudyOptions(*command, options->study, 512);
    addBenchCamera(*command, options->study);
    cli::addNumber(*command, "--spp", o.samples, "Samples per pixel", 1, 4096);
    cli::addNumber(*command, "--bounces", o.bounces, "Vertices of a path", 1, trace::kMaxBounces);
    command->add_option("--filter", o.filter, "How values between voxels are found (default: trilinear)")
        ->transform(cli::asFilter())
        ->option_text(cli::kFilterNames);
    cli::addNumber(*command, "--repetitions", o.repetitions, "Turns; medians are printed", 1, 1000);
    command->add_option("--flip", o.flip, "The error to be reached, against the converged picture")
        ->capture_default_str()
        ->check(cli::between(0.001, 1.0));
    cli::addNumber(*command, "--converged-spp", o.convergedSamples,
                   "Samples of the picture that counts as converged; 0: only the times", 0, 1 << 20);
    cli::addNumber(*command, "--side-by-side", o.sideBySide,
                   "Samples of a pixel that are traced side by side; 0: as many as the device likes", 0, 64);
    command->callback([options, &action] {
        action = [options] { return printReport(*options, evaluate::measureFoveal); };
    });
}

}  // namespace macula::bench
