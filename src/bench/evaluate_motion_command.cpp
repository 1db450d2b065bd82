// macula-bench evaluate motion [PATH]: frames after the eye has moved, as JSON.
#include <CLI/App.hpp>
#include <memory>
#include <string>

#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "bench/study_report.h"
#include "cli/shared/number_range.h"
#include "pictures/output_files.h"

namespace macula::bench {

namespace {

struct EvaluateMotionOptions {
    evaluate::BenchStudyOptions study;
    evaluate::MotionOptions motion;
    std::string folder;
};

}  // namespace

void addEvaluateMotion(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<EvaluateMotionOptions>();
    evaluate::MotionOptions& o = options->motion;
    auto* command = evaluateApp.add_subcommand(
        "motion", "Frames after the eye has moved: reprojected, not reprojected, and splats alone; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    cli::addNumber(*command, "--spp", o.foveaSamples, "Samples per pixel of the fovea", 1, 4096);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what frames are compared with", 1, 1 << 20);
    cli::addNumber(*command, "--iterations", o.model.iterations, "Steps of training of the splats", 1,
                   1000000);
    command->add_option("--pictures", options->folder, "Folder for the frames that are compared");
    command->callback([options, &action] {
        options->motion.pictures = options->folder;
        options->motion.sizePx = {options->study.size, options->study.size};
        action = [options]() -> Result<void> {
            if (!options->folder.empty()) MACULA_TRY_VOID(pictures::makePictureFolder(options->folder));
            return printReport(options->study, options->motion, evaluate::measureMotion);
        };
    });
}

}  // namespace macula::bench
