// Second step of denoising: see lib/denoise_prepare.glsl.
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

layout(binding = 0) uniform samplerBuffer means;
layout(binding = 1) uniform samplerBuffer moments;  // mean square of luminance, samples
layout(binding = 2) uniform samplerBuffer surfaces;
layout(binding = 3) uniform samplerBuffer matters;
layout(binding = 4) uniform samplerBuffer motions;
layout(binding = 5, scalar) writeonly buffer Masses {
    vec4 masses[];
};
layout(binding = 6, scalar) writeonly buffer Noises {
    vec4 noises[];
};

vec4 fetchMean(int pixel) {
    return texelFetch(means, pixel);
}
vec2 fetchMoments(int pixel) {
    return texelFetch(moments, pixel).xy;
}
vec4 fetchSurface(int pixel) {
    return texelFetch(surfaces, pixel);
}
vec4 fetchMatter(int pixel) {
    return texelFetch(matters, pixel);
}
vec4 fetchMotion(int pixel) {
    return texelFetch(motions, pixel);
}
#include "lib/denoise_prepare.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, denoise.firstRow);
    if (any(greaterThanEqual(pixel, denoise.imageSize))) return;
    Prepared prepared = preparePixel(pixel);
    int index = indexOf(pixel);
    masses[index] = prepared.mass;
    noises[index] = prepared.noise;
}
