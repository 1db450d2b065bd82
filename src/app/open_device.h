// The device of a program that draws.
#pragma once

#include <string>

#include "base/result.h"
#include "pipeline/gpu/recovery.h"

namespace macula::app {

// `preferred` as in gpu::chooseDevice. `tell` hears of what is lost on the way, and made good.
Result<gpu::LastingDevice> openDevice(const std::string& preferred, gpu::LastingDevice::Tell tell);

}  // namespace macula::app
