// Adds the recorded light of paths to the cache of indirect light, and clears the records. A cell gets a
// place in its bucket when light is first added to it; if the bucket is full, the light is dropped, and
// counted as such.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "shared/indirect_light.h"

layout(local_size_x = 64) in;

layout(binding = 0, scalar) buffer Records {
    IndirectRecord records[];
};
layout(binding = 1, scalar) buffer Tags {
    uint tags[];  // kIndirectWays for each bucket; 0: free
};
layout(binding = 2, scalar) buffer Cells {
    uint cells[];  // four numbers each: sums of red, green and blue, and samples
};
layout(binding = 3, scalar) buffer Dropped {
    uint dropped;
};
layout(push_constant, scalar) uniform Push {
    IndirectPush push;
};

void addTo(uvec2 bucketAndTag, uvec3 units) {
    for (uint way = 0u; way < kIndirectWays; ++way) {
        uint cell = kIndirectWays * bucketAndTag.x + way;
        uint before = atomicCompSwap(tags[cell], 0u, bucketAndTag.y);
        if (before != 0u && before != bucketAndTag.y) continue;
        if (cells[4u * cell + 3u] >= kIndirectMostSamples) return;
        atomicAdd(cells[4u * cell], units.x);
        atomicAdd(cells[4u * cell + 1u], units.y);
        atomicAdd(cells[4u * cell + 2u], units.z);
        atomicAdd(cells[4u * cell + 3u], 1u);
        return;
    }
    atomicAdd(dropped, 1u);
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= push.recordCount) return;
    IndirectRecord record = records[index];
    if (record.cells.y == 0u) return;
    records[index].cells.y = 0u;
    uvec3 units = uvec3(clamp(record.light / push.unit, vec3(0.0), vec3(kIndirectMostUnits)) + 0.5);
    addTo(record.cells.xy, units);
    addTo(record.cells.zw, units);
}
