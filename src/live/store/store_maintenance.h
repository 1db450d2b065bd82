// Maintenance of the study store: checks and repairs it, makes room in it, exports and imports it.
#pragma once

#include <cstdint>
#include <filesystem>

#include "base/progress.h"
#include "base/result.h"
#include "session/store.h"

namespace macula::live {

struct VerifiedStore {
    session::VerifyReport report;
    session::OpeningNotes notes;   // from the last opening: the database set aside, if any
    bool isRescuePending = false;  // another program has the damaged database open
    bool isSound() const { return report.isSound() && !notes.setAside; }
};

// Opens the store of `options`, and reads and checks everything in it. Sets a damaged database aside and
// rescues what can be read of it; sets damaged models and rows aside, so that they are no longer found. Fails
// as Store::open and Store::verify.
Result<VerifiedStore> verifyStore(session::StoreOptions options, Progress& progress);

struct Tidied {
    session::EvictionReport evicted;
    session::GcReport leftOvers;
};

// Makes room: removes models, the least recently used first, until the others take at most `capBytes`, then
// what killed programs left behind. Open models stay. The audit trail gets the number removed. Fails as
// Store::evictModels.
Result<Tidied> tidyStore(session::Store& store, std::uint64_t capBytes);

// As Store::exportTo, but fails with usage for a folder inside the store, which must hold nothing foreign.
Result<session::SnapshotReport> exportStore(session::Store& store, const std::filesystem::path& newFolder,
                                            Progress& progress);

// Checks the folder before a store is opened to import it: it must exist, and not be the store's own.
Result<void> checkImport(const std::filesystem::path& folder, const std::filesystem::path& ofStore);

}  // namespace macula::live
