// What the segments of a segmentation are, in codes: for writing them again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "base/coded_name.h"
#include "base/result.h"

namespace macula::dicom {

// Property category and type (PS3.3 C.8.20.2), such as Anatomical Structure and Liver; nothing where the file
// gives none that is whole.
struct SegmentCodes {
    std::optional<CodedName> category;
    std::optional<CodedName> type;

    bool operator==(const SegmentCodes&) const = default;
};

struct CodesOfSegments {
    std::string sopInstanceUid;                   // of the segmentation
    std::map<std::uint16_t, SegmentCodes> codes;  // by the number of the segment
};

// Fails with inputNotUsable when the file cannot be read.
Result<CodesOfSegments> readSegmentCodes(const std::filesystem::path& file);

}  // namespace macula::dicom
