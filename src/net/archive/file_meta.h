// The file meta information that begins a DICOM file (PS3.10 7.1): what the file holds, and in which
// encoding.
//
// Files from an archive are hostile: the reader looks at the first 64 KiB alone, and copies UIDs only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::net {

struct FileMeta {
    std::string sopClassUid;          // (0002,0002)
    std::string sopInstanceUid;       // (0002,0003)
    std::string transferSyntaxUid;    // (0002,0010)
    std::uint64_t datasetOffset = 0;  // of the first byte behind group 2

    bool isWhole() const {
        return !sopClassUid.empty() && !sopInstanceUid.empty() && !transferSyntaxUid.empty();
    }
};

constexpr std::size_t kMostMetaBytes = std::size_t{64} << 10;

// 1 to 64 digits and dots (PS3.5 9.1). Components with leading zeros, which exist, are let through.
bool isUid(std::string_view text);

// Of the first bytes of a file. Nothing where they are not those of DICOM, or group 2 does not end in them. A
// UID that is missing or malformed is empty.
std::optional<FileMeta> fileMetaOf(std::span<const std::byte> beginning);

// Fails with inputNotUsable where the file cannot be read, or is not one of DICOM.
Result<FileMeta> readFileMeta(const std::filesystem::path& file);

// The preamble and all that stands before the dataset, for a file that is received without it.
std::string fileMetaBytes(const FileMeta& meta);

}  // namespace macula::net
