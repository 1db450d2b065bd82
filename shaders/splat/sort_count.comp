// Counts the keys of a block that have each digit.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/sort.glsl"

layout(binding = 1, scalar) readonly buffer Items {
    uvec2 items[];  // key, value
};
layout(binding = 2, scalar) writeonly buffer Counts {
    uint counts[];  // by digit, then by block
};

shared uint histogram[kSortDigits];

void main() {
    uint thread = gl_LocalInvocationID.x;
    histogram[thread] = 0u;
    barrier();
    uint count = state.count;
    for (uint i = 0u; i < kSortBlock; i += kListThreads) {
        uint at = gl_WorkGroupID.x * kSortBlock + i + thread;
        if (at < count) atomicAdd(histogram[digitOf(items[at].x)], 1u);
    }
    barrier();
    counts[thread * state.blocks + gl_WorkGroupID.x] = histogram[thread];
}
