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
#include "study/outbox/outbox.h"

namespace macula::study {

// By its name.
using ArchiveOpener = std::function<Result<std::unique_ptr<net::Archive>>(const std::string& name)>;
// Of the user's list, with its secrets.
Result<std::unique_ptr<net::Archive>> openArchiveOfUser(const std::string& name);

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
