// The DICOMDIR of a disc: which files it should hold. PS3.3 F, PS3.10 8.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace macula::dicom {

// A file that the DICOMDIR names, and what it says of it; a UID is empty where it says none.
struct ListedFile {
    std::filesystem::path file;
    std::string sopInstanceUid;
    std::string seriesInstanceUid;
    std::optional<int> instanceNumber;
};

// Never trusted over the files: it says what is missing, and nothing else is taken from it.
struct MediaDirectory {
    // All inside the DICOMDIR's folder, and there; sorted, each once. By the names they have on disk, which
    // may differ from what the DICOMDIR says in capitals, version numbers (ISO 9660: IM1.;1), and an ending
    // such as .dcm.
    std::vector<std::filesystem::path> files;
    // Named, and not there by that name; sorted by name, each once. Programs that copy media give files other
    // names, so what is missing by its name may be there by its UID.
    std::vector<ListedFile> missing;
    // Named, and outside of the folder (by "..", an absolute path, or a link): never looked at.
    std::size_t outside = 0;
};

// `path` is the DICOMDIR. Opens no other file. Fails with inputNotUsable when it is none.
Result<MediaDirectory> readMediaDirectory(const std::filesystem::path& path);

}  // namespace macula::dicom
