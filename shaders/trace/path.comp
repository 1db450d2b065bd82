// Adds samples to the pixels of a tile.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "trace/host.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 7, scalar) buffer Sums {
    vec4 sums[];  // premultiplied radiance and coverage
};
layout(binding = 8, scalar) buffer Lost {
    vec4 lost[];  // compensation of the sums
};
layout(binding = 9, scalar) buffer Counts {
    uint counts[];  // finite samples
};
layout(binding = 10, scalar) buffer Faults {
    uint nonFinite;
};
layout(push_constant, scalar) uniform Push {
    TilePush push;
};

void main() {
    ivec2 pixel = push.tileOrigin + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, push.tileEnd))) return;

    int index = pixel.y * params.imageSize.x + pixel.x;
    vec4 sum = sums[index];
    vec4 compensation = lost[index];
    uint finite = 0u;
    for (uint i = 0u; i < push.sampleCount; ++i) {
        Rng rng = makeRng(uint(pixel.x), uint(pixel.y), push.firstSample + i, params.seed);
        float jitterX = random01(rng);
        float jitterY = random01(rng);
        vec3 direction = eyeDirection(vec2(pixel) + vec2(jitterX, jitterY));
        PathSample path = tracePath(params.originVoxel, direction, rng);
        vec4 value = vec4(path.radiance, path.coverage);
        if (isFinite(value)) {
            accumulate(sum, compensation, value);
            finite += 1u;
        }
    }
    sums[index] = sum;
    lost[index] = compensation;
    counts[index] += finite;
    if (finite < push.sampleCount) atomicAdd(nonFinite, push.sampleCount - finite);
}
