// The subcommands of macula-bench. Each adds itself to the command line, and leaves its work in `action` when
// the user chose it.
#pragma once

#include <CLI/App.hpp>

#include "cli/shared/program.h"

namespace macula::bench {

void addTrace(CLI::App& app, cli::Action& action);
void addCast(CLI::App& app, cli::Action& action);
void addFoveal(CLI::App& app, cli::Action& action);
void addTraceTradeoff(CLI::App& app, cli::Action& action);
void addLoad(CLI::App& app, cli::Action& action);
void addTrain(CLI::App& app, cli::Action& action);
void addSession(CLI::App& app, cli::Action& action);
void addXr(CLI::App& app, cli::Action& action);
void addEvaluate(CLI::App& app, cli::Action& action);
void addEvaluateEdits(CLI::App& evaluateApp, cli::Action& action);          // a subcommand of evaluate
void addEvaluateInterpolation(CLI::App& evaluateApp, cli::Action& action);  // likewise
void addEvaluateLivePicture(CLI::App& evaluateApp, cli::Action& action);    // likewise
void addEvaluateMotion(CLI::App& evaluateApp, cli::Action& action);         // likewise
void addEvaluateQuality(CLI::App& evaluateApp, cli::Action& action);        // likewise
void addEvaluateSpecks(CLI::App& evaluateApp, cli::Action& action);         // likewise
void addEvaluateTradeoff(CLI::App& evaluateApp, cli::Action& action);       // likewise

}  // namespace macula::bench
