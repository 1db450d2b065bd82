// What `macula info` says of a NIfTI, NRRD or MetaImage file.
#pragma once

#include <filesystem>

#include "base/result.h"

namespace macula::cli {

Result<void> showVolumeFile(const std::filesystem::path& path, bool json);

}  // namespace macula::cli
