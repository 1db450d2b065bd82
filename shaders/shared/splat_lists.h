// How lists of tiles are made on the device (shaders/splat/sort_*.comp, tile_*.comp).
#ifndef MACULA_SHARED_SPLAT_LISTS_H
#define MACULA_SHARED_SPLAT_LISTS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

MACULA_SHARED_CONST uint kListThreads = 256u;  // of a workgroup, in all of these kernels
MACULA_SHARED_CONST uint kSortBlock = 1024u;   // items that a workgroup sorts
MACULA_SHARED_CONST uint kSortDigits = 256u;   // of a pass; as many as threads
MACULA_SHARED_CONST uint kTileParts = 8u;      // threads that look for the tiles of a splat

// The state of a list that is sorted: splats by depth, or pairs of a splat and a tile by tile.
struct SplatListState {
    uint count;     // 0 when there was no room for all pairs
    uint blocks;    // blocks of kSortBlock items
    uvec3 groups;   // blocks, 1, 1: the size of dispatches that only the device knows
    uint wanted;    // pairs, whether there is room or not; saturates
    uint capacity;  // pairs there is room for
};

struct SplatSortPush {
    uint shift;  // of the key, to the digit of this pass
};

MACULA_SHARED_END
#endif
