// macula sessions verify, gc, export and import: whether what is stored is sound, room for more, and copies
// in folders of their own.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <filesystem>
#include <memory>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/sessions_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/report.h"
#include "live/store/byte_size.h"
#include "live/store/store_maintenance.h"

namespace macula::cli {

namespace {

struct SessionsCareOptions : SessionsOptions {
    std::uint64_t capBytes = session::StoreOptions{}.modelCapBytes;  // gc
};

Result<void> verify(const SessionsCareOptions& options) {
    if (live::isNothingStored(options.folder))
        return printNothing(options, live::VerifiedStore{.report = {.isDatabaseSound = true}});
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const live::VerifiedStore verified, live::verifyStore({.folder = options.folder}, progress));
    printWarnings(live::warningsOf(verified.notes));
    print(options, verified);
    if (verified.isSound()) return {};
    return Error{ErrorCode::inputNotUsable, Text("Stored sessions were not sound."), options.folder.string(),
                 Text("{}", live::whatToDo(verified))};
}

Result<void> runGarbageCollection(const SessionsCareOptions& options) {
    if (live::isNothingStored(options.folder)) return printNothing(options, live::Tidied{});
    MACULA_TRY(session::Store store, openStudyStore(options));
    MACULA_TRY(const live::Tidied tidied, live::tidyStore(store, options.capBytes));
    print(options, tidied);
    if (tidied.evicted.bytesLeft > options.capBytes)
        printNote("Models that are open stay; what is left is still above the cap.");
    return {};
}

// "2GB", never a bare "2", as a number of bytes, or a sentence.
CLI::Validator asByteSize() {
    const auto toBytes = [](std::string& text) -> std::string {
        const auto bytes = live::bytesOfText(text);
        if (!bytes) return text + " is no size: give a number with its unit, as 500MB or 2GB (B, KB, MB, GB)";
        text = std::to_string(*bytes);
        return {};
    };
    return {toBytes, "SIZE", "size"};
}

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

void addSessionsVerify(CLI::App& sessions, Action& action) {
    auto options = std::make_shared<SessionsCareOptions>();
    addSessionsVerb(sessions, "verify", "Read everything; exit code 3 where not all is sound", *options)
        ->callback([options, &action] { action = [options] { return verify(*options); }; });
}

void addSessionsGc(CLI::App& sessions, Action& action) {
    auto options = std::make_shared<SessionsCareOptions>();
    auto* command =
        addSessionsVerb(sessions, "gc", "Remove left-overs, and the least recently used models", *options);
    command
        ->add_option("--cap", options->capBytes,
                     "As 500MB or 2GB: what models may have together (default: " +
                         live::sizeForPeople(options->capBytes) + ")")
        ->transform(asByteSize())
        ->option_text("SIZE");
    command->callback([options, &action] { action = [options] { return runGarbageCollection(*options); }; });
}

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
