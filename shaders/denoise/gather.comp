// First step of denoising: see lib/denoise_gather.glsl.
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

layout(binding = 0, scalar) readonly buffer Sums {
    vec4 sums[];
};
layout(binding = 1, scalar) readonly buffer Counts {
    uint counts[];
};
layout(binding = 2, scalar) readonly buffer Squares {
    vec2 squares[];
};
layout(binding = 3) uniform samplerBuffer surfaces;
layout(binding = 4) uniform samplerBuffer matters;
layout(binding = 5) uniform samplerBuffer motions;
layout(binding = 6) uniform samplerBuffer oldMeans;  // of the view before
layout(binding = 7) uniform samplerBuffer oldMoments;
layout(binding = 8) uniform samplerBuffer oldSurfaces;
layout(binding = 9) uniform samplerBuffer oldMatters;
layout(binding = 10, scalar) writeonly buffer Means {
    vec4 means[];
};
layout(binding = 11, scalar) writeonly buffer Moments {
    vec2 moments[];  // mean square of luminance, samples
};

vec4 fetchSums(int pixel) {
    return sums[pixel];
}
uint fetchCount(int pixel) {
    return counts[pixel];
}
float fetchSquares(int pixel) {
    return squares[pixel].x;
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
vec4 fetchOldMean(int pixel) {
    return texelFetch(oldMeans, pixel);
}
vec2 fetchOldMoments(int pixel) {
    return texelFetch(oldMoments, pixel).xy;
}
vec4 fetchOldSurface(int pixel) {
    return texelFetch(oldSurfaces, pixel);
}
vec4 fetchOldMatter(int pixel) {
    return texelFetch(oldMatters, pixel);
}
#include "lib/denoise_gather.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, denoise.firstRow);
    if (any(greaterThanEqual(pixel, denoise.imageSize))) return;
    Record record = gatherPixel(pixel);
    int index = indexOf(pixel);
    means[index] = record.mean;
    moments[index] = vec2(record.square, record.samples);
}
