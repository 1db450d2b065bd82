#include "pipeline/trace/voxel_memory.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/volume/coarsening.h"

namespace macula::trace {

namespace {

constexpr std::uint64_t kSlotBytes = kSlotValues * sizeof(std::uint16_t);
constexpr double kMiB = 1024.0 * 1024.0;

}  // namespace

std::uint64_t slotsAllowed(const MemoryLimits& limits, const gpu::DeviceInfo& device,
                           std::uint64_t availableBytes, std::uint64_t heldBytes) {
    constexpr std::uint64_t kMostValues = std::uint64_t{1} << 31;  // shaders index with 31 bits
    const std::uint64_t values =
        std::min<std::uint64_t>(device.maxTexelBufferElements, kMostValues - kSlotValues);
    const std::uint64_t available = availableBytes + heldBytes;
    return std::min({limits.voxelBytes, values * sizeof(std::uint16_t), device.maxAllocationBytes,
                     available - available / 8}) /
           kSlotBytes;
}

std::optional<Message> coarseningMessage(const Coarsening& coarsening, std::uint64_t shownBlocks,
                                         std::uint64_t slotsAllowed) {
    if (coarsening.coarse == 0) return std::nullopt;
    const std::uint64_t wanted = coarsening.slotsWanted * kSlotBytes;
    const std::uint64_t allowed = slotsAllowed * kSlotBytes;
    const int edge = 1 << coarsening.coarsest;
    const double percent = 100.0 * double(coarsening.coarse) / double(shownBlocks);
    return Message{Severity::warning,
                   "voxels-coarsened",
                   {{"coarseBlocks", std::int64_t(coarsening.coarse)},
                    {"shownBlocks", std::int64_t(shownBlocks)},
                    {"wantedBytes", std::int64_t(wanted)},
                    {"allowedBytes", std::int64_t(allowed)},
                    {"voxelsPerEdge", std::int64_t(edge)}},
                   fmt::format("What is visible takes {:.1f} MiB and only {:.1f} MiB can be had: {} of {} "
                               "visible blocks ({:.0f} %) "
                               "are shown {} voxels as one along each edge{}.",
                               double(wanted) / kMiB, double(allowed) / kMiB, coarsening.coarse, shownBlocks,
                               percent, edge, edge > 2 ? " or less" : ""),
                   "Show less of the volume by another preset or a clip, or use a device with more memory."};
}

}  // namespace macula::trace
