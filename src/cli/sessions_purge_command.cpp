// macula sessions purge: deletes a study, or all, or what was not opened for long, so that no file holds it.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <memory>

#include "cli/command.h"
#include "cli/question.h"
#include "cli/sessions_options.h"
#include "cli/shared/report.h"
#include "live/store/purge_plan.h"

namespace macula::cli {

namespace {

struct SessionsPurgeOptions : SessionsOptions {
    live::PurgeRequest request;
    int unusedDays = 0;  // 0: not given
    bool damagedToo = false;
    bool trustClock = false;
    bool yes = false;
    bool dryRun = false;
};

std::int64_t nowMs() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::milliseconds>(since).count();
}

// What can be wrong with the words alone.
Result<void> check(const SessionsPurgeOptions& options) {
    if (options.request.study.empty() && !options.request.all && options.unusedDays == 0)
        return Error{ErrorCode::usage,
                     Text("It was not said what to delete."),
                     {},
                     Text("Give STUDY, --all or --unused-days. See macula sessions purge --help.")};
    if (!options.yes && !options.dryRun && !canAsk())
        return Error{ErrorCode::usage,
                     Text("Nothing was deleted: nobody can be asked here."),
                     {},
                     Text("Give --yes to delete without a question, or --dry-run to see what would go.")};
    return {};
}

Result<void> purge(SessionsPurgeOptions& options) {
    MACULA_TRY_VOID(check(options));
    if (options.unusedDays > 0) options.request.unusedDays = options.unusedDays;
    if (options.trustClock) options.request.clock = session::Store::Clock::trusted;
    if (options.damagedToo) options.request.damaged = session::DamagedFiles::remove;
    if (live::isNothingStored(options.folder)) {
        if (!options.request.study.empty()) return live::nothingStored(options.folder);
        printNothing(options, session::PurgeReport{});
        return {};
    }
    MACULA_TRY(session::Store store, openStudyStore(options));
    MACULA_TRY(const live::PurgePlan plan, live::planPurge(store, options.request, nowMs()));
    if (options.dryRun) {
        print(options, plan);
        return {};
    }
    if (!options.yes) {
        MACULA_TRY(const bool isWanted, ask(live::questionOf(plan)));
        if (!isWanted) return Error{ErrorCode::cancelled, Text("Nothing was deleted."), {}, {}};
    }
    MACULA_TRY(const session::PurgeReport report, live::purge(store, plan));
    print(options, report);
    printWarnings(live::warningsOf(report));
    return {};
}

}  // namespace

void addSessionsPurge(CLI::App& sessions, Action& action) {
    auto options = std::make_shared<SessionsPurgeOptions>();
    SessionsPurgeOptions& o = *options;
    auto* command = addSessionsVerb(sessions, "purge",
                                    "Delete studies with all that is kept of them; asks before it does", o);
    auto* study = command->add_option("STUDY", o.request.study, "First digits of its identity, at least 4");
    auto* all = command->add_flag("--all", o.request.all, "Every study, and models of files without one");
    auto* unused = command
                       ->add_option("--unused-days", o.unusedDays,
                                    "Every study, and file without one, not opened for so many days")
                       ->option_text("N")
                       ->check(CLI::Range(1, 36500));
    command
        ->add_flag("--trust-clock", o.trustClock,
                   "Also where the time that is stored speaks against the clock of this machine")
        ->needs(unused);
    study->excludes(all)->excludes(unused);
    all->excludes(unused);
    command->add_flag("--damaged-too", o.damagedToo, "Also damaged files that were set aside, all of them");
    command->add_flag("--yes", o.yes, "Do not ask");
    command->add_flag("--dry-run", o.dryRun, "Only say what would be deleted");
    command->callback([options, &action] { action = [options] { return purge(*options); }; });
}

}  // namespace macula::cli
