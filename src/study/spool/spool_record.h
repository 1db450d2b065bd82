// What the spool notes of a study beside its files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "net/archive/query.h"

namespace macula::study {

// Names a patient, as the files beside it do.
struct SpoolRecord {
    std::string studyInstanceUid;
    std::string source;  // the name of the archive it was fetched from; empty: it was sent unasked
    std::vector<std::string> senders;             // AE titles of those who sent images of it unasked
    std::size_t promised = 0;                     // instances that the archive said it has
    std::vector<std::string> never;               // SOP Instance UIDs of those that did not come
    bool isComplete = false;                      // all that was promised is there, and on the disk
    std::string fetchedAt;                        // or sent; UTC, ISO 8601
    std::optional<net::FoundStudy> asFound = {};  // what the archive said of it
};

// For fetchedAt.
std::string timeOfRecord();

// Beside the folder of the study, in which only instances lie.
std::filesystem::path spoolRecordFile(const std::filesystem::path& folder);

// Of the folder of a study. Fails with inputNotUsable where there is none or it is damaged.
Result<SpoolRecord> readSpoolRecord(const std::filesystem::path& folder);
Result<void> writeSpoolRecord(const std::filesystem::path& folder, const SpoolRecord& record);

}  // namespace macula::study
