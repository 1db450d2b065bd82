// Opens the device of a program that draws.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/recovery.h"

namespace macula::live {

// $MACULA_KERNELS if it is set, even to nothing; else $XDG_CACHE_HOME/macula/kernels, else
// ~/.cache/macula/kernels. Empty: kernels are not stored.
std::filesystem::path usualKernelsFolder();

// `preferred` as in gpu::chooseDevice. `tell` is called for each device that is lost and replaced.
Result<gpu::LastingDevice> openDevice(const std::string& preferred, gpu::LastingDevice::Tell tell);

// Has devices that are opened from now on store their compiled kernels in `folder` (gpu::DeviceOptions), so
// that they start faster. A program calls this before it opens its first device; a library never does,
// because its host decides which files are written.
void keepKernelsIn(std::filesystem::path folder);

// Options for devices that this process opens itself, not for devices that a host lends. `preferred` as in
// gpu::chooseDevice.
gpu::DeviceOptions deviceOptions(const std::string& preferred);

}  // namespace macula::live
