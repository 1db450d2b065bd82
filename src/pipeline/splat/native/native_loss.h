// The twins of the loss by tiles on the host: shaders/splat/loss_compare.comp, loss_tile_terms.comp and
// loss_tile_gradient.comp.
#pragma once

#include "pipeline/gpu/native_kernel.h"

namespace macula::splat {

// `display` and `similar` are kDisplay and kSimilar of the shaders.
gpu::NativeKernel nativeLossCompare(bool display);
gpu::NativeKernel nativeLossTerms(bool display);
gpu::NativeKernel nativeLossGradient(bool display, bool similar);

}  // namespace macula::splat
