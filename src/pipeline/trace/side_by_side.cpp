#include "pipeline/trace/side_by_side.h"

#include <algorithm>

#include "shared/trace_params.h"

namespace macula::trace {

namespace {

constexpr std::uint32_t kThreadsOfBlock = shared::kBlockEdge * shared::kBlockEdge;

std::uint32_t dividedUp(std::uint32_t a, std::uint32_t b) {
    return a / b + (a % b != 0 ? 1 : 0);
}

}  // namespace

SideBySide::SideBySide(std::uint32_t threadsAtOnce) : blocksAtOnce_(threadsAtOnce / kThreadsOfBlock) {}

// Never more threads than the device holds: those that wait for their turn would be better off as the next
// sample of one that is there.
std::uint32_t SideBySide::mostThreads(std::uint32_t blocks) const {
    if (forced_ > 0) return forced_;
    return std::max(blocksAtOnce_ / std::max(blocks, 1u), 1u);
}

bool SideBySide::isFor(std::uint32_t blocks) const {
    return forced_ > 0 || mostThreads(blocks) > 1;
}

std::uint32_t SideBySide::threadsPerPixel(std::uint32_t blocks, std::uint32_t samples) const {
    if (samples == 0) return 1;
    const std::uint32_t row = dividedUp(samples, mostThreads(blocks));
    return dividedUp(samples, row);
}

std::uint32_t SideBySide::mostSamples(std::uint32_t blocks, std::uint32_t samplesPerThread) const {
    const std::uint64_t wanted = std::uint64_t(mostThreads(blocks)) * samplesPerThread;
    const std::uint64_t kept = kMostBlockSamples / std::max(blocks, 1u);
    return static_cast<std::uint32_t>(std::max<std::uint64_t>(std::min(wanted, kept), 1));
}

}  // namespace macula::trace
