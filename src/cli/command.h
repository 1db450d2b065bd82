// The subcommands. Each adds itself to the command line, and leaves its work in `action` when the user chose
// it.
#pragma once

#include <CLI/App.hpp>
#include <functional>

#include "base/result.h"

namespace macula::cli {

using Action = std::function<Result<void>()>;

void addInfo(CLI::App& app, Action& action);
void addHybrid(CLI::App& app, Action& action);
void addRender(CLI::App& app, Action& action);
void addSplatRender(CLI::App& app, Action& action);
void addSplatExport(CLI::App& app, Action& action);
void addSheet(CLI::App& app, Action& action);
void addDevices(CLI::App& app, Action& action);
void addPresets(CLI::App& app, Action& action);
void addPhantom(CLI::App& app, Action& action);
void addExport(CLI::App& app, Action& action);
void addBench(CLI::App& app, Action& action);
void addEvaluate(CLI::App& app, Action& action);
void addSessions(CLI::App& app, Action& action);
void addTrain(CLI::App& app, Action& action);
void addXr(CLI::App& app, Action& action);
void addEvaluateEdits(CLI::App& evaluateApp, Action& action);          // a subcommand of evaluate
void addEvaluateInterpolation(CLI::App& evaluateApp, Action& action);  // likewise
void addEvaluateLivePicture(CLI::App& evaluateApp, Action& action);    // likewise
void addEvaluateSpecks(CLI::App& evaluateApp, Action& action);         // likewise
void addEvaluateMotion(CLI::App& evaluateApp, Action& action);         // likewise
void addEvaluateQuality(CLI::App& evaluateApp, Action& action);        // likewise
void addEvaluateTradeoff(CLI::App& evaluateApp, Action& action);       // likewise
void addBenchCast(CLI::App& bench, Action& action);                    // a subcommand of bench
void addBenchFoveal(CLI::App& bench, Action& action);                  // likewise
void addBenchLoad(CLI::App& bench, Action& action);                    // likewise
void addBenchSession(CLI::App& bench, Action& action);                 // likewise
void addBenchTradeoff(CLI::App& bench, Action& action);                // likewise
void addBenchTrain(CLI::App& bench, Action& action);                   // likewise
void addBenchXr(CLI::App& bench, Action& action);                      // likewise
void addSessionsVerify(CLI::App& sessions, Action& action);            // a subcommand of sessions
void addSessionsGc(CLI::App& sessions, Action& action);                // likewise
void addSessionsExport(CLI::App& sessions, Action& action);            // likewise
void addSessionsImport(CLI::App& sessions, Action& action);            // likewise
void addSessionsPurge(CLI::App& sessions, Action& action);             // likewise

}  // namespace macula::cli
