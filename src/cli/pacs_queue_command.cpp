// macula pacs queue, retry and drop: objects that were sent to an archive and are not stored there yet.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <algorithm>
#include <memory>

#include "base/parsing.h"
#include "base/printable.h"
#include "base/progress_bar.h"
#include "cli/archive_options.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "study/outbox/outbox.h"
#include "study/outbox/outbox_json.h"
#include "study/outbox/queue_sending.h"

namespace macula::cli {

namespace {

struct QueueOptions {
    std::string archive;               // retry; empty: all
    std::vector<std::string> entries;  // first digits of their IDs
    bool all = false;                  // drop
    bool refusedToo = false;           // retry
    bool moved = false;                // retry: to archives whose address has changed, too
    bool json = false;
};

std::string objects(std::size_t count) {
    return count == 1 ? "1 object" : fmt::format("{} objects", count);
}

void printPatients(std::FILE* to, const char* before, const study::OutboxEntry& entry) {
    for (const study::Identity& patient : entry.record.patients)
        fmt::print(to, "{}{}\n", before, printable(study::titleOf(patient).english()));
}

void printReason(const study::Reason& reason) {
    fmt::print("    {} {}\n", printable(reason.why.english()), printable(reason.advice.english()));
}

void printEntry(const study::OutboxEntry& entry) {
    if (entry.state == study::OutboxState::damaged) {
        fmt::print("{}  damaged; the objects lie in {}\n", entry.id, entry.folder.string());
        return;
    }
    const study::OutboxRecord& record = entry.record;
    fmt::print("{}  {}  {}  {}  {}  {}\n", entry.id, study::nameOf(entry.state), printable(record.archive),
               objects(record.files.size()), record.queuedAt,
               record.tries == 1 ? "tried once" : fmt::format("tried {} times", record.tries));
    printPatients(stdout, "    ", entry);
    if (record.trouble) printReason(*record.trouble);
    std::vector<study::Reason> told;  // many files are refused for one reason
    for (const study::OutboxFile& file : record.files) {
        if (!file.refused || std::ranges::find(told, *file.refused) != told.end()) continue;
        told.push_back(*file.refused);
        printReason(*file.refused);
    }
}

Result<void> listQueue(const QueueOptions& options) {
    MACULA_TRY(const study::Outbox outbox, study::Outbox::open());
    const std::vector<study::OutboxEntry> entries = outbox.entries();
    if (options.json) {
        fmt::print("{}\n", jsonText(study::toJson(entries)));
        return {};
    }
    for (const study::OutboxEntry& entry : entries) printEntry(entry);
    if (entries.empty()) fmt::print("Nothing waits for an archive.\n");
    return {};
}

// Those that were named, or all; of one archive where that was named.
Result<std::vector<study::OutboxEntry>> entriesToSend(const study::Outbox& outbox,
                                                      const QueueOptions& options) {
    std::vector<study::OutboxEntry> entries;
    for (const std::string& digits : options.entries) {
        MACULA_TRY(study::OutboxEntry entry, outbox.find(digits));
        entries.push_back(std::move(entry));
    }
    if (options.entries.empty()) entries = outbox.entries();
    if (options.archive.empty()) return entries;
    std::erase_if(entries, [&](const study::OutboxEntry& entry) {
        return lowerCase(entry.record.archive) != lowerCase(options.archive);
    });
    if (entries.empty()) {
        MACULA_TRY(const net::SourceList list, readSourceList());
        MACULA_TRY(const net::Source known, list.find(options.archive));  // else the name is wrong
    }
    return entries;
}

Result<void> retry(const QueueOptions& options) {
    MACULA_TRY(study::Outbox outbox, study::Outbox::open());
    MACULA_TRY(std::vector<study::OutboxEntry> entries, entriesToSend(outbox, options));
    const auto which = options.refusedToo ? study::Outbox::Which::refusedToo : study::Outbox::Which::waiting;
    std::erase_if(entries, [&](const auto& entry) { return entry.toSend(which) == 0; });
    if (options.moved) {
        MACULA_TRY(const net::SourceList list, readSourceList());
        MACULA_TRY_VOID(study::readdress(outbox, study::movedEntries(entries, list), entries));
    }
    for (const study::OutboxEntry& entry : entries) {
        printPatients(stderr, "", entry);
        fmt::print(stderr, "{} to {}.\n", objects(entry.toSend(which)), printable(entry.record.archive));
    }
    Progress progress(terminalProgressBar(), interruptToken());
    const study::QueueSent sent =
        study::sendQueued(outbox, entries, study::openArchiveOfUser, progress, which);
    if (options.json)
        fmt::print("{}\n", jsonText(study::toJson(sent)));
    else if (entries.empty())
        fmt::print("Nothing waits to be sent.\n");
    else
        fmt::print("{} stored, {} still wait, {} refused.\n", sent.stored, sent.left, sent.refused);
    if (sent.trouble)
        return Error{
            sent.trouble->code,
            sent.trouble->message,
            {},
            Text::joined({sent.trouble->hint, Text("What was not stored stays in the queue.")}, " ")};
    if (sent.refused == 0) return {};
    return Error{ErrorCode::archiveNotUsable,
                 Text("{} objects were not stored.", sent.refused),
                 {},
                 Text("macula pacs queue lists the reasons.")};
}

Result<void> drop(const QueueOptions& options) {
    if (options.entries.empty() && !options.all)
        return Error{ErrorCode::usage,
                     Text("It was not said what to remove from the queue."),
                     {},
                     Text("Give the first digits of an entry, or --all. macula pacs queue lists them.")};
    MACULA_TRY(study::Outbox outbox, study::Outbox::open());
    std::vector<study::OutboxEntry> entries;
    if (options.all) entries = outbox.entries();
    for (const std::string& digits : options.entries) {
        MACULA_TRY(study::OutboxEntry entry, outbox.find(digits));
        entries.push_back(std::move(entry));
    }
    for (const study::OutboxEntry& entry : entries) MACULA_TRY_VOID(outbox.remove(entry.id));
    printNote(entries.size() == 1 ? Text("One entry was removed from the queue.")
                                  : Text("{} entries were removed from the queue.", entries.size()));
    return {};
}

}  // namespace

void addPacsQueue(CLI::App& pacs, Action& action) {
    auto options = std::make_shared<QueueOptions>();
    auto* list = pacs.add_subcommand("queue", "Objects that wait for an archive, and why");
    list->add_flag("--json", options->json, "Print JSON");
    list->callback([options, &action] { action = [options] { return listQueue(*options); }; });

    auto* again = pacs.add_subcommand(
        "retry", "Send what waits in the queue; does not ask, as it was confirmed when it was sent first");
    again->add_option("ARCHIVE", options->archive, "Only what waits for it; without it, everything");
    again->add_option("--entry", options->entries, "Only this entry, by the first digits of its ID");
    again->add_flag("--refused-too", options->refusedToo, "Also what the archive refused before");
    again->add_flag("--moved", options->moved, "Also to an archive whose address has changed since");
    again->add_flag("--json", options->json, "Print JSON");
    again->callback([options, &action] { action = [options] { return retry(*options); }; });

    auto* remove = pacs.add_subcommand("drop", "Remove objects from the queue without sending them");
    auto* named = remove->add_option("ENTRY", options->entries, "The first digits of its ID, at least 4");
    remove->add_flag("--all", options->all, "The whole queue")->excludes(named);
    remove->callback([options, &action] { action = [options] { return drop(*options); }; });
}

}  // namespace macula::cli
