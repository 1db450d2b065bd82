// Reprojects a picture that was traced from one eye to another: see lib/reproject.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#include "shared/reproject_params.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool kHasSplats = true;

layout(push_constant, scalar) uniform Push {
    ReprojectPush reproject;
};
layout(binding = 0) uniform samplerBuffer lights;
layout(binding = 1) uniform samplerBuffer depths;
layout(binding = 2) uniform samplerBuffer trusts;
layout(binding = 3) uniform samplerBuffer splats;  // of the new picture: coverage in w
layout(binding = 4, scalar) readonly buffer DepthSums {
    float depthSums[];  // of the splats: coverage times depth
};
layout(binding = 5, scalar) writeonly buffer Seen {
    vec4 seen[];
};
layout(binding = 6, scalar) writeonly buffer Weights {
    vec2 weights[];  // x: weight; y: trust
};

vec4 fetchLight(int pixel) {
    return texelFetch(lights, pixel);
}
vec2 fetchSurface(int pixel) {
    return texelFetch(depths, pixel).xy;
}
float fetchTrust(int pixel) {
    return texelFetch(trusts, pixel).x;
}
float fetchExpected(int pixel) {
    if (!kHasSplats) return -1.0;
    float coverage = texelFetch(splats, pixel).w;
    return coverage > 0.5 ? depthSums[pixel] / coverage : -1.0;
}
#include "lib/reproject.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + reproject.firstPx;
    if (any(greaterThanEqual(pixel, reproject.size))) return;
    int index = pixel.y * reproject.size.x + pixel.x;
    Reprojected result = reprojectedAt(pixel);
    seen[index] = result.light;
    weights[index] = vec2(result.weight, result.trust);
}
