#include "pipeline/trace/side_by_side.h"

#include <algorithm>

#include "shared/trace_params.h"

namespace macula::trace {

namespace {

constexpr std::uint32_t kThreadsOfBlock = shared::kBlockEdge * shared::kBlockEdge;

// How often a dispatch's threads fill the device: from so many times on, finished threads nearly always make
// room for others, and one thread for each pixel is as fast.
constexpr std::uint32_t kRounds = 4;
// For each pixel: far below the limit of a dispatch.
constexpr std::uint32_t kMostThreads = 256;

std::uint32_t dividedUp(std::uint32_t a, std::uint32_t b) {
    return a / b + (a % b != 0 ? 1 : 0);
}

}  // namespace

SideBySide::SideBySide(std::uint32_t threadsAtOnce) : blocksAtOnce_(threadsAtOnce / kThreadsOfBlock) {}

std::uint32_t SideBySide::mostThreads() const {
    return forced_ > 0 ? forced_ : kMostThreads;
}

bool SideBySide::isFor(std::uint32_t blocks) const {
    if (forced_ > 0) return true;
    return blocksAtOnce_ > 0 && blocks <= std::uint64_t(kRounds) * blocksAtOnce_;
}

std::uint32_t SideBySide::leastBlocks(bool isSideBySide, std::uint32_t samples) const {
    if (!isSideBySide) return blocksAtOnce_;
    const std::uint64_t inRounds = std::uint64_t(kRounds) * blocksAtOnce_ / threadsPerPixel(samples);
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(inRounds, blocksAtOnce_));
}

std::uint32_t SideBySide::threadsPerPixel(std::uint32_t samples) const {
    if (samples == 0) return 1;
    const std::uint32_t row = dividedUp(samples, mostThreads());
    return dividedUp(samples, row);
}

std::uint32_t SideBySide::threads(std::uint32_t blocks, std::uint32_t samples) const {
    const std::uint64_t wanted = std::uint64_t(kThreadsOfBlock) * blocks * threadsPerPixel(samples);
    const std::uint64_t atOnce = std::uint64_t(kThreadsOfBlock) * std::max(blocksAtOnce_, 1u);
    return static_cast<std::uint32_t>(forced_ > 0 ? wanted : std::min(wanted, atOnce));
}

std::uint32_t SideBySide::mostSamples(std::uint32_t blocks, std::uint32_t samplesPerThread) const {
    const std::uint64_t wanted = std::uint64_t(mostThreads()) * samplesPerThread;
    const std::uint64_t kept = kMostBlockSamples / std::max(blocks, 1u);
    return static_cast<std::uint32_t>(std::max<std::uint64_t>(std::min(wanted, kept), 1));
}

}  // namespace macula::trace
