// Exports stored sessions to another folder, and imports them from there.
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "base/result.h"
#include "session/store.h"

namespace macula::live {

// As Store::exportTo, but fails with usage for a folder inside the store, which must hold nothing foreign.
Result<session::SnapshotReport> exportStore(session::Store& store, const std::filesystem::path& newFolder,
                                            Progress& progress);

// Checks the folder before a store is opened to import it: it must exist, and not be the store's own.
Result<void> checkImport(const std::filesystem::path& folder, const std::filesystem::path& ofStore);

}  // namespace macula::live
