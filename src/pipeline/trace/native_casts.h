// cast.comp on the host's cores.
#pragma once

#include "pipeline/gpu/native_kernel.h"
#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

// The twin of cast.comp for this variant. The mode is a kCast… of trace_params.h.
gpu::NativeKernel nativeCasts(const TraceVariant& variant, int mode);

}  // namespace macula::trace
