// The sums that trust.comp compares, along rows: see lib/trust.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "shared/reproject_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, scalar) readonly buffer Traced {
    vec4 traced[];
};
layout(binding = 1, scalar) readonly buffer Counts {
    uint counts[];
};
layout(binding = 2, scalar) readonly buffer Variances {
    float variances[];
};
layout(binding = 3) uniform samplerBuffer splats;
layout(binding = 4, scalar) writeonly buffer Terms {
    vec2 terms[];
};
layout(push_constant, scalar) uniform Push {
    TrustPush trust;
};

vec4 fetchLight(int pixel) {
    return traced[pixel] / (trust.areMeans == 1 ? 1.0 : float(max(counts[pixel], 1u)));
}
float fetchVariance(int pixel) {
    return variances[pixel];
}
vec4 fetchSplats(int pixel) {
    return texelFetch(splats, pixel);
}
vec2 fetchTerms(ivec2 pixel) {
    return vec2(0.0);
}
#include "lib/trust.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, trust.size))) return;
    terms[pixel.y * trust.size.x + pixel.x] = termsInRow(pixel);
}
