// Reads the DICOMDIR of a disc, which lists its files (PS3.3 F, PS3.10 8).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace macula::dicom {

// A file that the DICOMDIR lists; a UID is empty when the record has none.
struct ListedFile {
    std::filesystem::path file;
    std::string sopInstanceUid;
    std::string seriesInstanceUid;
    std::optional<int> instanceNumber;
};

// The files have precedence: the DICOMDIR only serves to find out which files are missing.
struct MediaDirectory {
    // The listed files that exist inside the DICOMDIR's folder; sorted, each once. Named as on disk, which
    // may differ from the DICOMDIR in capitals, version numbers (ISO 9660: IM1.;1), and an ending such as
    // .dcm.
    std::vector<std::filesystem::path> files;
    // Listed files that do not exist by that name; sorted by name, each once. Programs that copy media rename
    // files, so a file that is missing by its name may be there by its UID.
    std::vector<ListedFile> missing;
    // Number of listed files outside of the folder (by "..", an absolute path, or a link); never read.
    std::size_t outside = 0;
};

// `path` is the DICOMDIR. Opens no other file. Fails with inputNotUsable when it is not one.
Result<MediaDirectory> readMediaDirectory(const std::filesystem::path& path);

}  // namespace macula::dicom
