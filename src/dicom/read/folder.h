// All files of a folder and its sub-folders.
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
    std::vector<UnreadableFolder> unreadable;  // that could not be listed to their end; sorted
    // Symbolic links, to files and to folders, that lead out of the folder, and were not followed.
    std::size_t linksOutside = 0;
};

// Every real file once: symbolic links are followed only to what lies inside of `path`, which may be a link
// itself, and loops end. What macOS leaves on foreign disks (AppleDouble files ._NAME, .DS_Store, __MACOSX)
// is left out without a word. A sub-folder that cannot be read, or goes meanwhile, stops none of the others.
// Fails with inputNotUsable when `path` itself does not exist or cannot be opened, or with cancelled. `path`
// may be one file.
Result<FolderListing> listFiles(const std::filesystem::path& path, Progress& progress);

// Both as std::filesystem::canonical gives them.
bool liesInside(const std::filesystem::path& canonicalPath, const std::filesystem::path& canonicalFolder);

}  // namespace macula::dicom
