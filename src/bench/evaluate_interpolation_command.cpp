// macula-bench evaluate interpolation: how smooth surfaces are, and how much of fine detail is left, as JSON.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/progress_bar.h"
#include "bench/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/number_range.h"
#include "cli/shared/output_options.h"
#include "evaluate/interpolation.h"

namespace macula::bench {

namespace {

Result<void> run(const evaluate::InterpolationOptions& options) {
    MACULA_TRY_VOID(check(options));
    Progress progress(terminalProgressBar(), cli::interruptToken());
    MACULA_TRY(const auto report, evaluate::measureInterpolation(options, progress));
    fmt::print("{}\n", cli::jsonText(reportOf(options, report)));
    return {};
}

}  // namespace

void addEvaluateInterpolation(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<evaluate::InterpolationOptions>();
    evaluate::InterpolationOptions& o = *options;
    auto* command = evaluateApp.add_subcommand(
        "interpolation",
        "Ripple of smooth surfaces and contrast of fine detail, by each --filter, beside VTK; as JSON");
    command->add_option("--preset", o.preset, "Of the surfaces, which are water in air")
        ->capture_default_str();
    command->add_option("--lights", o.lights, "Of the surfaces: a name from macula presets, or a file")
        ->capture_default_str();
    command->add_option("--device", o.device, "Number or part of the name, see macula devices");
    cli::addNumber(*command, "--size", o.size, "Of the square pictures of surfaces", 16, 4096);
    cli::addNumber(*command, "--spp", o.samples, "Samples per pixel of each traced picture", 1, 1 << 20);
    command->add_option("--pictures", o.pictures, "Folder for the pictures of surfaces")
        ->check(CLI::ExistingDirectory);
    cli::addOverwrite(*command, o.overwrite);
    command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace macula::bench
