// The splats of a tile, front to back, and the pixels of a thread: kRows of one column, one below the other.
// On a CPU a thread has all rows of its column, so that the eight lanes are the eight columns of a tile and
// all rows share the cost of a splat; on a graphics card only a few rows, so that there are enough threads.
layout(constant_id = 1) const int kRows = 8;
layout(local_size_x_id = 2) in;  // kTileColumns in a row of threads, then the next rows

layout(binding = 2) uniform usamplerBuffer rangeTexels;  // of a tile: first entry, and one after the last
layout(binding = 3) uniform usamplerBuffer entryTexels;  // splat; number of this pair of splat and tile

uvec2 entriesOfTile() {
    return texelFetch(rangeTexels, int(gl_WorkGroupID.y) * frame.tiles.x + int(gl_WorkGroupID.x)).xy;
}

// The first pixel of the thread.
ivec2 firstPixel() {
    int thread = int(gl_LocalInvocationID.x);
    return ivec2(int(gl_WorkGroupID.x) * kTileColumns + thread % kTileColumns,
                 int(gl_WorkGroupID.y) * frame.tileRows + thread / kTileColumns * kRows);
}
