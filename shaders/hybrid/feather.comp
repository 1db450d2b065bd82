// Softens the borders of a reprojected picture's weights: see lib/feather.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "shared/reproject_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform samplerBuffer hardWeights;  // x: weight; y: trust, which needs no softening
layout(binding = 1, scalar) writeonly buffer Weights {
    float weights[];
};
layout(push_constant, scalar) uniform Push {
    FeatherPush push;
};

float fetchWeight(ivec2 pixel) {
    ivec2 inside = clamp(pixel, ivec2(0), push.size - ivec2(1));
    return texelFetch(hardWeights, inside.y * push.size.x + inside.x).x;
}
#include "lib/feather.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + push.firstPx;
    if (any(greaterThanEqual(pixel, push.size))) return;
    int index = pixel.y * push.size.x + pixel.x;
    weights[index] = feathered(pixel) * texelFetch(hardWeights, index).y;
}
