// Second step of the loss: sums the moments that SSIM needs along columns of its windows. A thread for each
// strip of a column.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_strips.glsl"

layout(binding = 1) uniform samplerBuffer pairs;
layout(binding = 2, scalar) writeonly buffer Means {
    vec4 means[];  // of u, v, u^2, v^2, for each pixel
};

void main() {
    ivec2 size = params.imageSize;
    int x = int(gl_GlobalInvocationID.x);
    int first = int(gl_GlobalInvocationID.y) * kOutputs;
    if (x >= size.x || first >= size.y) return;
    vec4 u[kOutputs], v[kOutputs], uu[kOutputs], vv[kOutputs];
    [[unroll]] for (int n = 0; n < kOutputs; ++n) u[n] = v[n] = uu[n] = vv[n] = vec4(0.0);
    [[unroll]] for (int j = 0; j < kOutputs + 10; ++j) {
        int y = first + j - 5;
        float inside = y >= 0 && y < size.y ? 1.0 : 0.0;
        int index = clamp(y, 0, size.y - 1) * size.x + x;
        vec4 s = texelFetch(pairs, 2 * index) * inside;
        vec4 d = texelFetch(pairs, 2 * index + 1) * inside;
        vec4 ss = s * s;
        vec4 dd = d * d;
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
    [[unroll]] for (int n = 0; n < kOutputs; ++n) {
        if (first + n < size.y) {
            int index = (first + n) * size.x + x;
            means[4 * index] = u[n];
            means[4 * index + 1] = v[n];
            means[4 * index + 2] = uu[n];
            means[4 * index + 3] = vv[n];
        }
    }
}
