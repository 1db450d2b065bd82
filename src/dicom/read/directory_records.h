// The records of a DICOMDIR that name files, with what they say of them. PS3.3 F.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

struct DirectoryRecord {
    std::vector<std::string> fileId;  // ReferencedFileID: the names on the way to the file
    std::string sopInstanceUid;       // empty when the record does not say
    std::string seriesInstanceUid;  // of the series that the record is listed under; empty when there is none
    std::optional<int> instanceNumber;
};

// Those that are in use, in the order of the file. A record belongs to the series that leads to it by offsets
// (PS3.3 F.2); where those lead nowhere, to the series that stands before it.
std::vector<DirectoryRecord> directoryRecords(const Dataset& directory);

}  // namespace macula::dicom
