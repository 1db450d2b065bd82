// What all kernels of the loss begin with: a strip of kOutputs pixels for each thread, and the parameters.
//
// What the steps pass on lies together for each pixel: in pictures of their own, a power of two apart, all would want the same lines
// of the cache (at 512 x 512 on lavapipe that took half as long again).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "lib/splat_loss.glsl"
#include "lib/splat_ssim.glsl"
#include "shared/splat_loss_params.h"

// Pixels of a strip: what it reads is more by 10, so that neighbours are read by few threads.
layout(constant_id = 0) const int kOutputs = 8;
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, scalar) readonly buffer Params {
    SplatLossParams params;
};
