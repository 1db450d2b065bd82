// Compares the files that the directories of media (DICOMDIR) list with those found.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "dicom/split/missing_images.h"
#include "dicom/stack/examination.h"

namespace macula::dicom {

struct ListedFiles {
    std::size_t missing = 0;     // listed, but not found by name or UID
    std::size_t outside = 0;     // listed, but outside of the folder of their DICOMDIR
    std::size_t unreadable = 0;  // directories that cannot be read
    AbsentImages absent;         // the missing files whose series is known
};

// A listed file counts as present if a file has its name, or if one of `found` has its SOPInstanceUID, since
// copies of media give files other names.
ListedFiles compareWithDirectories(std::span<const std::filesystem::path> directories,
                                   std::span<const Examination> found);

}  // namespace macula::dicom
