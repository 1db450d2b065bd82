// The subcommands. Each adds itself to the command line, and leaves its work in `action` when the user chose
// it.
#pragma once

#include <CLI/App.hpp>

#include "cli/shared/program.h"

namespace macula::cli {

void addInfo(CLI::App& app, Action& action);
void addHybrid(CLI::App& app, Action& action);
void addRender(CLI::App& app, Action& action);
void addSplatRender(CLI::App& app, Action& action);
void addSplatExport(CLI::App& app, Action& action);
void addSheet(CLI::App& app, Action& action);
void addDevices(CLI::App& app, Action& action);
void addDose(CLI::App& app, Action& action);
void addPresets(CLI::App& app, Action& action);
void addPhantom(CLI::App& app, Action& action);
void addPicture(CLI::App& app, Action& action);
void addExport(CLI::App& app, Action& action);
void addSegment(CLI::App& app, Action& action);
void addSessions(CLI::App& app, Action& action);
void addTrain(CLI::App& app, Action& action);
void addPacs(CLI::App& app, Action& action);
void addFind(CLI::App& app, Action& action);
void addFetch(CLI::App& app, Action& action);
void addSend(CLI::App& app, Action& action);
void addReceive(CLI::App& app, Action& action);
void addRead(CLI::App& app, Action& action);
void addXr(CLI::App& app, Action& action);
void addSessionsVerify(CLI::App& sessions, Action& action);  // a subcommand of sessions
void addSessionsGc(CLI::App& sessions, Action& action);      // likewise
void addSessionsExport(CLI::App& sessions, Action& action);  // likewise
void addSessionsImport(CLI::App& sessions, Action& action);  // likewise
void addSessionsPurge(CLI::App& sessions, Action& action);   // likewise
void addPacsQueue(CLI::App& pacs, Action& action);           // subcommands of pacs

}  // namespace macula::cli
