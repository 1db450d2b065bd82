// The device of a verb that draws.
#pragma once

#include <string>

#include "base/result.h"
#include "pipeline/gpu/recovery.h"

namespace macula::cli {

// `preferred` as in gpu::chooseDevice. What is lost on the way, and made good, is a note.
Result<gpu::LastingDevice> openDevice(const std::string& preferred);

}  // namespace macula::cli
