// SSIM by tiles, for graphics cards and native kernels: a group reads the kTile^2 pixels of its threads and
// those around them once, and sums over windows in shared memory, along columns and then along rows, in the
// same order as strips do (loss_strips.glsl). The results of the two differ only by rounding; the loss is
// also summed in another order.
//
// The wide tile has the pixels of the threads and kReach more on each side, row by row.
//
// Needs: vec4 windowed(at, which), the value to sum at index `at` of the wide tile; `which` is the argument
// of windowSum.
#include "splat/loss_setup.glsl"

const int kTile = 16;
const int kReach = 5;  // pixels of a window to each side
const int kWide = kTile + 2 * kReach;
const int kThreads = kTile * kTile;
layout(local_size_x = kTile, local_size_y = kTile) in;

shared vec4 columnSums[kTile * kWide];  // row by row

vec4 windowed(int at, int which);

int thread() {
    return int(gl_LocalInvocationIndex);
}

// Coordinates of the first pixel of the wide tile.
ivec2 wideCorner() {
    return ivec2(gl_WorkGroupID.xy) * kTile - kReach;
}

ivec2 widePixel(int at) {
    return wideCorner() + ivec2(at % kWide, at / kWide);
}

bool isInPicture(ivec2 pixel) {
    return pixel == clamp(pixel, ivec2(0), params.imageSize - ivec2(1));
}

int indexOf(ivec2 pixel) {
    return pixel.y * params.imageSize.x + pixel.x;
}

// The sum over the window of the thread's pixel. All threads of the group must call it together, after they
// have written what windowed() reads.
vec4 windowSum(int which) {
    barrier();  // earlier sums have been read, and windowed()'s data is written
    for (int at = thread(); at < kTile * kWide; at += kThreads) {
        vec4 sum = vec4(0.0);
        [[unroll]] for (int i = 0; i <= 2 * kReach; ++i) sum +=
            ssimTap(i - kReach) * windowed(at + i * kWide, which);
        columnSums[at] = sum;
    }
    barrier();
    int first = int(gl_LocalInvocationID.y) * kWide + int(gl_LocalInvocationID.x);
    vec4 sum = vec4(0.0);
    [[unroll]] for (int i = 0; i <= 2 * kReach; ++i) sum += ssimTap(i - kReach) * columnSums[first + i];
    return sum;
}

// Thread 0 gets the sum over all threads of the group, always in the same order.
vec4 sumOfTile(vec4 part) {
    barrier();
    columnSums[thread()] = part;
    for (int step = kThreads / 2; step > 0; step /= 2) {
        barrier();
        if (thread() < step) columnSums[thread()] += columnSums[thread() + step];
    }
    return columnSums[0];  // thread 0 wrote it
}

int tileIndex() {
    return int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x);
}
