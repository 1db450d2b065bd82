// candidates.comp and surface_points.comp on the host's cores.
#pragma once

#include "pipeline/gpu/native_kernel.h"
#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

gpu::NativeKernel nativeCandidates(const SceneKind& scene);
gpu::NativeKernel nativeSurfacePoints(const SceneKind& scene);

}  // namespace macula::trace
