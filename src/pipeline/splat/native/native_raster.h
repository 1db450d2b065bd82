// The twin of shaders/splat/raster.comp on the host: draws a picture of splats, a tile at a time.
#pragma once

#include "pipeline/gpu/native_kernel.h"

namespace macula::splat {

gpu::NativeKernel nativeRaster();

}  // namespace macula::splat
