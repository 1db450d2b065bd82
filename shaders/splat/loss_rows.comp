// Third step of the loss: sums along rows too, and computes each window's SSIM and its terms of its pixels'
// gradients. A thread for each strip of a row.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_strips.glsl"

layout(binding = 1) uniform samplerBuffer means;
layout(binding = 2) uniform
    samplerBuffer windows;  // 1 / the taps on known pixels; 0 where the pixel is unknown
layout(binding = 3, scalar) writeonly buffer Terms {
    vec4 terms[];  // for each pixel plain, ofSum, ofDifference (SsimWindow), divided by its window's taps
};
layout(binding = 4, scalar) writeonly buffer Parts {
    float parts[];  // 1 - SSIM, summed over a strip
};

void main() {
    ivec2 size = params.imageSize;
    int first = int(gl_GlobalInvocationID.x) * kOutputs;
    int y = int(gl_GlobalInvocationID.y);
    if (first >= size.x || y >= size.y) return;
    vec4 u[kOutputs], v[kOutputs], uu[kOutputs], vv[kOutputs];
    [[unroll]] for (int n = 0; n < kOutputs; ++n) u[n] = v[n] = uu[n] = vv[n] = vec4(0.0);
    [[unroll]] for (int j = 0; j < kOutputs + 10; ++j) {
        int x = first + j - 5;
        float inside = x >= 0 && x < size.x ? 1.0 : 0.0;
        int index = y * size.x + clamp(x, 0, size.x - 1);
        vec4 s = texelFetch(means, 4 * index) * inside;
        vec4 d = texelFetch(means, 4 * index + 1) * inside;
        vec4 ss = texelFetch(means, 4 * index + 2) * inside;
        vec4 dd = texelFetch(means, 4 * index + 3) * inside;
        [[unroll]] for (int n = 0; n < kOutputs; ++n) {
            float tap = ssimTap(j - n - 5);
            if (tap > 0.0) {
                u[n] += tap * s;
                v[n] += tap * d;
                uu[n] += tap * ss;
                vv[n] += tap * dd;
            }
        }
    }
    float part = 0.0;
    [[unroll]] for (int n = 0; n < kOutputs; ++n) {
        if (first + n < size.x) {
            int index = y * size.x + first + n;
            float window = texelFetch(windows, index).x;
            SsimWindow ssim = ssimWindow(u[n] * window, v[n] * window, uu[n] * window, vv[n] * window);
            part += window > 0.0 ? dot(ssim.dissimilarity, vec4(1.0)) : 0.0;
            terms[3 * index] = ssim.plain * window;
            terms[3 * index + 1] = ssim.ofSum * window;
            terms[3 * index + 2] = ssim.ofDifference * window;
        }
    }
    parts[y * ((size.x + kOutputs - 1) / kOutputs) + int(gl_GlobalInvocationID.x)] = part;
}
