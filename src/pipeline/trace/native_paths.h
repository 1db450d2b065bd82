// path.comp and path_primaries.comp on the host's cores: paths side by side in the lanes of vectors.
#pragma once

#include "pipeline/gpu/native_kernel.h"
#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

// The twin of either for this variant; empty for path_side.comp, which has none. Takes the same
// random numbers, so that each sample equals the shader's within rounding, whatever the number of threads
// and lanes.
gpu::NativeKernel nativePaths(const TraceVariant& variant);

}  // namespace macula::trace
