// What `macula info` says of what is one volume: a NIfTI, NRRD or MetaImage file, or the phantom.
#pragma once

#include <filesystem>

#include "base/progress.h"
#include "base/result.h"

namespace macula::cli {

// Reads all of it: a compressed file may end early, and only its end tells.
Result<void> showVolumeFile(const std::filesystem::path& path, bool json, Progress& progress);

void showPhantom(bool json);

}  // namespace macula::cli
