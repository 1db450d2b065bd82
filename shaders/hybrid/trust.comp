// How much to trust a traced picture over splats, from the sums of trust_rows.comp along columns: see
// lib/trust.glsl.
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

#include "lib/trust.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, trust.size))) return;
    vec2 sum = vec2(0.0);
    for (int y = pixel.y - TRUST_RADIUS; y <= pixel.y + TRUST_RADIUS; ++y) {
        int inside = clamp(y, 0, trust.size.y - 1);
        sum += inside == y ? terms[inside * trust.size.x + pixel.x] : vec2(0.0);
    }
    trusts[pixel.y * trust.size.x + pixel.x] = trustOf(sum);
}
