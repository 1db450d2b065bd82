// Sets a damaged database aside, and rescues its readable rows into a fresh one.
#pragma once

#include <chrono>
#include <filesystem>

#include "base/result.h"
#include "session/blob_files.h"
#include "session/store_values.h"

namespace macula::session {

// Whether the header of the file says that a newer version of the program wrote it: this version may then
// only fail to understand the file. Requires that the caller has no connection to it.
bool isOfNewerVersion(const std::filesystem::path& database);

// Moves the file with its journal to damaged/<UTC time>/, and replaces it by a database with every row whose
// checksum is valid. Also moves blobs that no rescued row names. Deletes nothing; a stop at any moment leaves
// the damaged file in one of the two places. Requires that no other process has the store open, and that the
// caller has no connection to the file.
Result<SetAside> setAsideAndRescue(const std::filesystem::path& database, const BlobFiles& blobs,
                                   std::chrono::milliseconds patience);

}  // namespace macula::session
