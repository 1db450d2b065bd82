// Once for each target: 1 / the taps of the SSIM window around a pixel that fall on known pixels; 0 where the pixel itself is
// not finite. And how many those are, summed over rows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_setup.glsl"

layout(binding = 1) uniform samplerBuffer targets;
layout(binding = 2, scalar) writeonly buffer Windows {
    float windows[];
};

void main() {
    ivec2 size = params.imageSize;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, size))) return;
    float taps = 0.0;
    for (int dy = -5; dy <= 5; ++dy) {
        for (int dx = -5; dx <= 5; ++dx) {
            ivec2 at = pixel + ivec2(dx, dy);
            ivec2 near = clamp(at, ivec2(0), size - ivec2(1));
            bool known = at == near && isFinite(texelFetch(targets, near.y * size.x + near.x));
            taps += known ? ssimTap(dx) * ssimTap(dy) : 0.0;
        }
    }
    int index = pixel.y * size.x + pixel.x;
    windows[index] = isFinite(texelFetch(targets, index)) ? 1.0 / taps : 0.0;
}
