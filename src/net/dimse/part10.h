// File meta information (PS3.10 7.1): what stands before a dataset in a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/result.h"

namespace macula::net {

struct FileMeta {
    std::string sopClassUid;
    std::string sopInstanceUid;
    std::string transferSyntaxUid;
    std::uint64_t datasetOffset = 0;  // in the file
};

// The preamble and all that stands before the dataset.
std::string metaBytes(const FileMeta& meta);

// Reads no further than the file meta information.
Result<FileMeta> readMeta(const std::filesystem::path& file);

}  // namespace macula::net
