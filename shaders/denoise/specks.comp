// Pixels that stand out alone, before and after the filter: see lib/denoise_specks.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "lib/fovea.glsl"
#include "shared/denoise_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant, scalar) uniform Push {
    DenoisePush denoise;
};
#include "lib/denoise.glsl"

layout(binding = 0) uniform samplerBuffer colours;
layout(binding = 1) uniform samplerBuffer noises;
layout(binding = 2) uniform samplerBuffer masses;
layout(binding = 3) uniform samplerBuffer surfaces;
layout(binding = 4) uniform samplerBuffer moments;
layout(binding = 5, scalar) writeonly buffer Shown {
    vec4 shown[];
};

vec4 fetchColour(int pixel) {
    return texelFetch(colours, pixel);
}
vec4 fetchNoise(int pixel) {
    return texelFetch(noises, pixel);
}
vec2 fetchMoments(int pixel) {
    return texelFetch(moments, pixel).xy;
}
vec4 fetchMass(int pixel) {
    return texelFetch(masses, pixel);
}
vec4 fetchSurface(int pixel) {
    return texelFetch(surfaces, pixel);
}
#include "lib/denoise_filter.glsl"
#include "lib/denoise_specks.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, denoise.firstRow);
    if (any(greaterThanEqual(pixel, denoise.imageSize))) return;
    shown[indexOf(pixel)] = withoutSpeck(pixel);
}
