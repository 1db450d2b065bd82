// Writes the pairs of splats and tiles, numbered in the order of depth, then of tiles.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/tile_walk.glsl"

layout(binding = 3, scalar) readonly buffer TileCounts {
    uint tileCounts[];  // by rank in the order of depth, then by part
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
    uint count = known ? tileCounts[gl_GlobalInvocationID.x] : 0u;
    uint before = sumBefore(count);
    uint start = groupStarts[gl_WorkGroupID.x] + before;
    if (known && thread % kTileParts == 0u) {
        bool shows = fits && walk.screen.opacity > 0.0;
        pairRanges[splat] = shows ? uvec2(start, scanned[thread + kTileParts - 1u] - before) : uvec2(0u);
    }
    // Writes exactly as many pairs as were counted, so that it neither overwrites other threads' pairs nor
    // leaves one of its own unset. If it finds fewer, because it was compiled to round differently, a tile
    // gets the splat twice.
    uint end = fits ? start + count : start;
    uint tileCount = uint(frame.tiles.x * frame.tiles.y);
    ivec2 tile = walk.first;
    for (uint at = start; at < end; tile = nextTile(walk, tile)) {
        bool within = tile.y < walk.end.y;
        if (within && !showsInTile(walk, tile)) continue;
        ivec2 shown = within ? tile : walk.first;
        pairs[at] = uvec2(min(uint(shown.y * frame.tiles.x + shown.x), tileCount - 1u), at);
        splatOfPair[at] = splat;
        ++at;
    }
}
