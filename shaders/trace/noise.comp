// Estimates how noisy each block of the picture is so far: see lib/noise.glsl. A thread for each block.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "shared/trace_params.h"

layout(local_size_x = 8) in;

layout(binding = 0, scalar) readonly buffer Sums {
    vec4 sums[];
};
layout(binding = 1, scalar) readonly buffer Counts {
    uint counts[];
};
layout(binding = 2, scalar) readonly buffer Squares {
    vec2 squares[];
};
layout(binding = 3, scalar) writeonly buffer Noises {
    BlockNoise noises[];
};
layout(push_constant, scalar) uniform Push {
    NoisePush push;
};

vec4 fetchSums(int pixel) {
    return sums[pixel];
}
uint fetchCount(int pixel) {
    return counts[pixel];
}
float fetchSquares(int pixel) {
    return squares[pixel].x;
}
#include "lib/noise.glsl"

void main() {
    uint block = push.firstBlock + gl_GlobalInvocationID.x;
    ivec2 blocks = (push.imageSize + ivec2(kBlockEdge - 1)) / kBlockEdge;
    if (block >= uint(blocks.x * blocks.y)) return;
    vec2 noise = noiseOfBlock(ivec2(int(block) % blocks.x, int(block) / blocks.x), push.imageSize,
                              push.exposure, push.backdrop, push.keepsHue == 1);
    noises[block] = BlockNoise(noise.x, noise.y > 0.0 ? 1u : 0u);
}
