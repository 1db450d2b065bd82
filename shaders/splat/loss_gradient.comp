// Last step of the loss: sums the derivatives along rows too, then takes them back to the premultiplied
// pixel. A thread for each strip of a row.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_strips.glsl"

layout(constant_id = 1) const bool kDisplay = false;
layout(constant_id = 2) const bool kSimilar = true;  // the loss includes SSIM

layout(binding = 1) uniform samplerBuffer summed;
layout(binding = 2) uniform samplerBuffer pairs;
layout(binding = 3) uniform samplerBuffer windows;
layout(binding = 4) uniform samplerBuffer rendered;
layout(binding = 5, scalar) writeonly buffer Gradients {
    vec4 gradients[];
};
layout(binding = 6, scalar) writeonly buffer Parts {
    vec4 parts[];  // lossPartOf, summed over a strip
};

void main() {
    ivec2 size = params.imageSize;
    int first = int(gl_GlobalInvocationID.x) * kOutputs;
    int y = int(gl_GlobalInvocationID.y);
    if (first >= size.x || y >= size.y) return;
    vec4 a[kOutputs], b[kOutputs], c[kOutputs];
    [[unroll]] for (int n = 0; n < kOutputs; ++n) a[n] = b[n] = c[n] = vec4(0.0);
    if (kSimilar) [[unroll]]
        for (int j = 0; j < kOutputs + 10; ++j) {
            int x = first + j - 5;
            float inside = x >= 0 && x < size.x ? 1.0 : 0.0;
            int index = y * size.x + clamp(x, 0, size.x - 1);
            vec4 ta = texelFetch(summed, 3 * index) * inside;
            vec4 tb = texelFetch(summed, 3 * index + 1) * inside;
            vec4 tc = texelFetch(summed, 3 * index + 2) * inside;
            [[unroll]] for (int n = 0; n < kOutputs; ++n) {
                float tap = ssimTap(j - n - 5);
                if (tap > 0.0) {
                    a[n] += tap * ta;
                    b[n] += tap * tb;
                    c[n] += tap * tc;
                }
            }
        }
    vec4 part = vec4(0.0);
    [[unroll]] for (int n = 0; n < kOutputs; ++n) {
        if (first + n < size.x) {
            int index = y * size.x + first + n;
            vec4 render = texelFetch(rendered, index);
            vec4 difference = texelFetch(pairs, 2 * index + 1);
            bool known = texelFetch(windows, index).x > 0.0 && isFinite(render);
            vec4 ofSimilarity =
                kSimilar ? a[n] + b[n] * texelFetch(pairs, 2 * index) + c[n] * difference : vec4(0.0);
            vec4 gradient = gradientOf(render, difference, ofSimilarity, kDisplay);
            gradients[index] = known ? gradient : vec4(0.0);
            part += lossPartOf(render, difference);
        }
    }
    parts[y * ((size.x + kOutputs - 1) / kOutputs) + int(gl_GlobalInvocationID.x)] = part;
}
