// How much of the device's memory the voxels of a volume may use, and how much they do use.
#pragma once

#include <cstdint>
#include <optional>

#include "base/message.h"
#include "pipeline/gpu/device_info.h"

namespace macula {
struct Coarsening;  // not included: it has a member `slots`, which is a Qt keyword
}

namespace macula::trace {

// The pool of voxels is one buffer, but a view of it holds no more than the device's limit for texel buffers,
// 2^27 values on most devices: shaders choose among so many views.
inline constexpr std::uint64_t kMostPoolViews = 4;

struct MemoryLimits {
    // The most that voxels may use; the device's memory and limits apply as well.
    std::uint64_t voxelBytes = UINT64_MAX;
    // The most voxels in one view of the pool, a power of two, at least 128; the device's limit applies as
    // well. Only tests set less than the default.
    std::uint64_t viewValues = std::uint64_t{1} << 31;
    // For a second volume: at most half of the free memory, and a pool with one view, as shaders expect.
    bool isSecond = false;

    bool operator==(const MemoryLimits&) const = default;
};

// log2 of the number of values in each view but the last.
int poolViewShift(const MemoryLimits& limits, const gpu::DeviceInfo& device);

struct VoxelMemory {
    std::uint64_t visibleBricks = 0;
    std::uint64_t shownBlocks = 0;   // blocks of voxels that visible bricks touch
    std::uint64_t coarseBlocks = 0;  // those of shownBlocks kept more coarsely than the volume
    std::uint64_t poolBytes = 0;     // on the device, for voxels
    std::uint64_t gridBytes = 0;  // on the device, for the table of blocks and the majorants: depends on the
                                  // size of the volume only
    std::uint64_t uploadedBlocks = 0;  // by the last change of visible voxels
    std::uint64_t uploadedBytes = 0;   // likewise, bytes of voxels
};

// What limits the size of the pool.
enum class PoolBound { setting, buffers, memory };
struct PoolRoom {
    std::uint64_t slotCount = 0;  // coarsening.h
    PoolBound bound = PoolBound::memory;
};
// The room that the limits, the device and its free memory allow. Leaves some memory for pictures.
// `heldBytes` is the size of the present pool, which counts as free.
PoolRoom poolRoom(const MemoryLimits& limits, const gpu::DeviceInfo& device, std::uint64_t availableBytes,
                  std::uint64_t heldBytes);

// The message "voxels-coarsened" for the viewer's user; nothing when every voxel is shown at full resolution.
std::optional<Message> coarseningMessage(const Coarsening& coarsening, std::uint64_t shownBlocks,
                                         const PoolRoom& room);

}  // namespace macula::trace
