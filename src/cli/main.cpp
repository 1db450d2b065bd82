// The `macula` command: a list of verbs.
#include "cli/command.h"
#include "cli/shared/program.h"

namespace {

void addVerbs(CLI::App& app, macula::cli::Action& action) {
    using namespace macula;
    cli::addInfo(app, action);
    cli::addRender(app, action);
    cli::addHybrid(app, action);
    cli::addSheet(app, action);
    cli::addSplatRender(app, action);
    cli::addSplatExport(app, action);
    cli::addExport(app, action);
    cli::addPicture(app, action);
    cli::addDose(app, action);
    cli::addSegment(app, action);
    cli::addPresets(app, action);
    cli::addDevices(app, action);
    cli::addPhantom(app, action);
    cli::addTrain(app, action);
    cli::addSessions(app, action);
    cli::addPacs(app, action);
    cli::addFind(app, action);
    cli::addFetch(app, action);
    cli::addSend(app, action);
    cli::addReceive(app, action);
    cli::addRead(app, action);
    cli::addXr(app, action);
}

constexpr macula::cli::MovedVerb kMovedVerbs[] = {
    {"bench",
     "Call macula-bench instead, without the word bench. Debian's package macula-benchmarks has it."},
    {"evaluate", "Call macula-bench evaluate instead. Debian's package macula-benchmarks has it."},
};

}  // namespace

int main(int argc, char** argv) {
    return macula::cli::runProgram({.name = "macula",
                                    .about = "path-traced anatomy from DICOM.",
                                    .addVerbs = addVerbs,
                                    .movedVerbs = kMovedVerbs,
                                    .footer = "macula-bench measures speed and quality."},
                                   argc, argv);
}
