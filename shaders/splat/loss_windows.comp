// Once for each target: for each pixel 1 / the sum of the taps of its SSIM window that fall on finite pixels;
// 0 where the pixel itself is not finite. By tiles.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_tile.glsl"

layout(binding = 1) uniform samplerBuffer targets;
layout(binding = 2, scalar) writeonly buffer Windows {
    float windows[];
};

shared float known[kWide * kWide];

vec4 windowed(int at, int which) {
    return vec4(known[at]);
}

void main() {
    for (int at = thread(); at < kWide * kWide; at += kThreads) {
        ivec2 pixel = widePixel(at);
        known[at] = isInPicture(pixel) && isFinite(texelFetch(targets, indexOf(pixel))) ? 1.0 : 0.0;
    }
    float taps = windowSum(0).x;
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (!isInPicture(pixel)) return;
    int own = (int(gl_LocalInvocationID.y) + kReach) * kWide + int(gl_LocalInvocationID.x) + kReach;
    windows[indexOf(pixel)] = known[own] > 0.0 ? 1.0 / taps : 0.0;
}
