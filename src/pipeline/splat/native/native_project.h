// The twin of shaders/splat/project.comp on the host.
#pragma once

#include "pipeline/gpu/native_kernel.h"

namespace macula::splat {

// `degree`: what the shader is specialised with, kDegree.
gpu::NativeKernel nativeProject(int degree);

}  // namespace macula::splat
