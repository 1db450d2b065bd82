// macula sessions list, show and audit: what is kept of studies that were opened.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <memory>

#include "cli/command.h"
#include "cli/sessions_options.h"

namespace macula::cli {

namespace {

struct SessionsListOptions : SessionsOptions {
    std::string study;  // show
    int last = 20;      // audit
};

Result<void> listStudies(const SessionsListOptions& options) {
    if (live::isNothingStored(options.folder))
        return printNothing(options, live::StoredStudies{.folder = options.folder});
    MACULA_TRY(session::Store store, openStudyStore(options));
    MACULA_TRY(const live::StoredStudies stored, live::storedStudies(store));
    print(options, stored);
    return {};
}

Result<void> showStudy(const SessionsListOptions& options) {
    if (live::isNothingStored(options.folder)) return live::nothingStored(options.folder);
    MACULA_TRY(session::Store store, openStudyStore(options));
    MACULA_TRY(const auto studies, store.listStudies());
    MACULA_TRY(const session::StudyEntry study, live::studyOfPrefix(studies, options.study));
    MACULA_TRY(const live::StoredStudy stored, live::storedStudy(store, study));
    print(options, stored);
    return {};
}

Result<void> showAudit(const SessionsListOptions& options) {
    if (live::isNothingStored(options.folder))
        return printNothing(options, session::Listing<session::AuditEntry>{});
    MACULA_TRY(session::Store store, openStudyStore(options));
    MACULA_TRY(const auto trail, store.listAudit(static_cast<std::size_t>(options.last)));
    print(options, trail);
    return {};
}

}  // namespace

void addSessions(CLI::App& app, Action& action) {
    auto* sessions =
        app.add_subcommand("sessions", "What is kept of studies that were opened: list, copy, delete");
    sessions->require_subcommand(1);
    auto options = std::make_shared<SessionsListOptions>();
    SessionsListOptions& o = *options;
    addSessionsVerb(*sessions, "list", "Studies, the latest opened first", o)->callback([options, &action] {
        action = [options] { return listStudies(*options); };
    });

    auto* show = addSessionsVerb(*sessions, "show", "Series, models and stored states of a study", o);
    show->add_option("STUDY", o.study, "First digits of its identity, at least 4")->required();
    show->callback([options, &action] { action = [options] { return showStudy(*options); }; });

    addSessionsVerify(*sessions, action);
    addSessionsGc(*sessions, action);
    addSessionsExport(*sessions, action);
    addSessionsImport(*sessions, action);
    addSessionsPurge(*sessions, action);

    auto* audit = addSessionsVerb(*sessions, "audit", "What was opened, exported and deleted, and when", o);
    audit->add_option("--last", o.last, "How many of the latest entries")
        ->capture_default_str()
        ->check(CLI::Range(1, 1'000'000));
    audit->callback([options, &action] { action = [options] { return showAudit(*options); }; });
}

}  // namespace macula::cli
