// macula sessions export and import: stored sessions in a folder of their own, and back.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <chrono>
#include <filesystem>
#include <memory>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/sessions_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/report.h"
#include "live/store/store_maintenance.h"

namespace macula::cli {

namespace {

struct SessionsCopyOptions : SessionsOptions {
    std::filesystem::path other;
};

void printCopied(const SessionsCopyOptions& options, const session::SnapshotReport& report) {
    print(options, report);
    if (report.damaged > 0) printWarning(fmt::format("Damaged entries were left out: {}.", report.damaged));
}

Result<void> exportAll(const SessionsCopyOptions& options) {
    if (live::isNothingStored(options.folder)) return live::nothingStored(options.folder);
    const auto start = std::chrono::steady_clock::now();
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(session::Store store, openStudyStore(options));
    MACULA_TRY(const session::SnapshotReport report, live::exportStore(store, options.other, progress));
    printCopied(options, report);
    printWritten(options.other, start);
    return {};
}

Result<void> importAll(const SessionsCopyOptions& options) {
    MACULA_TRY_VOID(live::checkImport(options.other, options.folder));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(session::Store store, openStudyStore(options));
    MACULA_TRY(const session::SnapshotReport report, store.importFrom(options.other, progress));
    printCopied(options, report);
    return {};
}

}  // namespace

void addSessionsExport(CLI::App& sessions, Action& action) {
    auto options = std::make_shared<SessionsCopyOptions>();
    auto* command =
        addSessionsVerb(sessions, "export", "Copy everything to a new folder, whole or not at all", *options);
    command->add_option("NEW_FOLDER", options->other, "Folder to write; must not exist")->required();
    command->callback([options, &action] { action = [options] { return exportAll(*options); }; });
}

void addSessionsImport(CLI::App& sessions, Action& action) {
    auto options = std::make_shared<SessionsCopyOptions>();
    auto* command = addSessionsVerb(sessions, "import",
                                    "Add what an export holds; of what both have, the newer stays", *options);
    command->add_option("FOLDER", options->other, "Folder that macula sessions export wrote")->required();
    command->callback([options, &action] { action = [options] { return importAll(*options); }; });
}

}  // namespace macula::cli
