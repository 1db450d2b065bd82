// Which blocks of a picture get how many samples next: all the same, or by how noisy they are.
//
// What is shown is best improved where its noise is greatest. With a standard deviation s of one sample, n
// samples and a fixed sum of n, the mean square of s / sqrt(n) over the picture is least when n is in
// proportion to s. Three things keep that honest, because s is itself measured with the samples it decides
// about: it is pooled over a block and the eight around, so that a lucky block is not forgotten; nothing is
// planned before all have kEvenSamples; and every block goes on getting a share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shared/trace_params.h"

namespace macula::trace {

// The samples that every pixel has before sampling adapts, and before a picture may count as converged.
inline constexpr std::uint32_t kEvenSamples = 8;

// The standard error of what is shown, display-encoded, black 0 to white 1, over the blocks that show
// something. +infinity when nothing is known; 0 when nothing is seen.
struct ErrorEstimate {
    double rms = 0.0;
    double nearlyWorst = 0.0;  // 95 of 100 blocks have less
};
// A noise that is no number, or above 1, counts as 1: black taken for white.
ErrorEstimate estimateOf(std::span<const shared::BlockNoise> noises);
// Whether the picture is as good as the threshold asks, and no part of it twice as noisy. A threshold of 0 is
// never reached.
bool isConverged(const ErrorEstimate& estimate, double threshold);

// Standard deviations of one sample, by block, relative to each other; above 0 for every block. Pooled over
// neighbours, and kept between a share of their mean that lets no block starve and a multiple of it.
std::vector<float> samplingWeights(glm::ivec2 blocks, std::span<const shared::BlockNoise> noises,
                                   std::span<const std::uint32_t> samples);

// Blocks are numbered row by row. Every pass visits its blocks in an order that spreads any few of them
// evenly over the picture, so that half of one is even too. A sample index of a block is given out once.
class SamplingPlan {
  public:
    SamplingPlan() = default;
    SamplingPlan(int width, int height);  // pixels; no samples yet

    glm::ivec2 blocks() const { return blocks_; }
    std::uint32_t blockCount() const { return static_cast<std::uint32_t>(samples_.size()); }
    std::span<const std::uint32_t> samples() const { return samples_; }  // by block
    std::uint32_t leastSamples() const;
    // Whether every block has so many, and no pass is under way. Both, because in a pass after one that
    // adapted the blocks with the fewest may be done before the others.
    bool hasAll(std::uint32_t samples) const;
    double meanSamples() const;  // of a pixel

    bool hasPass() const { return position_ < blockCount() && passMost_ > 0; }
    bool isAdaptive() const { return !counts_.empty(); }  // the pass under way, or the last one
    std::uint32_t passMost() const { return passMost_; }  // samples of a block, of the last pass

    // A pass under way is dropped: what it has done stays.
    void beginEven(std::uint32_t samples);
    // About `mean` samples for each block, but not so many that `most` for one of them leaves no room to
    // adapt.
    void beginAdaptive(std::span<const shared::BlockNoise> noises, double mean, std::uint32_t most);
    void dropPass() { position_ = blockCount(); }

    // The next blocks of the pass, each once: as few as have `blockSamples` samples together, but within
    // these numbers of blocks. They count as done. The last call of a pass gives what is left.
    std::vector<shared::PlannedBlock> next(double blockSamples, std::uint32_t leastBlocks,
                                           std::uint32_t mostBlocks);

  private:
    glm::ivec2 size_{0};  // pixels
    glm::ivec2 blocks_{0};
    std::uint32_t stride_ = 1;
    std::vector<std::uint32_t> samples_;
    std::vector<std::uint16_t> counts_;  // of the pass, by block; empty: passMost_ for each
    std::uint32_t passMost_ = 0;
    std::uint32_t position_ = 0;  // blocks of the pass that are done, in its order
};

}  // namespace macula::trace
