// The device of a program that draws.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/recovery.h"

namespace macula::app {

// $MACULA_KERNELS, which may be empty, else $XDG_CACHE_HOME/macula/kernels, else ~/.cache/macula/kernels.
// Empty: nowhere.
std::filesystem::path usualKernelsFolder();

// From here on the devices of this process keep what their drivers compile there (gpu::DeviceOptions), and
// start faster. A program says so before it opens its first device; a library, whose host decides which files
// are written, never.
void keepKernelsIn(std::filesystem::path folder);

// Of a device of this process.
gpu::DeviceOptions deviceOptions(const std::string& preferred);

// `preferred` as in gpu::chooseDevice. `tell` hears of each device that is lost and replaced.
Result<gpu::LastingDevice> openDevice(const std::string& preferred, gpu::LastingDevice::Tell tell);

}  // namespace macula::app
