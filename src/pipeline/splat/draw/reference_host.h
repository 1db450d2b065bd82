// shaders/lib/splat_*.glsl as classes of C++, in float and in double: for the reference rasterizer and tests.
#pragma once

#include "base/glsl_in_cpp.h"
#include "pipeline/splat/draw/raster_view.h"

namespace macula::splat::reference {

#define MACULA_HOST HostSingle
#define MACULA_REAL float
#include "pipeline/splat/draw/reference_host.inl"
#undef MACULA_HOST
#undef MACULA_REAL
#define MACULA_HOST HostTwofold
#define MACULA_REAL double
#include "pipeline/splat/draw/reference_host.inl"
#undef MACULA_HOST
#undef MACULA_REAL

}  // namespace macula::splat::reference
