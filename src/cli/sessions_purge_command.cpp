// macula sessions purge: deletes a study, or all, or what was not opened for long, so that no file holds it.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string_view>

#include "base/parsing.h"
#include "base/progress_bar.h"
#include "base/result.h"
#include "cli/command.h"
#include "cli/sessions_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/report.h"
#include "live/store/purge_plan.h"

namespace macula::cli {

namespace {

constexpr int kLookMs = 100;  // how long the token is not looked at

// False at the end of the input.
Result<bool> waitForInput() {
    for (pollfd input{STDIN_FILENO, POLLIN, 0};;) {
        if (interruptToken().cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
        const int ready = poll(&input, 1, kLookMs);
        if (ready > 0) return (input.revents & POLLIN) != 0;
        if (ready < 0 && errno != EINTR) return false;
    }
}

// Whether somebody can read a question and answer it: standard input and stderr are a terminal.
bool canAsk() {
    return isatty(STDIN_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
}

// True for "y" and "yes"; false for all else, and for no answer. Fails with cancelled when the program is
// told to stop meanwhile.
Result<bool> ask(std::string_view question) {
    clearProgressBar();
    std::fputs(fmt::format("{} [y/N] ", question).c_str(), stderr);
    std::fflush(stderr);
    const auto isThere = waitForInput();
    if (!isThere) {
        std::fputc('\n', stderr);
        return isThere.error();
    }
    std::array<char, 256> line{};
    const ssize_t count = isThere.value() ? read(STDIN_FILENO, line.data(), line.size()) : 0;
    const std::string_view answer = trimmed({line.data(), static_cast<std::size_t>(count > 0 ? count : 0)});
    return answer == "y" || answer == "Y" || answer == "yes" || answer == "Yes" || answer == "YES";
}

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
        return printNothing(options, session::PurgeReport{});
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
