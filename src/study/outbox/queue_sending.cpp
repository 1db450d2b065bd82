#include "study/outbox/queue_sending.h"

#include <map>
#include <utility>

#include "net/connect.h"
#include "net/sources/source_list.h"

namespace macula::study {

namespace {

// An archive of the list, once it was opened; or why it cannot be reached.
using Opened = Result<std::unique_ptr<net::Archive>>;

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

Result<std::unique_ptr<net::Archive>> openArchiveOfUser(const std::string& name) {
    MACULA_TRY(const net::SourceList list, net::SourceList::read(net::SourceFiles::ofUser()));
    MACULA_TRY(const net::Source source, list.find(name));
    return net::archiveOf(list, source);
}

QueueSent sendQueued(Outbox& outbox, std::span<const OutboxEntry> entries, const ArchiveOpener& open,
                     Progress& progress, Outbox::Which which) {
    QueueSent all;
    std::map<std::string, Opened> archives;
    for (const OutboxEntry& entry : entries) {
        if (progress.cancelled()) break;
        if (entry.state == OutboxState::damaged) continue;
        const std::string& name = entry.record.archive;
        auto archive = archives.find(name);
        if (archive == archives.end()) archive = archives.emplace(name, open(name)).first;
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
