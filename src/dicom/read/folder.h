// Lists all files of a folder and its sub-folders.
#pragma once

#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace macula::dicom {

struct UnreadableFolder {
    std::filesystem::path path;
    int error = 0;  // errno
};

struct FolderListing {
    std::vector<std::filesystem::path> files;  // sorted
    std::vector<UnreadableFolder> unreadable;  // folders that could not be listed completely; sorted
    // Symbolic links, to files or folders, that lead out of the folder and were not followed.
    std::size_t linksOutside = 0;
};

// Lists every real file once. Follows symbolic links only to targets inside of `path`, which may be a link
// itself; loops end. Leaves out without a message what macOS puts on foreign disks (AppleDouble files ._NAME,
// .DS_Store, __MACOSX). Continues when a sub-folder cannot be read or disappears meanwhile. Fails with
// inputNotUsable when `path` itself does not exist or cannot be opened, or with cancelled. `path` may be one
// file.
Result<FolderListing> listFiles(const std::filesystem::path& path, Progress& progress);

// Both paths are as std::filesystem::canonical returns them.
bool liesInside(const std::filesystem::path& canonicalPath, const std::filesystem::path& canonicalFolder);

}  // namespace macula::dicom
