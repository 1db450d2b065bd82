// Reads the records of a DICOMDIR that name files (PS3.3 F).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

struct DirectoryRecord {
    std::vector<std::string> fileId;  // ReferencedFileID: the names on the way to the file
    std::string sopInstanceUid;       // empty when the record does not say
    std::string seriesInstanceUid;    // the series that lists the record; empty when there is none
    std::optional<int> instanceNumber;
};

// The records in use that name a file, in file order. A record belongs to the series whose offsets lead to it
// (PS3.3 F.2); if none do, to the series before it.
std::vector<DirectoryRecord> directoryRecords(const Dataset& directory);

}  // namespace macula::dicom
