// The twin of shaders/splat/raster_back.comp on the host: for each pair of a tile and a splat in it, the
// derivatives of the loss by the projected splat, summed over the tile's pixels.
#pragma once

#include "pipeline/gpu/native_kernel.h"

namespace macula::splat {

// What the shader is specialised with.
struct BackSlots {
    int slots = 1;        // kSlots
    int rowsOfSlot = 16;  // kLanes / kTileColumns * kRows: the rows of a tile whose sums go to one slot
};

gpu::NativeKernel nativeRasterBack(const BackSlots& slots);

}  // namespace macula::splat
