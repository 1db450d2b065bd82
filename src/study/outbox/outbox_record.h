// What the queue notes of objects that wait for an archive, beside their files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "study/open/identity.h"
#include "study/outbox/reason.h"

namespace macula::study {

struct OutboxFile {
    std::string name;               // in the folder of the entry: a number, which says nothing
    std::optional<Reason> refused;  // the archive did not take it; nothing: it has yet to be sent
};

// Names patients, as the files beside it do.
struct OutboxRecord {
    std::string archive;             // its name in the list of archives
    std::string address;             // where it was then, see net::addressOf; empty: not known
    std::vector<Identity> patients;  // each once; whom the person was told of who sent the files
    std::string queuedAt;            // UTC, ISO 8601, with milliseconds
    std::size_t tries = 0;
    std::string triedAt;            // the last time; empty: never
    std::optional<Reason> trouble;  // why nothing could be sent then
    std::vector<OutboxFile> files;  // that are not stored yet; at least one

    std::size_t refused() const;  // how many of the files
};

std::filesystem::path outboxRecordFile(const std::filesystem::path& folder);

// Of the folder of an entry. Fails with inputNotUsable where it is damaged or of a later version.
Result<OutboxRecord> readOutboxRecord(const std::filesystem::path& folder);
Result<void> writeOutboxRecord(const std::filesystem::path& folder, const OutboxRecord& record);

}  // namespace macula::study
