// Everything the tracer's kernels share, in order. The host must declare before this: params (TraceParams),
// useTrilinear(), and the fetch functions that the parts name.
#define PI 3.14159265358979323846
#define BRICK 8

#include "lib/rng.glsl"
#include "lib/net.glsl"
#include "lib/phase.glsl"
#include "lib/medium.glsl"
#include "lib/mask.glsl"
#include "lib/gradient.glsl"
#include "lib/mixture.glsl"
#include "lib/fovea.glsl"
#include "lib/clip.glsl"
#include "lib/brick_walk.glsl"
#include "lib/environment.glsl"
#include "lib/scattering.glsl"
#include "lib/material.glsl"
#include "lib/picture.glsl"
#include "lib/indirect.glsl"
#include "lib/path.glsl"
#include "lib/guides.glsl"
#include "lib/cell_walk.glsl"
#include "lib/spline.glsl"
#include "lib/cast.glsl"
#include "lib/surface.glsl"
#ifdef OF_LAYERS
#include "lib/layers.glsl"
#endif
