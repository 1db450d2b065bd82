// How many tiles show each splat, and how many pairs of both a workgroup has.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/tile_walk.glsl"

layout(binding = 3, scalar) writeonly buffer TileCounts {
    uint tileCounts[];  // by place in the order of depth, and part
};
layout(binding = 4, scalar) writeonly buffer GroupCounts {
    uint groupCounts[];
};

void main() {
    uint splat;
    TileWalk walk = walkOfThread(splat);
    uint count = 0u;
    for (ivec2 tile = walk.first; tile.y < walk.end.y; tile = nextTile(walk, tile))
        count += showsInTile(walk, tile) ? 1u : 0u;
    if (rankOfThread() < frame.count) tileCounts[gl_GlobalInvocationID.x] = count;
    uint before = sumBefore(count);
    if (gl_LocalInvocationID.x == kListThreads - 1u) groupCounts[gl_WorkGroupID.x] = before + count;
}
