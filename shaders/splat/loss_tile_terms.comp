// First step of the loss by tiles: compares both pictures, and computes each window's SSIM and its terms of
// its pixels' gradients. It replaces loss_compare, loss_columns and loss_rows, and keeps their sums out of
// the device's memory.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_tile.glsl"

layout(constant_id = 1) const bool kDisplay = false;

layout(binding = 1) uniform samplerBuffer rendered;
layout(binding = 2) uniform samplerBuffer targets;
layout(binding = 3) uniform
    samplerBuffer windows;  // 1 / the taps on known pixels; 0 where the pixel is unknown
layout(binding = 4, scalar) writeonly buffer Pairs {
    vec4 pairs[];  // sum, difference
};
layout(binding = 5, scalar) writeonly buffer Terms {
    vec4 terms[];  // for each pixel plain, ofSum, ofDifference (SsimWindow), divided by its window's taps
};
layout(binding = 6, scalar) writeonly buffer Parts {
    float parts[];  // 1 - SSIM, summed over a tile
};

shared vec4 sums[kWide * kWide];
shared vec4 differences[kWide * kWide];

vec4 windowed(int at, int which) {
    vec4 value = which % 2 == 0 ? sums[at] : differences[at];
    return which < 2 ? value : value * value;
}

void main() {
    for (int at = thread(); at < kWide * kWide; at += kThreads) {
        ivec2 pixel = widePixel(at);
        LossPair pair = LossPair(vec4(0.0), vec4(0.0));
        if (isInPicture(pixel)) {
            int index = indexOf(pixel);
            bool known = texelFetch(windows, index).x > 0.0;
            pair = pairOf(texelFetch(rendered, index), texelFetch(targets, index), known, kDisplay);
        }
        sums[at] = pair.sum;
        differences[at] = pair.difference;
    }
    barrier();
    vec4 u = windowSum(0);
    vec4 v = windowSum(1);
    vec4 uu = windowSum(2);
    vec4 vv = windowSum(3);
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool inside = isInPicture(pixel);
    int index = inside ? indexOf(pixel) : 0;
    float window = inside ? texelFetch(windows, index).x : 0.0;
    SsimWindow ssim = ssimWindow(u * window, v * window, uu * window, vv * window);
    if (inside) {
        int own = (int(gl_LocalInvocationID.y) + kReach) * kWide + int(gl_LocalInvocationID.x) + kReach;
        pairs[2 * index] = sums[own];
        pairs[2 * index + 1] = differences[own];
        terms[3 * index] = ssim.plain * window;
        terms[3 * index + 1] = ssim.ofSum * window;
        terms[3 * index + 2] = ssim.ofDifference * window;
    }
    vec4 part = sumOfTile(vec4(window > 0.0 ? dot(ssim.dissimilarity, vec4(1.0)) : 0.0));
    if (thread() == 0) parts[tileIndex()] = part.x;
}
