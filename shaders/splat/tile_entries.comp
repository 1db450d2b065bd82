// Writes the splats of each tile, front to back, from the sorted pairs.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "shared/splat_lists.h"

layout(local_size_x = kListThreads) in;

layout(binding = 0, scalar) readonly buffer State {
    SplatListState state;
};
layout(binding = 1, scalar) readonly buffer Pairs {
    uvec2 pairs[];  // tile, number; sorted
};
layout(binding = 2, scalar) readonly buffer SplatOfPair {
    uint splatOfPair[];
};
layout(binding = 3, scalar) writeonly buffer Entries {
    uvec2 entries[];  // splat, number of the pair
};

void main() {
    uint count = state.count;
    for (uint i = 0u; i < kSortBlock; i += kListThreads) {
        uint at = gl_WorkGroupID.x * kSortBlock + i + gl_LocalInvocationID.x;
        if (at < count) entries[at] = uvec2(splatOfPair[pairs[at].y], pairs[at].y);
    }
}
