// Second step of the loss by tiles: sums the derivatives of SSIM windows, and takes them back to the
// premultiplied pixel. It replaces loss_back_columns and loss_gradient.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "splat/loss_tile.glsl"

layout(constant_id = 1) const bool kDisplay = false;
layout(constant_id = 2) const bool kSimilar = true;  // the loss includes SSIM

layout(binding = 1) uniform samplerBuffer terms;
layout(binding = 2) uniform samplerBuffer pairs;
layout(binding = 3) uniform samplerBuffer windows;
layout(binding = 4) uniform samplerBuffer rendered;
layout(binding = 5, scalar) writeonly buffer Gradients {
    vec4 gradients[];
};
layout(binding = 6, scalar) writeonly buffer Parts {
    vec4 parts[];  // lossPartOf, summed over a tile
};

shared vec4 wide[kWide * kWide];

vec4 windowed(int at, int which) {
    return wide[at];
}

vec4 sumOfTerms(int which) {
    barrier();  // the previous terms have been read
    for (int at = thread(); at < kWide * kWide; at += kThreads) {
        ivec2 pixel = widePixel(at);
        wide[at] = isInPicture(pixel) ? texelFetch(terms, 3 * indexOf(pixel) + which) : vec4(0.0);
    }
    return windowSum(0);
}

void main() {
    vec4 a = kSimilar ? sumOfTerms(0) : vec4(0.0);
    vec4 b = kSimilar ? sumOfTerms(1) : vec4(0.0);
    vec4 c = kSimilar ? sumOfTerms(2) : vec4(0.0);
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    vec4 part = vec4(0.0);
    if (isInPicture(pixel)) {
        int index = indexOf(pixel);
        vec4 render = texelFetch(rendered, index);
        vec4 difference = texelFetch(pairs, 2 * index + 1);
        bool known = texelFetch(windows, index).x > 0.0 && isFinite(render);
        vec4 ofSimilarity = kSimilar ? a + b * texelFetch(pairs, 2 * index) + c * difference : vec4(0.0);
        vec4 gradient = gradientOf(render, difference, ofSimilarity, kDisplay);
        gradients[index] = known ? gradient : vec4(0.0);
        part = lossPartOf(render, difference);
    }
    part = sumOfTile(part);
    if (thread() == 0) parts[tileIndex()] = part;
}
