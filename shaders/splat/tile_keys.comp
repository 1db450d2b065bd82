// Writes the keys by which splats are sorted: the bits of their depth, which order like the depth because it
// is above 0. Splats that do not show come last.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/frame.glsl"
#include "shared/splat_lists.h"

layout(local_size_x = kListThreads) in;
layout(binding = 1) uniform samplerBuffer screenTexels;
layout(binding = 2, scalar) writeonly buffer Items {
    uvec2 items[];  // key, splat
};

void main() {
    uint splat = gl_GlobalInvocationID.x;
    if (splat >= frame.count) return;
    vec4 texel = texelFetch(screenTexels, int(splat) * kScreenTexels + 1);
    items[splat] = uvec2(texel.y > 0.0 ? floatBitsToUint(texel.z) : 0xffffffffu, splat);
}
