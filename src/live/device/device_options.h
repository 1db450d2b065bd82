// How this process opens the devices that nobody lends it.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/gpu/device.h"

namespace macula::app {

// From here on the devices of this process keep what their drivers compile there (gpu::DeviceOptions), and
// start faster. A program says so before it opens its first device; a library, whose host decides which files
// are written, never.
void keepKernelsIn(std::filesystem::path folder);

// `preferred` as in gpu::chooseDevice.
gpu::DeviceOptions deviceOptions(const std::string& preferred);

}  // namespace macula::app
