// The DICOMDIR of a disc: which files it should hold. PS3.3 F, PS3.10 8.
#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"

namespace macula::dicom {

// Never trusted over the files: it says what is missing, and nothing else is taken from it.
struct MediaDirectory {
    // All inside the DICOMDIR's folder, and there; sorted, each once. By the names they have on disk, which
    // may differ from what the DICOMDIR says in capitals and version numbers (ISO 9660: IM1.;1).
    std::vector<std::filesystem::path> files;
    std::vector<std::filesystem::path> missing;  // named, and not there; sorted, each once
    // Named, and outside of the folder (by "..", an absolute path, or a link): never looked at.
    std::size_t outside = 0;
};

// `path` is the DICOMDIR. Opens no other file. Fails with inputNotUsable when it is none.
Result<MediaDirectory> readMediaDirectory(const std::filesystem::path& path);

}  // namespace macula::dicom
