// macula sessions verify and gc: whether what is stored is sound, and room for more.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/sessions_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/report.h"
#include "live/store/byte_size.h"

namespace macula::cli {

namespace {

struct SessionsCareOptions : SessionsOptions {
    std::uint64_t capBytes = session::StoreOptions{}.modelCapBytes;  // gc
};

Result<void> verify(const SessionsCareOptions& options) {
    if (live::isNothingStored(options.folder)) {
        printNothing(options, live::VerifiedStore{.report = {.isDatabaseSound = true}});
        return {};
    }
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const live::VerifiedStore verified, live::verifyStore({.folder = options.folder}, progress));
    printWarnings(live::warningsOf(verified.notes));
    print(options, verified);
    if (verified.isSound()) return {};
    return Error{ErrorCode::inputNotUsable, Text("Stored sessions were not sound."), options.folder.string(),
                 Text("{}", live::whatToDo(verified))};
}

Result<void> runGarbageCollection(const SessionsCareOptions& options) {
    if (live::isNothingStored(options.folder)) {
        printNothing(options, live::Tidied{});
        return {};
    }
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

}  // namespace macula::cli
