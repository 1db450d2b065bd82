// The tables of a dispatch of shaders/trace, as the host reads them.
#pragma once

#include "pipeline/gpu/native_kernel.h"
#include "pipeline/trace/host_tables.h"
#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

inline constexpr std::uint32_t kIndirectBinding = 22;  // as in path.comp

// The bindings of shaders/trace/host.glsl, for the features of the scene.
HostTables<PooledVoxels> nativeTables(const gpu::NativeDispatch& dispatch, const shared::TraceParams& params,
                                      const TraceVariant& variant);

}  // namespace macula::trace
