// Options for the devices that this process opens itself, rather than gets lent.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/gpu/device.h"

namespace macula::live {

// From here on the devices of this process store compiled kernels in `folder` (gpu::DeviceOptions), and start
// faster. A program calls this before it opens its first device; a library never does, because its host
// decides which files are written.
void keepKernelsIn(std::filesystem::path folder);

// `preferred` as in gpu::chooseDevice.
gpu::DeviceOptions deviceOptions(const std::string& preferred);

}  // namespace macula::live
