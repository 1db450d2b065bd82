#include "dicom/folder.h"

#include <algorithm>

#include "base/log.h"

namespace macula::dicom {

namespace fs = std::filesystem;

Result<FolderListing> listFiles(const fs::path& path, Progress& progress) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        return Error{ErrorCode::inputNotUsable, "The folder does not exist.", path.string(),
                     "Check the path."};
    }
    if (fs::is_regular_file(status)) return FolderListing{{path}, {}};
    fs::directory_iterator root(path, error);
    if (!fs::is_directory(status) || error) {
        return Error{ErrorCode::inputNotUsable, "The folder cannot be read.", path.string(),
                     "Check that it is a folder, and its permissions."};
    }
    FolderListing listing;
    // By hand rather than by the recursive iterator, which ends for good at the first error.
    std::vector<fs::path> waiting{path};
    while (!waiting.empty()) {
        const fs::path folder = std::move(waiting.back());
        waiting.pop_back();
        fs::directory_iterator at(folder, error);
        while (!error && at != fs::directory_iterator()) {
            if (progress.cancelled()) return Error{ErrorCode::cancelled, "Reading was cancelled.", {}, {}};
            std::error_code ignored;  // a file that vanished meanwhile is not listed
            if (at->is_regular_file(ignored)) {
                listing.files.push_back(at->path());
            } else if (at->is_directory(ignored) && !at->is_symlink(ignored)) {
                waiting.push_back(at->path());
            }
            at.increment(error);
        }
        if (error) {
            log::warning("a folder could not be listed to its end: {}", error.message());
            listing.unreadable.push_back(folder);
        }
    }
    std::sort(listing.files.begin(), listing.files.end());
    std::sort(listing.unreadable.begin(), listing.unreadable.end());
    return listing;
}

}  // namespace macula::dicom
