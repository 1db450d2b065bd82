// Opens the device of a program that draws.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "live/device/device_options.h"
#include "pipeline/gpu/recovery.h"

namespace macula::live {

// $MACULA_KERNELS if it is set, even to nothing; else $XDG_CACHE_HOME/macula/kernels, else
// ~/.cache/macula/kernels. Empty: kernels are not stored.
std::filesystem::path usualKernelsFolder();

// `preferred` as in gpu::chooseDevice. `tell` is called for each device that is lost and replaced.
Result<gpu::LastingDevice> openDevice(const std::string& preferred, gpu::LastingDevice::Tell tell);

}  // namespace macula::live
