// SSIM by strips, for devices of type CPU: a thread sums over the windows of kOutputs pixels at once, along
// columns and then along rows.
//
// What the steps pass on lies together for each pixel: in pictures of their own, a power of two apart, all
// would want the same lines of the cache (at 512 x 512 on lavapipe that took half as long again).
#include "splat/loss_setup.glsl"

// Pixels of a strip: what it reads is more by 10, so that neighbours are read by few threads.
layout(constant_id = 0) const int kOutputs = 8;
layout(local_size_x = 8, local_size_y = 8) in;
