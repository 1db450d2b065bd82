// Options for devices that this process opens itself, not for devices that a host lends.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/gpu/device.h"

namespace macula::live {

// Has devices that are opened from now on store their compiled kernels in `folder` (gpu::DeviceOptions), so
// that they start faster. A program calls this before it opens its first device; a library never does,
// because its host decides which files are written.
void keepKernelsIn(std::filesystem::path folder);

// `preferred` as in gpu::chooseDevice.
gpu::DeviceOptions deviceOptions(const std::string& preferred);

}  // namespace macula::live
