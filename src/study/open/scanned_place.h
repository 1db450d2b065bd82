// What a path holds that may be an archive: a ZIP, tar or ISO 9660 file is read as the folder that is in it.
#pragma once

#include <filesystem>
#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"

namespace macula::unpack {
class UnpackedArchive;
}

namespace macula::study {

class FoundVolumes;

struct ScannedPlace {
    // The copy in which the files of an archive lie; null for a folder. The files of the scan go with it.
    std::shared_ptr<const unpack::UnpackedArchive> copy;
    dicom::Scan scan;
};

// As dicom::scanFolder. An archive is unpacked first: messages of the scan say what was left out of it, and
// files that were skipped are named as if it were a folder. Fails also as unpack::unpack().
Result<ScannedPlace> scanPlace(const std::filesystem::path& path, Progress& progress,
                               const dicom::ScanOptions& options = {});

// Keep the copy for as long as they exist.
std::shared_ptr<const FoundVolumes> foundVolumesOf(ScannedPlace place);

namespace key {  // of messages: see docs/dicom.md
inline constexpr const char* kArchiveCutOff = "archive-cut-off";
inline constexpr const char* kArchiveEncrypted = "archive-encrypted";
inline constexpr const char* kArchiveDamaged = "archive-damaged";
inline constexpr const char* kArchiveLinks = "archive-links";
inline constexpr const char* kArchiveOutside = "archive-outside";
}  // namespace key

}  // namespace macula::study
