// guides.comp and layers.comp on the host's cores.
#pragma once

#include "pipeline/gpu/native_kernel.h"
#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

gpu::NativeKernel nativeGuides(const SceneKind& scene);
gpu::NativeKernel nativeLayers(const SceneKind& scene);

}  // namespace macula::trace
