// The class NativeHost: shaders/lib in float over the voxels of a device, for native kernels.
//
// Included once for each instruction set by Highway.
#if defined(MACULA_NATIVE_HOST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_NATIVE_HOST_INL_H
#undef MACULA_NATIVE_HOST_INL_H
#else
#define MACULA_NATIVE_HOST_INL_H
#endif

#include <hwy/highway.h>

#include <array>

#include "base/glsl_in_cpp.h"
#include "pipeline/trace/clip_params.h"
#include "pipeline/trace/host_tables.h"
#include "pipeline/trace/settings.h"
#include "shared/indirect_light.h"
#include "shared/trace_params.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {
#define MACULA_HOST NativeHost
#define MACULA_REAL float
#define MACULA_VOXELS PooledVoxels
#include "pipeline/trace/shader_host.inl"
#undef MACULA_HOST
#undef MACULA_REAL
#undef MACULA_VOXELS
}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#endif
