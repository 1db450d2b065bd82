// Finds the range of each tile's entries. A thread for each tile.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/frame.glsl"
#include "shared/splat_lists.h"

layout(local_size_x = kListThreads) in;

layout(binding = 1, scalar) readonly buffer State {
    SplatListState state;
};
layout(binding = 2, scalar) readonly buffer Pairs {
    uvec2 pairs[];  // tile, number; sorted
};
layout(binding = 3, scalar) writeonly buffer Ranges {
    uvec2 ranges[];  // first entry, and one after the last
};

// The first pair of this tile or a later one, by bisection. All threads take the same number of rounds, so
// that they stay together.
uint firstOf(uint tile, uint count) {
    uint low = 0u;
    uint high = count;
    for (int round = 0; round < 32; ++round) {
        uint middle = low + (high - low) / 2u;
        bool before = low < high && pairs[min(middle, count - 1u)].x < tile;
        high = before || low >= high ? high : middle;
        low = before ? middle + 1u : low;
    }
    return low;
}

void main() {
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= uint(frame.tiles.x * frame.tiles.y)) return;
    uint count = state.count;
    ranges[tile] = count == 0u ? uvec2(0u) : uvec2(firstOf(tile, count), firstOf(tile + 1u, count));
}
