// What the directories of media (DICOMDIR) list, beside what was found.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "dicom/split/missing_images.h"
#include "dicom/stack/examination.h"

namespace macula::dicom {

struct ListedFiles {
    std::size_t missing = 0;     // listed, and not there, whatever their name
    std::size_t outside = 0;     // named outside of the folder of their DICOMDIR
    std::size_t unreadable = 0;  // directories that cannot be read
    AbsentImages absent;         // of those that are missing, the ones whose series is known
};

// A file is there when it has the name that is listed, or one of those `found` the UID (SOPInstanceUID),
// whatever it is called: copies of media give files other names.
ListedFiles compareWithDirectories(std::span<const std::filesystem::path> directories,
                                   std::span<const Examination> found);

}  // namespace macula::dicom
