// SSIM by strips, for CPU devices without native kernels: a thread sums over the windows of kOutputs pixels
// at once, along columns and then along rows.
//
// Intermediate results are interleaved by pixel: in separate pictures, a power of two apart, they would
// compete for the same cache lines (at 512 x 512 on lavapipe this took half as long again).
#include "splat/loss_setup.glsl"

// Pixels of a strip. A strip reads 10 more, so that with long strips few threads read a pixel twice.
layout(constant_id = 0) const int kOutputs = 8;
layout(local_size_x = 8, local_size_y = 8) in;
