// macula evaluate motion [PATH]: frames after the eye has moved, as JSON.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "evaluate/benchmark_reports.h"

namespace macula::cli {

namespace {

struct Options {
    evaluate::BenchStudyOptions study;
    evaluate::MotionOptions motion;
};

Result<void> evaluateMotion(const Options& options) {
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const evaluate::BenchStudy study, evaluate::openBenchStudy(options.study, progress));
    printNotes(study.notes, study.warnings);
    MACULA_TRY(const evaluate::MotionReport report, measureMotion(study, options.motion, progress));
    fmt::print("{}\n", jsonText(reportOf(study, options.motion, report)));
    return {};
}

}  // namespace

void addEvaluateMotion(CLI::App& evaluateApp, Action& action) {
    auto options = std::make_shared<Options>();
    evaluate::MotionOptions& o = options->motion;
    auto* command = evaluateApp.add_subcommand(
        "motion", "Frames after the eye has moved: reprojected, not reprojected, and splats alone; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    command->add_option("--spp", o.foveaSamples, "Samples per pixel of the fovea")
        ->capture_default_str()
        ->check(CLI::Range(1, 4096));
    command->add_option("--truth-spp", o.truthSamples, "Of what frames are compared with")
        ->capture_default_str()
        ->check(CLI::Range(1, 1 << 20));
    command->add_option("--iterations", o.model.iterations, "Steps of training of the splats")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000000));
    command->callback([options, &action] {
        options->motion.sizePx = {options->study.size, options->study.size};
        action = [options] { return evaluateMotion(*options); };
    });
}

}  // namespace macula::cli
