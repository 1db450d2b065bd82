// The tiles of a splat, row by row. kTileParts threads share the rows, because a splat may fill the picture.
#include "splat/frame.glsl"
#include "splat/screen.glsl"
#include "splat/block_scan.glsl"

layout(local_size_x = kListThreads) in;

layout(binding = 2, scalar) readonly buffer Items {
    uvec2 items[];  // key, splat; front to back
};

struct TileWalk {
    ScreenSplat screen;
    ivec2 first;  // tiles: first <= tile < end
    ivec2 end;
    bool one;    // there is only one tile, in which the splat is known to show
    float most;  // mostPower(): above it the splat does not show
};

// The rank, in the order of depth, of the thread's splat.
uint rankOfThread() {
    return gl_GlobalInvocationID.x / kTileParts;
}

// The thread's part of the tiles of its splat; empty when the splat does not show.
TileWalk walkOfThread(out uint splat) {
    TileWalk walk;
    uint rank = rankOfThread();
    splat = items[min(rank, frame.count - 1u)].y;
    walk.screen = fetchShown(int(splat)).screen;
    ivec2 first;
    ivec2 end;
    pixelsOf(walk.screen, frame.view.sizePx, first, end);
    bool shows = rank < frame.count && walk.screen.opacity > 0.0 && first.x < end.x && first.y < end.y;
    ivec2 tile = ivec2(kTileColumns, frame.tileRows);
    first = first / tile;
    end = (end - 1) / tile + 1;
    walk.one = end == first + 1;
    walk.most = walk.one ? 0.0 : mostPower(walk.screen, frame.view);
    int part = int(gl_GlobalInvocationID.x % kTileParts);
    int rows = shows ? end.y - first.y : 0;
    walk.first = ivec2(first.x, first.y + rows * part / int(kTileParts));
    walk.end = ivec2(end.x, first.y + rows * (part + 1) / int(kTileParts));
    return walk;
}

bool showsInTile(TileWalk walk, ivec2 tile) {
    ivec2 size = ivec2(kTileColumns, frame.tileRows);
    ivec2 low = tile * size;
    ivec2 high = min(low + size, frame.view.sizePx);
    // As showsIn, but computes mostPower() only once for all tiles. Both kernels that call this must get the
    // same answer.
    precise vec2 fromMeanToLow = vec2(low) + vec2(0.5) - walk.screen.mean;
    precise vec2 fromMeanToHigh = vec2(high) - vec2(0.5) - walk.screen.mean;
    return walk.one || leastPowerIn(walk.screen.conic, fromMeanToLow, fromMeanToHigh) <= walk.most;
}

// The next tile of the thread's rows.
ivec2 nextTile(TileWalk walk, ivec2 tile) {
    ++tile.x;
    return tile.x < walk.end.x ? tile : ivec2(walk.first.x, tile.y + 1);
}
