// Second step of the loss: what SSIM needs of a window, summed along the columns. A thread for each strip of a column.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_setup.glsl"

layout(binding = 1) uniform samplerBuffer sums;
layout(binding = 2) uniform samplerBuffer differences;
layout(binding = 3, scalar) writeonly buffer Means {
    vec4 means[];  // of u, v, u^2, v^2: one picture after the other
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
        vec4 s = texelFetch(sums, index) * inside;
        vec4 d = texelFetch(differences, index) * inside;
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
    int plane = size.x * size.y;
    [[unroll]] for (int n = 0; n < kOutputs; ++n) {
        if (first + n < size.y) {
            int index = (first + n) * size.x + x;
            means[index] = u[n];
            means[plane + index] = v[n];
            means[2 * plane + index] = uu[n];
            means[3 * plane + index] = vv[n];
        }
    }
}
