// Counts the tiles in which each splat shows, and the pairs of splats and tiles of each workgroup.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/tile_walk.glsl"

layout(binding = 3, scalar) writeonly buffer TileCounts {
    uint tileCounts[];  // by rank in the order of depth, then by part
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
