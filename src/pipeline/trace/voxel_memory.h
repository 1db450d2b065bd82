// What the voxels of a volume may take of the device's memory, and what they do take.
#pragma once

#include <cstdint>
#include <optional>

#include "base/message.h"
#include "pipeline/gpu/device_info.h"

namespace macula {
struct Coarsening;  // not included: it says `slots`, which Qt makes a keyword
}

namespace macula::trace {

// The pool of voxels is one buffer, but one view of it holds no more than the device's texel buffers do, 2^27
// values on most: shaders choose among so many views.
inline constexpr std::uint64_t kMostPoolViews = 4;

struct MemoryLimits {
    // The most that voxels may take; the device's memory and limits hold besides.
    std::uint64_t voxelBytes = UINT64_MAX;
    // The most voxels in one view of the pool, a power of two from 128 on; what the device allows holds
    // besides. Tests alone take less than the default.
    std::uint64_t viewValues = std::uint64_t{1} << 31;
    // Of a second volume: at most half of the memory that is free, and a pool in one view, as its shaders
    // read.
    bool isSecond = false;

    bool operator==(const MemoryLimits&) const = default;
};

// Values of each view but the last, a power of two: log2.
int poolViewShift(const MemoryLimits& limits, const gpu::DeviceInfo& device);

struct VoxelMemory {
    std::uint64_t visibleBricks = 0;
    std::uint64_t shownBlocks = 0;   // of voxels, that visible bricks touch
    std::uint64_t coarseBlocks = 0;  // of these, kept more coarsely than the volume is
    std::uint64_t poolBytes = 0;     // on the device, for voxels
    std::uint64_t gridBytes = 0;  // on the device, for the table of blocks and the majorants: by the size of
                                  // the volume, whatever is visible
    std::uint64_t uploadedBlocks = 0;  // by the latest change of what is visible
    std::uint64_t uploadedBytes = 0;   // likewise; of voxels
};

// What bounds the pool.
enum class PoolBound { setting, buffers, memory };
struct PoolRoom {
    std::uint64_t slotCount = 0;  // coarsening.h
    PoolBound bound = PoolBound::memory;
};
// What the limits, the device, and its memory that is free now allow. Some memory is left for pictures.
// `heldBytes` is what an earlier pool has of it.
PoolRoom poolRoom(const MemoryLimits& limits, const gpu::DeviceInfo& device, std::uint64_t availableBytes,
                  std::uint64_t heldBytes);

// The message "voxels-coarsened", for the person who looks; nothing when all is shown as finely as it is.
std::optional<Message> coarseningMessage(const Coarsening& coarsening, std::uint64_t shownBlocks,
                                         const PoolRoom& room);

}  // namespace macula::trace
