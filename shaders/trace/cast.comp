// Adds samples to the pixels of some blocks of the picture, by ray casting: the deterministic counterpart of
// path.comp.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "trace/host.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

#include "trace/film.glsl"

// See path_samples.glsl. A ray takes some thousands of rounds, and neighbouring rays about as many.
layout(constant_id = 1) const int kMaxRounds = 16000;

void main() {
    PlannedBlock plan = planned[gl_WorkGroupID.x];
    int block = int(plan.block);
    int columns = (params.imageSize.x + 7) / 8;
    ivec2 pixel = 8 * ivec2(block % columns, block / columns) + ivec2(gl_LocalInvocationID.xy);
    if (any(greaterThanEqual(pixel, params.imageSize))) return;

    int index = pixel.y * params.imageSize.x + pixel.x;
    vec4 sum = sums[index];
    vec4 compensation = lost[index];
    vec2 square = squares[index];
    uint finite = 0u;
    uint done = 0u;
    int rounds = 0;
    while (done < plan.sampleCount && rounds < kMaxRounds) {
        vec4 value = castSample(pixel, plan.firstSample + done, rounds);
        if (isFinite(value) && isFinite(sum + value)) {
            accumulate(sum, compensation, value);
            accumulate(square, squareOfLuminance(value.xyz));
            finite += 1u;
        }
        done += 1u;
    }
    sums[index] = sum;
    lost[index] = compensation;
    squares[index] = square;
    counts[index] += finite;
    if (finite < done) atomicAdd(nonFinite, done - finite);
    if (done < plan.sampleCount) atomicAdd(abandoned, plan.sampleCount - done);
}
