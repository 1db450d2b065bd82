// macula-bench evaluate edits [PATH]: what an edit shows before it is traced, as JSON.
#include <CLI/App.hpp>
#include <filesystem>
#include <memory>

#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "bench/study_report.h"
#include "cli/shared/number_range.h"
#include "evaluate/edits.h"
#include "pictures/output_files.h"

namespace macula::bench {

namespace {

struct EvaluateEditsOptions {
    evaluate::BenchStudyOptions study;
    evaluate::EditsOptions edits;
    std::string folder;
};

}  // namespace

void addEvaluateEdits(CLI::App& evaluateApp, cli::Action& action) {
    auto options = std::make_shared<EvaluateEditsOptions>();
    evaluate::EditsOptions& o = options->edits;
    auto* command = evaluateApp.add_subcommand(
        "edits",
        "What is shown while a clip, the curve or the preset is changed, before it is traced; as JSON");
    addBenchStudyOptions(*command, options->study, o.sizePx.y);
    cli::addNumber(*command, "--truth-spp", o.truthSamples, "Of what pictures are compared with", 1, 1 << 20);
    cli::addNumber(*command, "--iterations", o.model.iterations, "Steps of training of the splats", 1,
                   1000000);
    command->add_option("--then-preset", options->study.thenPreset, "Preset that is changed to");
    command->add_option("--pictures", options->folder, "Folder for the pictures that are compared");
    command->callback([options, &action] {
        options->edits.sizePx = {options->study.size, options->study.size};
        options->edits.pictures = options->folder;
        action = [options]() -> Result<void> {
            if (!options->folder.empty()) MACULA_TRY_VOID(pictures::makePictureFolder(options->folder));
            return printReport(options->study, options->edits, evaluate::measureEdits);
        };
    });
}

}  // namespace macula::bench
