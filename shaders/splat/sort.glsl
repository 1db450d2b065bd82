// A stable radix sort, lowest bits first, one byte of the key in each pass. A pass counts the digits of each
// block, turns counts into positions, and moves the items there. No workgroup waits for another, and nothing
// depends on their order: the result is the same to the bit each time.
#include "shared/splat_lists.h"

layout(local_size_x = kListThreads) in;
layout(push_constant, scalar) uniform Push {
    SplatSortPush push;
};
layout(binding = 0, scalar) readonly buffer State {
    SplatListState state;
};

uint digitOf(uint key) {
    return (key >> push.shift) & (kSortDigits - 1u);
}
