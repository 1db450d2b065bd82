#include "study/outbox/queue_sending.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/printable.h"
#include "net/connect.h"
#include "net/sources/source_address.h"

namespace macula::study {

namespace {

// An archive of the list, once it was opened; or why it cannot be reached.
using Opened = Result<std::unique_ptr<net::Archive>>;

bool hasMoved(const OutboxRecord& record, const net::Source& source) {
    return !record.address.empty() && record.address != net::addressOf(source);
}

Error moved(const OutboxRecord& record) {
    return {
        ErrorCode::usage,
        Text("The archive {} had another address when these objects were sent to it.",
             printable(record.archive)),
        {},
        Text("Check its address. If it is the same archive, select the objects under Waiting for Archives "
             "and send them, or use macula pacs retry --moved.")};
}

Result<OutboxSent> sendEntry(Outbox& outbox, const OutboxEntry& entry, const Opened& archive,
                             Progress& progress, Outbox::Which which) {
    if (!archive) {
        const std::size_t refused = entry.record.refused();
        return OutboxSent{.stored = 0,
                          .refused = refused,
                          .left = entry.record.files.size() - refused,
                          .trouble = archive.error()};
    }
    return outbox.send(entry.id, **archive, progress, which);
}

}  // namespace

Result<std::unique_ptr<net::Archive>> openArchiveOfUser(const OutboxRecord& record) {
    MACULA_TRY(const net::SourceList list, net::SourceList::read(net::SourceFiles::ofUser()));
    MACULA_TRY(const net::Source source, list.find(record.archive));
    if (hasMoved(record, source)) return moved(record);
    return net::archiveOf(list, source);
}

std::vector<MovedEntry> movedEntries(std::span<const OutboxEntry> entries, const net::SourceList& list) {
    std::vector<MovedEntry> found;
    for (const OutboxEntry& entry : entries) {
        const auto source = list.find(entry.record.archive);
        if (source && hasMoved(entry.record, *source))
            found.push_back({.id = entry.id,
                             .archive = entry.record.archive,
                             .address = net::addressOf(*source),
                             .before = entry.record.address});
    }
    return found;
}

Result<void> readdress(Outbox& outbox, std::span<const MovedEntry> moved, std::span<OutboxEntry> entries) {
    for (const MovedEntry& each : moved) {
        MACULA_TRY_VOID(outbox.readdress(each.id, each.address));
        const auto entry = std::ranges::find(entries, each.id, &OutboxEntry::id);
        if (entry != entries.end()) entry->record.address = each.address;
    }
    return {};
}

QueueSent sendQueued(Outbox& outbox, std::span<const OutboxEntry> entries, const ArchiveOpener& open,
                     Progress& progress, Outbox::Which which) {
    QueueSent all;
    std::map<std::pair<std::string, std::string>, Opened> archives;  // by name and address
    for (const OutboxEntry& entry : entries) {
        if (progress.cancelled()) break;
        if (entry.state == OutboxState::damaged) continue;
        const std::pair place(entry.record.archive, entry.record.address);
        auto archive = archives.find(place);
        if (archive == archives.end()) archive = archives.emplace(place, open(entry.record)).first;
        const auto sent = sendEntry(outbox, entry, archive->second, progress, which);
        if (!sent) {
            if (sent.error().code != ErrorCode::usage && !all.trouble) all.trouble = sent.error();
            continue;
        }
        all.stored += sent->stored;
        all.refused += sent->refused;
        all.left += sent->left;
        if (sent->trouble && !all.trouble) all.trouble = sent->trouble;
        if (sent->trouble && sent->stored == 0) archive->second = *sent->trouble;
    }
    if (progress.cancelled() && !all.trouble)
        all.trouble = Error{ErrorCode::cancelled, Text("Sending was cancelled."), {}, {}};
    return all;
}

}  // namespace macula::study
