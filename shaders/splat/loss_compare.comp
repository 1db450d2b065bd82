// First step of the loss: sum and difference of the two pictures, as they are compared. Pixels that are not
// finite in either picture count as equal; as black in both if the target's is not finite.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_setup.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 1) const bool kDisplay = false;

layout(binding = 1) uniform samplerBuffer rendered;
layout(binding = 2) uniform samplerBuffer targets;
layout(binding = 3) uniform samplerBuffer windows;  // 0 where the target is not finite
layout(binding = 4, scalar) writeonly buffer Pairs {
    vec4 pairs[];  // sum, difference
};

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, params.imageSize))) return;
    int index = pixel.y * params.imageSize.x + pixel.x;
    bool known = texelFetch(windows, index).x > 0.0;
    LossPair pair = pairOf(texelFetch(rendered, index), texelFetch(targets, index), known, kDisplay);
    pairs[2 * index] = pair.sum;
    pairs[2 * index + 1] = pair.difference;
}
