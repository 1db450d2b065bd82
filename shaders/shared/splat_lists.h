// How lists of tiles are made on the device (shaders/splat/sort_*.comp, tile_*.comp).
#ifndef MACULA_SHARED_SPLAT_LISTS_H
#define MACULA_SHARED_SPLAT_LISTS_H
#include "shared/shared.h"
MACULA_SHARED_BEGIN

MACULA_SHARED_CONST uint kListThreads = 256u;  // of a workgroup, in all of these kernels
MACULA_SHARED_CONST uint kSortBlock = 1024u;   // items that a workgroup sorts
MACULA_SHARED_CONST uint kSortDigits = 256u;   // values of the digit of a pass; as many as kListThreads
MACULA_SHARED_CONST uint kTileParts = 8u;      // threads that share the search for a splat's tiles

// The state of a list to sort: splats by depth, or pairs of a splat and a tile by tile.
struct SplatListState {
    uint count;     // 0 when there was no room for all pairs
    uint blocks;    // blocks of kSortBlock items
    uvec3 groups;   // blocks, 1, 1: size of indirect dispatches
    uint wanted;    // pairs, even if there is no room for them; saturates
    uint capacity;  // pairs there is room for
};

struct SplatSortPush {
    uint shift;  // bits of the key below the digit of this pass
};

MACULA_SHARED_END
#endif
