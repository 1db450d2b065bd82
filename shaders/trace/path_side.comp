// Traces the samples of the pixels of some blocks, and stores the light of each: add_samples.comp adds it to
// the picture. The samples are those of path.comp. For the purpose see src/pipeline/trace/side_by_side.h.
//
// A thread takes the next sample of any pixel until none is left, so that it is never idle while others
// follow long paths (Aila and Laine 2009, "Understanding the Efficiency of Ray Traversal on GPUs": persistent
// threads). A sample does not depend on the thread that traces it.
#version 460
#extension GL_GOOGLE_include_directive : require

#define INDIRECT_BINDING 19
#include "trace/host.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 1) const int kMaxRounds = 16000;  // as in path_samples.glsl
// Each thread takes at most its share. Without that, where groups run one after another, the first would take
// all samples, and lavapipe would end its loop.
layout(constant_id = 14) const bool kShares = false;

#define FAULTS_BINDING 18
#include "trace/faults.glsl"
layout(binding = 16, scalar) readonly buffer Plan {
    PlannedBlock planned[];
};
layout(binding = 17, scalar) writeonly buffer Traced {
    vec4 traced[];  // radiance and coverage, 64 pixels of each block for one sample, then for the next;
                    // coverage -1: abandoned
};
layout(binding = 22, scalar) buffer Taken {
    uint taken;  // number of samples taken: the first of each pixel, then the second, and so on; including
                 // some outside the picture or beyond a block's plan
};
layout(push_constant, scalar) uniform Push {
    SidePush push;
};

struct Sample {
    uint item;  // its number among those taken
    ivec2 pixel;
    uint number;  // of the sample within the block's plan
    uint index;   // for the random sequence
};

// False when no sample is left, or this thread's share is used up.
bool takeSample(inout uint mayTake, out Sample next) {
    uint places = 64u * push.blockCount;
    int columns = (params.imageSize.x + 7) / 8;
    next = Sample(0u, ivec2(0), 0u, 0u);
    bool isSample = false;
    bool isLast = false;
    while (!isSample && !isLast) {
        isLast = mayTake == 0u;
        next.item = isLast ? 0xffffffffu : atomicAdd(taken, 1u);
        isLast = next.item >= push.mostSamples * places;
        uint place = isLast ? 0u : next.item % places;
        PlannedBlock plan = planned[place / 64u];
        int block = int(plan.block);
        next.pixel = 8 * ivec2(block % columns, block / columns) + ivec2(place % 8u, place % 64u / 8u);
        next.number = next.item / places;
        next.index = plan.firstSample + next.number;
        isSample = !isLast && next.number < plan.sampleCount && all(lessThan(next.pixel, params.imageSize));
        mayTake -= isLast ? 0u : 1u;
    }
    return isSample;
}

void main() {
    uint mayTake = 0xffffffffu;
    if (kShares) {
        uint threads = 64u * gl_NumWorkGroups.x;
        mayTake = (64u * push.blockCount * push.mostSamples + threads - 1u) / threads;
    }
    int rounds = 0;  // of the samples done; counted only with shares
    int above = 0;   // sum of Path.aboveBound over all samples
    Rng rng;
    Sample next;
    bool hasSample = takeSample(mayTake, next);
    Path path = startSample(next.pixel, next.index, rng);
    while (hasSample) {
        bool isLost = rounds + path.rounds >= kMaxRounds;
        if (isLost || !extendPath(path, rng)) {
            traced[next.item] = isLost ? vec4(0.0, 0.0, 0.0, -1.0) : vec4(lightOf(path), path.coverage);
            if (useIndirect() && !isLost && next.number == 0u && isFinite(vec4(path.radiance, 1.0)))
                tellIndirect(next.pixel, IndirectRecord(path.cells, path.radiance));
            if (kShares) rounds += path.rounds;
            above += path.aboveBound;
            hasSample = takeSample(mayTake, next);
            path = startSample(next.pixel, next.index, rng);
        }
    }
    if (above > 0) atomicAdd(aboveBound, uint(above));
}
