// Sends what waits in the queue, to all archives that it waits for.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/archive.h"
#include "net/sources/source_list.h"
#include "study/outbox/outbox.h"

namespace macula::study {

// That an entry waits for.
using ArchiveOpener = std::function<Result<std::unique_ptr<net::Archive>>(const OutboxRecord& record)>;
// Of the user's list, with its secrets. Fails with usage where the archive of that name is not at the entry's
// address any more: what was confirmed for one archive never goes to another by itself.
Result<std::unique_ptr<net::Archive>> openArchiveOfUser(const OutboxRecord& record);

// An entry whose archive has another address now, by the user's list.
struct MovedEntry {
    std::string id;
    std::string archive;
    std::string address;  // now
    std::string before;   // when it was queued
};
std::vector<MovedEntry> movedEntries(std::span<const OutboxEntry> entries, const net::SourceList& list);
// A person has said that they are the same archives: the entries wait for them where they are now.
Result<void> readdress(Outbox& outbox, std::span<const MovedEntry> moved, std::span<OutboxEntry> entries);

struct QueueSent {
    std::size_t stored = 0;
    std::size_t refused = 0;  // in the queue now, of the entries that were asked for
    std::size_t left = 0;
    std::optional<Error> trouble;  // the first; cancelled, too
};

// An archive that cannot be reached is not asked again for its other entries. Entries that are gone, or that
// somebody else is sending, are skipped.
QueueSent sendQueued(Outbox& outbox, std::span<const OutboxEntry> entries, const ArchiveOpener& open,
                     Progress& progress, Outbox::Which which = Outbox::Which::waiting);

}  // namespace macula::study
