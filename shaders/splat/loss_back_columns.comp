// Fourth step of the loss: sums the derivatives of SSIM windows along columns. A thread for each strip of a
// column.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_strips.glsl"

layout(binding = 1) uniform samplerBuffer terms;
layout(binding = 2, scalar) writeonly buffer Summed {
    vec4 summed[];
};

void main() {
    ivec2 size = params.imageSize;
    int x = int(gl_GlobalInvocationID.x);
    int first = int(gl_GlobalInvocationID.y) * kOutputs;
    if (x >= size.x || first >= size.y) return;
    vec4 a[kOutputs], b[kOutputs], c[kOutputs];
    [[unroll]] for (int n = 0; n < kOutputs; ++n) a[n] = b[n] = c[n] = vec4(0.0);
    [[unroll]] for (int j = 0; j < kOutputs + 10; ++j) {
        int y = first + j - 5;
        float inside = y >= 0 && y < size.y ? 1.0 : 0.0;
        int index = clamp(y, 0, size.y - 1) * size.x + x;
        vec4 ta = texelFetch(terms, 3 * index) * inside;
        vec4 tb = texelFetch(terms, 3 * index + 1) * inside;
        vec4 tc = texelFetch(terms, 3 * index + 2) * inside;
        [[unroll]] for (int n = 0; n < kOutputs; ++n) {
            float tap = ssimTap(j - n - 5);
            if (tap > 0.0) {
                a[n] += tap * ta;
                b[n] += tap * tb;
                c[n] += tap * tc;
            }
        }
    }
    [[unroll]] for (int n = 0; n < kOutputs; ++n) {
        if (first + n < size.y) {
            int index = (first + n) * size.x + x;
            summed[3 * index] = a[n];
            summed[3 * index + 1] = b[n];
            summed[3 * index + 2] = c[n];
        }
    }
}
