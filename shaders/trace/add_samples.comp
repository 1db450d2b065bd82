// Adds the samples that path_side.comp has traced to the picture: for each pixel in the order of the samples,
// as path_samples.glsl does.
#version 460
#extension GL_GOOGLE_include_directive : require

#define OUT(type) out type
#define INOUT(type) inout type
#define PRECISE precise
#include "lib/picture.glsl"
#include "shared/trace_params.h"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, scalar) readonly buffer Params {
    TraceParams params;
};
#include "trace/film.glsl"
layout(binding = 22, scalar) readonly buffer Traced {
    vec4 traced[];  // see path_side.comp
};

void main() {
    PlannedBlock plan = planned[gl_WorkGroupID.x];
    int block = int(plan.block);
    int columns = (params.imageSize.x + 7) / 8;
    ivec2 pixel = 8 * ivec2(block % columns, block / columns) + ivec2(gl_LocalInvocationID.xy);
    if (any(greaterThanEqual(pixel, params.imageSize))) return;

    int index = pixel.y * params.imageSize.x + pixel.x;
    uint place = 64u * gl_WorkGroupID.x + gl_LocalInvocationIndex;
    uint stride = 64u * gl_NumWorkGroups.x;
    vec4 sum = sums[index];
    vec4 compensation = lost[index];
    vec2 square = squares[index];
    uint finite = 0u;
    uint done = 0u;
    for (uint number = 0u; number < plan.sampleCount; ++number) {
        vec4 value = traced[number * stride + place];
        if (value.w < 0.0) continue;
        done += 1u;
        if (isFinite(value) && isFinite(sum + value)) {
            accumulate(sum, compensation, value);
            accumulate(square, squareOfLuminance(value.xyz));
            finite += 1u;
        }
    }
    sums[index] = sum;
    lost[index] = compensation;
    squares[index] = square;
    counts[index] += finite;
    if (finite < done) atomicAdd(nonFinite, done - finite);
    if (done < plan.sampleCount) atomicAdd(abandoned, plan.sampleCount - done);
}
