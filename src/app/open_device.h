// The device of a program that draws.
#pragma once

#include <string>

#include "base/result.h"
#include "pipeline/gpu/recovery.h"

namespace macula::app {

// `preferred` as in gpu::chooseDevice. `tell` hears of each device that is lost and replaced.
Result<gpu::LastingDevice> openDevice(const std::string& preferred, gpu::LastingDevice::Tell tell);

}  // namespace macula::app
