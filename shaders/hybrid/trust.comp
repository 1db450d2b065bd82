// How far a traced picture is to be trusted over splats: see lib/trust.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "shared/reproject_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, scalar) readonly buffer Terms {
    vec2 terms[];
};
layout(binding = 1, scalar) writeonly buffer Trusts {
    float trusts[];
};
layout(push_constant, scalar) uniform Push {
    TrustPush trust;
};

vec4 fetchLight(int pixel) {
    return vec4(0.0);
}
float fetchVariance(int pixel) {
    return 0.0;
}
vec4 fetchSplats(int pixel) {
    return vec4(0.0);
}
vec2 fetchTerms(ivec2 pixel) {
    return terms[pixel.y * trust.size.x + pixel.x];
}
#include "lib/trust.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, trust.size))) return;
    trusts[pixel.y * trust.size.x + pixel.x] = trustAt(pixel);
}
