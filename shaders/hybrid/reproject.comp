// A picture that was traced from one eye, as another sees it: see lib/reproject.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#include "shared/reproject_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant, scalar) uniform Push {
    ReprojectPush reproject;
};
layout(binding = 0) uniform samplerBuffer lights;
layout(binding = 1) uniform samplerBuffer depths;
layout(binding = 2, scalar) writeonly buffer Seen {
    vec4 seen[];
};
layout(binding = 3, scalar) writeonly buffer Weights {
    float weights[];
};

vec4 fetchLight(int pixel) {
    return texelFetch(lights, pixel);
}
vec2 fetchSurface(int pixel) {
    return texelFetch(depths, pixel).xy;
}
#include "lib/reproject.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + reproject.firstPx;
    if (any(greaterThanEqual(pixel, reproject.size))) return;
    int index = pixel.y * reproject.size.x + pixel.x;
    Reprojected result = reprojectedAt(pixel);
    seen[index] = result.light;
    weights[index] = result.weight;
}
