// A prefix sum that turns the number of pairs of each workgroup into their start, and checks whether there is
// room for all. One workgroup.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/frame.glsl"
#include "splat/block_scan.glsl"

layout(local_size_x = kListThreads) in;

layout(binding = 1, scalar) buffer State {
    SplatListState state;
};
layout(binding = 2, scalar) buffer GroupCounts {
    uint groupCounts[];
};

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint splatsOfGroup = kListThreads / kTileParts;
    uint groups = (frame.count + splatsOfGroup - 1u) / splatsOfGroup;
    uint sum = 0u;
    for (uint begin = 0u; begin < groups; begin += kListThreads) {
        uint group = begin + thread;
        uint count = group < groups ? groupCounts[group] : 0u;
        uint before = sumBefore(count);
        if (group < groups) groupCounts[group] = saturatingSum(sum, before);
        sum = saturatingSum(sum, scanned[kListThreads - 1u]);
        barrier();
    }
    if (thread > 0u) return;
    uint count = sum <= state.capacity ? sum : 0u;
    state.count = count;
    state.blocks = (count + kSortBlock - 1u) / kSortBlock;
    state.groups = uvec3((count + kSortBlock - 1u) / kSortBlock, 1u, 1u);
    state.wanted = sum;
}
