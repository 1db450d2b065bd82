#include "live/store/store_maintenance.h"

#include <utility>

namespace macula::live {

namespace fs = std::filesystem;

namespace {

Result<VerifiedStore> verifyOnce(const session::StoreOptions& options, Progress& progress) {
    MACULA_TRY(session::Store store, session::Store::open(options));
    MACULA_TRY(const session::VerifyReport report, store.verify(progress));
    return VerifiedStore{.report = report, .notes = store.notes()};
}

// Makes "out/" into "out": exportTo uses the last part as the name of the new folder.
fs::path withoutSlash(const fs::path& path) {
    return path.has_filename() || !path.has_parent_path() ? path : path.parent_path();
}

bool isInside(const fs::path& path, const fs::path& folder) {
    std::error_code error;
    for (fs::path place = fs::weakly_canonical(fs::absolute(path, error), error); !error;
         place = place.parent_path()) {
        if (fs::equivalent(place, folder, error)) return true;
        error.clear();  // a part that does not exist yet is not `folder`
        if (place == place.parent_path()) return false;
    }
    return false;
}

}  // namespace

Result<VerifiedStore> verifyStore(session::StoreOptions options, Progress& progress) {
    MACULA_TRY(VerifiedStore first, verifyOnce(options, progress));
    if (first.report.isDatabaseSound) return first;
    // Only a full check, which includes indexes, sets such a file aside on opening.
    options.check = session::StoreOptions::Check::full;
    auto second = verifyOnce(options, progress);
    if (second) {
        if (!second->notes.setAside) second->notes = first.notes;
        return second;
    }
    if (session::troubleOf(second.error()) != session::Trouble::lockedByAnother) return second.error();
    first.isRescuePending = true;
    return first;
}

Result<Tidied> tidyStore(session::Store& store, std::uint64_t capBytes) {
    Tidied tidied;
    MACULA_TRY(tidied.evicted, store.evictModels(capBytes));
    MACULA_TRY(tidied.leftOvers, store.collectGarbage());
    // Last: on a full disk there is room for it now.
    if (tidied.evicted.models > 0)
        MACULA_TRY_VOID(store.addAudit(session::AuditAction::deleted, session::AuditKind::model, {},
                                       std::int64_t(tidied.evicted.models)));
    return tidied;
}

Result<session::SnapshotReport> exportStore(session::Store& store, const fs::path& newFolder,
                                            Progress& progress) {
    if (isInside(newFolder, store.folder()))
        return Error{ErrorCode::usage, Text("An export cannot lie inside of the stored sessions."),
                     newFolder.string(), Text("Choose a place elsewhere.")};
    return store.exportTo(withoutSlash(newFolder), progress);
}

Result<void> checkImport(const fs::path& folder, const fs::path& ofStore) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) return session::errorOf(session::Trouble::snapshotInvalid, folder);
    if (fs::equivalent(folder, ofStore, error))
        return Error{ErrorCode::usage, Text("These are the stored sessions themselves."), folder.string(),
                     Text("Choose a folder that macula sessions export wrote.")};
    return {};
}

}  // namespace macula::live
