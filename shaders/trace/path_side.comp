// Traces the samples of the pixels of some blocks, several of a pixel side by side, and keeps what each of them brings:
// add_samples.comp adds it to the picture. The samples are those of path.comp. src/pipeline/trace/side_by_side.h says what for.
//
// Work groups: along x the blocks, along z the threads of a pixel.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "trace/host.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 1) const int kMaxRounds = 16000;  // as in path_samples.glsl

#define FAULTS_BINDING 18
#include "trace/faults.glsl"
layout(binding = 16, scalar) readonly buffer Plan {
    PlannedBlock planned[];  // by work group along x
};
layout(binding = 17, scalar) writeonly buffer Traced {
    vec4 traced[];  // radiance and coverage, 64 pixels of each block for one sample, then for the next; coverage -1: abandoned
};

void main() {
    PlannedBlock plan = planned[gl_WorkGroupID.x];
    int block = int(plan.block);
    int columns = (params.imageSize.x + 7) / 8;
    ivec2 pixel = 8 * ivec2(block % columns, block / columns) + ivec2(gl_LocalInvocationID.xy);
    if (any(greaterThanEqual(pixel, params.imageSize))) return;

    uint place = 64u * gl_WorkGroupID.x + gl_LocalInvocationIndex;
    uint stride = 64u * gl_NumWorkGroups.x;
    uint number = gl_WorkGroupID.z;  // of the sample under way, from the plan's first on
    int rounds = 0;                  // of the samples done
    int above = 0;                   // likewise, Path.aboveBound
    Rng rng;
    Path path = startSample(pixel, plan.firstSample + number, rng);
    while (number < plan.sampleCount && rounds + path.rounds < kMaxRounds) {
        rounds += 1;
        if (!extendPath(path, rng)) {
            traced[number * stride + place] = vec4(path.radiance, path.coverage);
            number += gl_NumWorkGroups.z;
            rounds += path.rounds;
            above += path.aboveBound;
            path = startSample(pixel, plan.firstSample + number, rng);
        }
    }
    if (number < plan.sampleCount) above += path.aboveBound;  // of the one that is given up
    for (; number < plan.sampleCount; number += gl_NumWorkGroups.z) traced[number * stride + place] = vec4(0.0, 0.0, 0.0, -1.0);
    if (above > 0) atomicAdd(aboveBound, uint(above));
}
