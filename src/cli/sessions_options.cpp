#include "cli/sessions_options.h"

#include <CLI/Option.hpp>

#include "cli/shared/report.h"

namespace macula::cli {

CLI::App* addSessionsVerb(CLI::App& sessions, const std::string& name, const std::string& help,
                          SessionsOptions& options) {
    auto* command = sessions.add_subcommand(name, help);
    command
        ->add_option(
            "--folder", options.folder,
            "Where they are stored (default: MACULA_SESSIONS of the environment, else macula/sessions "
            "where this computer keeps data of programs)")
        ->option_text("FOLDER");
    command->add_flag("--json", options.json, "Print JSON");
    return command;
}

Result<session::Store> openStudyStore(const SessionsOptions& options) {
    MACULA_TRY(session::Store store, session::Store::open({.folder = options.folder}));
    printWarnings(live::warningsOf(store.notes()));
    return store;
}

void printWarnings(const std::vector<Text>& warnings) {
    for (const Text& warning : warnings) printWarning(warning);
}

}  // namespace macula::cli
