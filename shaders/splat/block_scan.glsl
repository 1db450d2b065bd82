// Sums over the threads of a workgroup. Uses no subgroups, so that it is the same on every device.
#extension GL_EXT_control_flow_attributes : require

#include "shared/splat_lists.h"

shared uint scanned[kListThreads];

uint saturatingSum(uint a, uint b) {
    uint sum = a + b;
    return sum < a ? 0xffffffffu : sum;
}

// The exclusive prefix sum, over the values of the threads before this one (Hillis and Steele 1986). Leaves
// the sum of all in scanned[kListThreads - 1]; put a barrier before the next call. All threads must call it.
uint sumBefore(uint value) {
    uint thread = gl_LocalInvocationID.x;
    scanned[thread] = value;
    barrier();
    [[unroll]] for (uint reach = 1u; reach < kListThreads; reach *= 2u) {
        uint other = scanned[thread >= reach ? thread - reach : 0u];
        barrier();
        if (thread >= reach) scanned[thread] = saturatingSum(scanned[thread], other);
        barrier();
    }
    return thread > 0u ? scanned[thread - 1u] : 0u;
}
