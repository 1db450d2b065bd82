// A damaged database is set aside, and what can be read of it goes on in a fresh one.
#pragma once

#include <chrono>
#include <filesystem>

#include "base/result.h"
#include "session/blob_files.h"
#include "session/store_values.h"

namespace macula::session {

// Whether the header says that a newer version of the program wrote the file, which this one may only fail to
// understand. The caller has no connection to it.
bool isOfNewerVersion(const std::filesystem::path& database);

// Moves the file with its journal to damaged/<UTC time>/, and puts a database in its place that has every row
// with a valid checksum. Blobs that no rescued row names move there as well. Nothing is deleted, and a stop
// at any moment leaves the damaged file in one of the two places. The caller has the store alone, and no
// connection to the file.
Result<SetAside> setAsideAndRescue(const std::filesystem::path& database, const BlobFiles& blobs,
                                   std::chrono::milliseconds patience);

}  // namespace macula::session
