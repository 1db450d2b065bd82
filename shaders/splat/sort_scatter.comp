// Moves the items of a block to the positions of their digits. First sorts them within the block, by the
// lower and then the upper half of the digit, so that equal digits lie together and keep their order.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "splat/sort.glsl"
#include "splat/block_scan.glsl"

layout(binding = 1, scalar) readonly buffer Items {
    uvec2 items[];  // key, value
};
// sort_scan has run; if not, each block sums the counts that it needs: for few blocks cheaper than a
// dispatch.
layout(constant_id = 0) const bool kScanned = true;

layout(binding = 2, scalar) readonly buffer Counts {
    uint counts[];  // by digit, then by block: items with the digit in the blocks before; if not kScanned, in
                    // the block itself
};
layout(binding = 3, scalar) readonly buffer Totals {
    uint totals[];  // by digit, if kScanned
};
layout(binding = 4, scalar) writeonly buffer Sorted {
    uvec2 sorted[];
};

const uint kOwn = kSortBlock / kListThreads;  // consecutive items of a thread
const uint kHalf = 16u;                       // values of half a digit

shared uint keys[kSortBlock];
shared uint values[kSortBlock];
shared uint places[kHalf * kListThreads];  // by half digit, then by thread
shared uint firstOfDigit[kSortDigits];     // its first item in the block
shared uint digitBase[kSortDigits];        // position in the result of this block's first item

// Turns the counts in `places` into positions by a prefix sum.
void scanPlaces(uint thread) {
    uint sum = 0u;
    [[unroll]] for (uint i = 0u; i < kHalf; ++i) sum += places[thread * kHalf + i];
    uint place = sumBefore(sum);
    [[unroll]] for (uint i = 0u; i < kHalf; ++i) {
        uint count = places[thread * kHalf + i];
        places[thread * kHalf + i] = place;
        place += count;
    }
    barrier();
}

// Counts the items of a digit: all of them, and those in the blocks before this one.
void countDigit(uint digit, out uint total, out uint before) {
    uint first = digit * state.blocks;
    if (kScanned) {
        total = totals[digit];
        before = counts[first + gl_WorkGroupID.x];
        return;
    }
    total = 0u;
    before = 0u;
    for (uint block = 0u; block < state.blocks; ++block) {
        if (block == gl_WorkGroupID.x) before = total;
        total += counts[first + block];
    }
}

void main() {
    uint thread = gl_LocalInvocationID.x;
    uint begin = gl_WorkGroupID.x * kSortBlock;
    uint count = min(state.count - begin, kSortBlock);

    uint key[kOwn];
    uint value[kOwn];
    [[unroll]] for (uint i = 0u; i < kOwn; ++i) {
        uint at = thread * kOwn + i;
        uvec2 item = items[begin + min(at, count - 1u)];
        key[i] = at < count ? item.x : 0xffffffffu;  // is sorted behind all others
        value[i] = item.y;
    }
    [[unroll]] for (uint shift = 0u; shift < 8u; shift += 4u) {
        [[unroll]] for (uint i = 0u; i < kHalf; ++i) places[i * kListThreads + thread] = 0u;
        uint before[kOwn];
        [[unroll]] for (uint i = 0u; i < kOwn; ++i) {
            uint at = ((digitOf(key[i]) >> shift) & (kHalf - 1u)) * kListThreads + thread;
            before[i] = places[at];
            places[at] = before[i] + 1u;
        }
        barrier();
        scanPlaces(thread);
        [[unroll]] for (uint i = 0u; i < kOwn; ++i) {
            uint at = ((digitOf(key[i]) >> shift) & (kHalf - 1u)) * kListThreads + thread;
            uint to = places[at] + before[i];
            keys[to] = key[i];
            values[to] = value[i];
        }
        barrier();
        [[unroll]] for (uint i = 0u; i < kOwn; ++i) {
            key[i] = keys[thread * kOwn + i];
            value[i] = values[thread * kOwn + i];
        }
        barrier();
    }
    uint total;
    uint before;
    countDigit(thread, total, before);
    digitBase[thread] = sumBefore(total) + before;
    [[unroll]] for (uint i = 0u; i < kOwn; ++i) {
        uint at = thread * kOwn + i;
        uint digit = digitOf(key[i]);
        uint last = digitOf(keys[at > 0u ? at - 1u : 0u]);
        if (at == 0u || digit != last) firstOfDigit[digit] = at;
    }
    barrier();
    // Neighbouring threads write neighbouring items.
    [[unroll]] for (uint i = 0u; i < kOwn; ++i) {
        uint at = i * kListThreads + thread;
        uint digit = digitOf(keys[at]);
        if (at < count) sorted[digitBase[digit] + at - firstOfDigit[digit]] = uvec2(keys[at], values[at]);
    }
}
