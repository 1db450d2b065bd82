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

struct MemoryLimits {
    // The most that voxels may take; the device's memory and limits hold besides.
    std::uint64_t voxelBytes = UINT64_MAX;
};

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

// Slots (coarsening.h) of the pool of voxels: what the limits, the device, and its memory that is free now
// allow. Some memory is left for pictures. `heldBytes` is what an earlier pool has of it.
std::uint64_t slotsAllowed(const MemoryLimits& limits, const gpu::DeviceInfo& device,
                           std::uint64_t availableBytes, std::uint64_t heldBytes);

// The message "voxels-coarsened", for the person who looks; nothing when all is shown as finely as it is.
std::optional<Message> coarseningMessage(const Coarsening& coarsening, std::uint64_t shownBlocks,
                                         std::uint64_t slotsAllowed);

}  // namespace macula::trace
