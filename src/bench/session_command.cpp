// macula-bench session [PATH]: a model is saved while frames are drawn, and opened again, as JSON.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <memory>

#include "bench/bench_study_options.h"
#include "bench/command.h"
#include "bench/study_report.h"
#include "cli/shared/number_range.h"
#include "evaluate/store_round_trip.h"

namespace macula::bench {

void addSession(CLI::App& app, cli::Action& action) {
    auto options = std::make_shared<StudyAnd<evaluate::StoreRoundTripOptions>>();
    evaluate::StoreRoundTripOptions& o = options->measured;
    auto* command =
        app.add_subcommand("session",
                           "What it costs to keep a model between runs: saving it while frames are drawn, "
                           "and opening it again; as JSON");
    addBenchStudyOptions(*command, options->study, 512);
    command->add_option("--learn", o.learnS, "Seconds for the model to learn; until it can be drawn at least")
        ->check(cli::between(0.0, 3600.0))
        ->capture_default_str();
    cli::addNumber(*command, "--frames", o.frames, "Of a block: one turn around the patient", 10, 10'000);
    cli::addNumber(*command, "--blocks", o.blocks, "Blocks of frames with saving, and as many without", 1,
                   1000);
    command->add_option("--sessions", o.folder, "New or empty folder to save in; without it a temporary one")
        ->option_text("FOLDER");
    command->add_flag("--large", o.large,
                      "Measure too a store of 10 000 studies and 2 000 models, which takes minutes to make");
    command->callback([options, &action] {
        action = [options] { return checkAndPrintReport(*options, evaluate::measureSession); };
    });
}

}  // namespace macula::bench
