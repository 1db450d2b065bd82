// Sums the terms of trust along rows, for trust.comp: see lib/trust.glsl.
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

#include "lib/trust.glsl"

vec4 tracedAt(int index) {
    return traced[index] / (trust.areMeans == 1 ? 1.0 : float(max(counts[index], 1u)));
}
vec4 splatsAt(int index) {
    return texelFetch(splats, index) * vec4(vec3(trust.splatGain), 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, trust.size))) return;
    int row = pixel.y * trust.size.x;
    vec2 sum = vec2(0.0);
    for (int x = pixel.x - TRUST_RADIUS; x <= pixel.x + TRUST_RADIUS; ++x) {
        int index = row + clamp(x, 0, trust.size.x - 1);
        vec2 one = trustTerms(tracedAt(index), variances[index], splatsAt(index));
        sum += index == row + x ? one : vec2(0.0);
    }
    terms[row + pixel.x] = sum;
}
