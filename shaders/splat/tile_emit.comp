// The pairs of splats and tiles, numbered in the order of depth and of tiles.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/tile_walk.glsl"

layout(binding = 3, scalar) readonly buffer TileCounts {
    uint tileCounts[];  // by place in the order of depth, and part
};
layout(binding = 4, scalar) readonly buffer GroupStarts {
    uint groupStarts[];
};
layout(binding = 5, scalar) readonly buffer State {
    SplatListState state;
};
layout(binding = 6, scalar) writeonly buffer Pairs {
    uvec2 pairs[];  // tile, number
};
layout(binding = 7, scalar) writeonly buffer SplatOfPair {
    uint splatOfPair[];
};
layout(binding = 8, scalar) writeonly buffer PairRanges {
    uvec2 pairRanges[];  // of a splat: first pair, and how many
};

void main() {
    uint splat;
    TileWalk walk = walkOfThread(splat);
    uint thread = gl_LocalInvocationID.x;
    bool known = rankOfThread() < frame.count;
    bool fits = state.count > 0u;
    uint before = sumBefore(known ? tileCounts[gl_GlobalInvocationID.x] : 0u);
    uint start = groupStarts[gl_WorkGroupID.x] + before;
    if (known && thread % kTileParts == 0u) {
        bool shows = fits && walk.screen.opacity > 0.0;
        pairRanges[splat] = shows ? uvec2(start, scanned[thread + kTileParts - 1u] - before) : uvec2(0u);
    }
    walk.end.y = fits ? walk.end.y : walk.first.y;
    uint at = start;
    for (ivec2 tile = walk.first; tile.y < walk.end.y; tile = nextTile(walk, tile)) {
        if (!showsInTile(walk, tile)) continue;
        pairs[at] = uvec2(uint(tile.y * frame.tiles.x + tile.x), at);
        splatOfPair[at] = splat;
        ++at;
    }
}
