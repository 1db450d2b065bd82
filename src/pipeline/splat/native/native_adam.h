// The twin of shaders/splat/adam.comp on the host.
#pragma once

#include "pipeline/gpu/native_kernel.h"

namespace macula::splat {

gpu::NativeKernel nativeAdam();

}  // namespace macula::splat
