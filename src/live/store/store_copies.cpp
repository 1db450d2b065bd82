#include "live/store/store_copies.h"

namespace macula::live {

namespace fs = std::filesystem;

namespace {

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
