// Stored sessions that go to another folder, and come from there.
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "base/result.h"
#include "session/store.h"

namespace macula::app {

// As Store::exportTo. Fails with usage for a place inside of the store, which holds nothing else.
Result<session::SnapshotReport> exportSessions(session::Store& store, const std::filesystem::path& newFolder,
                                               Progress& progress);

// What can be wrong with the folder before a store is opened for it: it is none, or the store's own.
Result<void> checkImport(const std::filesystem::path& folder, const std::filesystem::path& ofStore);

}  // namespace macula::app
