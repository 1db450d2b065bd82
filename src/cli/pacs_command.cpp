// macula pacs: the archives that are set up, and what was fetched from them.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/printable.h"
#include "cli/archive_options.h"
#include "cli/command.h"
#include "cli/pacs_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "net/sources/source_address.h"
#include "net/sources/source_json.h"
#include "net/web/device_sign_in.h"
#include "study/archive/archive_json.h"
#include "study/spool/spool.h"

namespace macula::cli {

namespace {

std::string wayTo(const net::Source& source) {
    const std::string address = net::addressOf(source);
    const auto* peer = std::get_if<net::DimsePeer>(&source.peer);
    if (peer == nullptr) return "DICOMweb  " + address;
    return fmt::format("DIMSE{}  {}, as {}", peer->tls.isOn ? " over TLS" : "", address, peer->callingAe);
}

Result<void> listArchives(const ArchiveOptions& options) {
    MACULA_TRY(const net::SourceList list, readSourceList());
    if (options.json) {
        auto json = nlohmann::ordered_json::array();
        for (const net::Source& source : list.all()) {
            json.push_back(nlohmann::ordered_json(net::toJson(source)));
            json.back()["isManaged"] = source.isManaged;
        }
        fmt::print("{}\n", jsonText(json));
        return {};
    }
    for (const net::Source& source : list.all())
        fmt::print("{}  {}{}\n", printable(source.name), printable(wayTo(source)),
                   source.isManaged ? "  (set up by the administrator)" : "");
    if (list.all().empty()) fmt::print("No archive has been set up. macula pacs add sets one up.\n");
    return {};
}

Result<void> addArchiveToList(const PacsOptions& options) {
    MACULA_TRY(net::SourceList list, readSourceList());
    MACULA_TRY(const net::Source source, sourceOf(options));
    net::Secrets secrets;
    if (options.askPassword) {
        MACULA_TRY(secrets, readSecrets(source));
    }
    MACULA_TRY(auto archive, net::archiveOf(source, secrets));  // which checks the settings
    MACULA_TRY_VOID(list.put(source));
    MACULA_TRY_VOID(list.keep(source, secrets));
    printNote(Text("Added. macula pacs test tries whether it answers."));
    return {};
}

Result<void> testArchive(const ArchiveOptions& options) {
    MACULA_TRY(const OpenArchive open, openArchive(options));
    Progress progress({}, interruptToken());
    const std::vector<net::TestStep> steps = open.archive->test(progress);
    if (options.json) fmt::print("{}\n", jsonText(study::toJson(steps)));
    bool passed = !steps.empty();
    for (const net::TestStep& step : steps) {
        passed = passed && step.passed;
        if (!options.json)
            fmt::print("{}  {}{}{}{}{}\n", step.passed ? "ok    " : "FAILED", step.name.english(),
                       step.detail.empty() ? "" : ": ", printable(step.detail.english()),
                       step.advice.empty() ? "" : " ", step.advice.english());
    }
    if (passed) return {};
    return Error{ErrorCode::archiveNotUsable,
                 Text("The archive cannot be used."),
                 {},
                 Text("The step that failed says what to do.")};
}

// Shows the code on stderr, so that scripts may read stdout.
void showCode(const net::DeviceCode& code) {
    fmt::print(stderr, "Open {} in a browser, on any device, and enter the code {}.\n", code.address,
               code.userCode);
    if (!code.wholeAddress.empty()) fmt::print(stderr, "Or open {}\n", code.wholeAddress);
}

Result<void> signIn(const ArchiveOptions& options) {
    MACULA_TRY(net::SourceList list, readSourceList());
    MACULA_TRY(const net::Source source, list.find(options.archive));
    MACULA_TRY(const net::Secrets before, list.secretsOf(source));
    Progress progress({}, interruptToken());
    MACULA_TRY(const net::Secrets secrets, net::signInByDevice(source, before, showCode, progress));
    MACULA_TRY_VOID(list.keep(source, secrets));
    printNote(Text("Signed in."));
    return {};
}

Result<void> removeArchive(const ArchiveOptions& options) {
    MACULA_TRY(net::SourceList list, readSourceList());
    MACULA_TRY_VOID(list.remove(options.archive));
    printNote(Text("Removed. Studies that were fetched from it stay."));
    return {};
}

// Where a study came from, and what is known about whether all of it is there.
std::string originOf(const study::SpoolRecord& record) {
    const std::string senders = fmt::format("{}", fmt::join(record.senders, ", "));
    if (record.source.empty()) return "sent by " + senders;
    return record.source + (senders.empty() ? "" : " and sent by " + senders);
}
const char* remarkOn(const study::SpoolRecord& record) {
    if (record.isComplete) return "";
    return record.source.empty() ? "  nobody said how many there are" : "  incomplete";
}

Result<void> listFetched(const ArchiveOptions& options) {
    MACULA_TRY(const study::Spool spool, study::Spool::open());
    auto json = nlohmann::ordered_json::array();
    for (const study::SpoolEntry& entry : spool.entries()) {
        json.push_back({{"folder", entry.folder.string()},
                        {"source", entry.record.source},
                        {"senders", entry.record.senders},
                        {"instances", entry.instances},
                        {"promised", entry.record.promised},
                        {"isComplete", entry.record.isComplete},
                        {"bytes", entry.bytes},
                        {"fetchedAt", entry.record.fetchedAt}});
        if (!options.json)
            fmt::print("{}  {}  {} images, {} MB  {}{}\n", entry.folder.string(),
                       printable(originOf(entry.record)), entry.instances, entry.bytes / 1'000'000,
                       entry.record.fetchedAt, remarkOn(entry.record));
    }
    if (options.json) fmt::print("{}\n", jsonText(json));
    if (json.empty() && !options.json) fmt::print("Nothing has been fetched.\n");
    return {};
}

Result<void> purgeFetched(double gigabytes) {
    MACULA_TRY(study::Spool spool, study::Spool::open());
    MACULA_TRY(const std::size_t removed, spool.purge(static_cast<std::uintmax_t>(gigabytes * 1e9)));
    printNote(Text("{} fetched studies removed.", removed));
    return {};
}

CLI::App* addNamed(CLI::App& pacs, const char* verb, const char* help, ArchiveOptions& options) {
    CLI::App* command = pacs.add_subcommand(verb, help);
    addArchive(*command, options);
    return command;
}

}  // namespace

void addPacs(CLI::App& app, Action& action) {
    auto* pacs = app.add_subcommand(
        "pacs", "Archives (PACS): set up, test, what was fetched, and what waits to be sent");
    pacs->require_subcommand(1);

    auto added = std::make_shared<PacsOptions>();
    auto* add = pacs->add_subcommand("add", "Set up an archive, or change one");
    addPacsOptions(*add, *added);
    add->callback([added, &action] { action = [added] { return addArchiveToList(*added); }; });

    auto options = std::make_shared<ArchiveOptions>();
    auto* list = pacs->add_subcommand("list", "Archives that are set up");
    list->add_flag("--json", options->json, "Print JSON");
    list->callback([options, &action] { action = [options] { return listArchives(*options); }; });
    addNamed(*pacs, "test", "Try an archive step by step, and say what fails", *options)
        ->callback([options, &action] { action = [options] { return testArchive(*options); }; });
    addNamed(*pacs, "sign-in", "Sign in at an archive by a browser (--sign-in device)", *options)
        ->callback([options, &action] { action = [options] { return signIn(*options); }; });
    addNamed(*pacs, "remove", "Forget an archive and its password", *options)->callback([options, &action] {
        action = [options] { return removeArchive(*options); };
    });
    auto* fetched =
        pacs->add_subcommand("fetched", "Studies that were fetched or received, the latest first");
    fetched->add_flag("--json", options->json, "Print JSON");
    fetched->callback([options, &action] { action = [options] { return listFetched(*options); }; });

    auto gigabytes = std::make_shared<double>(0.0);
    auto* purge = pacs->add_subcommand("purge", "Remove fetched studies, those used longest ago first");
    purge->add_option("--keep", *gigabytes, "How many GB to keep")
        ->capture_default_str()
        ->check(CLI::NonNegativeNumber);
    purge->callback([gigabytes, &action] { action = [gigabytes] { return purgeFetched(*gigabytes); }; });

    addPacsQueue(*pacs, action);
}

}  // namespace macula::cli
