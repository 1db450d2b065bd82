// How far each pixel of a filtered picture may be off: see lib/denoise_variance.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "lib/variance.glsl"
#include "lib/fovea.glsl"
#include "shared/denoise_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(push_constant, scalar) uniform Push {
    DenoisePush denoise;
};
#include "lib/denoise.glsl"

layout(binding = 0) uniform samplerBuffer noises;
layout(binding = 1) uniform samplerBuffer masses;
layout(binding = 2) uniform samplerBuffer means;
layout(binding = 3) uniform samplerBuffer moments;  // mean square of luminance, samples
layout(binding = 4) uniform samplerBuffer surfaces;
layout(binding = 5) uniform samplerBuffer matters;
layout(binding = 6) uniform samplerBuffer motions;
layout(binding = 7, scalar) writeonly buffer Variances {
    float variances[];
};

vec4 fetchNoise(int pixel) {
    return texelFetch(noises, pixel);
}
vec4 fetchMass(int pixel) {
    return texelFetch(masses, pixel);
}
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
#include "lib/denoise_variance.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, denoise.imageSize))) return;
    variances[indexOf(pixel)] = varianceOfFiltered(pixel);
}
