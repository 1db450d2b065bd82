// The reason why nothing of a folder can be shown.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "dicom/read/folder.h"
#include "dicom/scan.h"

namespace macula::dicom {

// The error for a scan that found neither an image nor another object.
Error nothingFound(const Scan& scan, const std::filesystem::path& path, const FolderListing& listing);

}  // namespace macula::dicom
