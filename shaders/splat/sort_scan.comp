// Prefix sums: for each digit and block, how many items in the blocks before have that digit. A workgroup for
// each digit.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/sort.glsl"
#include "splat/block_scan.glsl"

layout(binding = 1, scalar) buffer Counts {
    uint counts[];  // by digit, then by block
};
layout(binding = 2, scalar) writeonly buffer Totals {
    uint totals[];  // by digit
};

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint blocks = state.blocks;
    uint first = gl_WorkGroupID.x * blocks;
    uint sum = 0u;
    for (uint begin = 0u; begin < blocks; begin += kListThreads) {
        uint block = begin + thread;
        uint count = block < blocks ? counts[first + block] : 0u;
        uint before = sumBefore(count);
        if (block < blocks) counts[first + block] = sum + before;
        sum += scanned[kListThreads - 1u];
        barrier();
    }
    if (thread == 0u) totals[gl_WorkGroupID.x] = sum;
}
