// The twin of cast.comp on the host's cores.
#pragma once

#include "pipeline/gpu/native_kernel.h"
#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

// `look` is one of shared::kCast. Empty for variants that only the shader casts: with splines, a second
// volume or coloured segments.
gpu::NativeKernel nativeCasts(const TraceVariant& variant, int look);

}  // namespace macula::trace
