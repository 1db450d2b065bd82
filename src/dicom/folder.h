// All files of a folder and its sub-folders.
#pragma once

#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "base/result.h"

namespace macula::dicom {

struct FolderListing {
    std::vector<std::filesystem::path> files;       // sorted
    std::vector<std::filesystem::path> unreadable;  // folders that could not be listed to their end; sorted
};

// Symbolic links to folders are not followed. A sub-folder that cannot be read, or goes meanwhile, stops none
// of the others. Fails with inputNotUsable when `path` itself does not exist or cannot be opened, or with
// cancelled. `path` may be one file.
Result<FolderListing> listFiles(const std::filesystem::path& path, Progress& progress);

}  // namespace macula::dicom
