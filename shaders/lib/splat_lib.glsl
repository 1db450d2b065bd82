// Everything the splats' kernels share, in order. The host must declare before this: SplatView
// (shaders/shared/splat_view.h), and the words OUT, INOUT and PRECISE.
#include "lib/picture.glsl"
#include "lib/splat_types.glsl"
#include "lib/splat_shape.glsl"
#include "lib/splat_projection.glsl"
#include "lib/splat_projection_backward.glsl"
#include "lib/splat_colour.glsl"
#include "lib/splat_blend.glsl"
#include "lib/splat_least_power.glsl"
#include "lib/splat_tile.glsl"
