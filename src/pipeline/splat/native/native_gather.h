// The twin of shaders/splat/gather.comp on the host.
#pragma once

#include "pipeline/gpu/native_kernel.h"

namespace macula::splat {

// What the shader is specialised with: kDegree and kSlots.
gpu::NativeKernel nativeGather(int degree, int slots);

}  // namespace macula::splat
