#include "pipeline/trace/voxel_memory.h"

#include <algorithm>
#include <bit>

#include "pipeline/volume/coarsening.h"

namespace macula::trace {

namespace {

constexpr std::uint64_t kSlotBytes = kSlotValues * sizeof(std::uint16_t);
constexpr double kMiB = 1024.0 * 1024.0;

Text adviceFor(PoolBound bound) {
    switch (bound) {
        case PoolBound::setting:
            return Text(
                "Show less of the volume by another preset or a clip, or allow more memory for voxels.");
        case PoolBound::buffers:
            return Text(
                "Show less of the volume by another preset or a clip: this device's buffers hold no more.");
        case PoolBound::memory:
            break;
    }
    return Text("Show less of the volume by another preset or a clip, or use a device with more memory.");
}

}  // namespace

int poolViewShift(const MemoryLimits& limits, const gpu::DeviceInfo& device) {
    const std::uint64_t most = std::min<std::uint64_t>(limits.viewValues, device.maxTexelBufferElements);
    return std::bit_width(most) - 1;
}

PoolRoom poolRoom(const MemoryLimits& limits, const gpu::DeviceInfo& device, std::uint64_t availableBytes,
                  std::uint64_t heldBytes) {
    constexpr std::uint64_t kMostValues = std::uint64_t{1} << 31;  // shaders index with 31 bits
    const std::uint64_t views = limits.isSecond ? 1 : kMostPoolViews;
    const std::uint64_t values = std::min(views << poolViewShift(limits, device), kMostValues - kSlotValues);
    const std::uint64_t buffers =
        std::min<std::uint64_t>(values * sizeof(std::uint16_t), device.maxAllocationBytes);
    const std::uint64_t all = availableBytes + heldBytes;
    const std::uint64_t memory = limits.isSecond ? all / 2 : all - all / 8;
    const std::uint64_t least = std::min({limits.voxelBytes, buffers, memory});
    return {.slotCount = least / kSlotBytes,
            .bound = least == memory    ? PoolBound::memory
                     : least == buffers ? PoolBound::buffers
                                        : PoolBound::setting};
}

std::optional<Message> coarseningMessage(const Coarsening& coarsening, std::uint64_t shownBlocks,
                                         const PoolRoom& room) {
    if (coarsening.coarse == 0) return std::nullopt;
    const std::uint64_t wanted = coarsening.slotsWanted * kSlotBytes;
    const std::uint64_t allowed = room.slotCount * kSlotBytes;
    const int edge = 1 << coarsening.coarsest;
    const double percent = 100.0 * double(coarsening.coarse) / double(shownBlocks);
    return Message{
        Severity::warning,
        "voxels-coarsened",
        {{"coarseBlocks", std::int64_t(coarsening.coarse)},
         {"shownBlocks", std::int64_t(shownBlocks)},
         {"wantedBytes", std::int64_t(wanted)},
         {"allowedBytes", std::int64_t(allowed)},
         {"voxelsPerEdge", std::int64_t(edge)}},
        Text("What is visible takes {:.1f} MiB and only {:.1f} MiB can be had: {} of {} "
             "visible blocks ({:.0f} %) are shown {}.",
             double(wanted) / kMiB, double(allowed) / kMiB, coarsening.coarse, shownBlocks, percent,
             edge > 2 ? Text("{} voxels as one along each edge or less", edge)
                      : Text("{} voxels as one along each edge", edge)),
        adviceFor(room.bound)};
}

}  // namespace macula::trace
