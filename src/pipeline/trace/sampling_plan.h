// How many samples each block of a picture gets next: all the same number, or more the noisier it is.
//
// Samples improve a picture most where its noise is greatest. With a standard deviation s of one sample, n
// samples and a fixed sum of n, the mean square of s / sqrt(n) over the picture is least when n is
// proportional to s. But s is estimated from the very samples that it then distributes, so three rules guard
// against an estimate that is too small by chance: it is pooled over a block and the eight around; sampling
// adapts only when all blocks have kEvenSamples; and every block keeps getting a share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shared/trace_params.h"

namespace macula::trace {

// The samples that every pixel has before sampling adapts, and before a picture may count as converged.
inline constexpr std::uint32_t kEvenSamples = 8;

// The standard error of the picture as displayed, display-encoded, black 0 to white 1, over the blocks that
// show something; 0 when none does.
struct ErrorEstimate {
    double rms = 0.0;
    double nearlyWorst = 0.0;  // the 95th percentile of the blocks
};
// A noise that is NaN or above 1 counts as 1, the error of black shown as white.
ErrorEstimate estimateOf(std::span<const shared::BlockNoise> noises);
// Whether the picture is as good as the threshold asks, and no part of it twice as noisy. A threshold of 0 is
// never reached.
bool isConverged(const ErrorEstimate& estimate, double threshold);

// The standard deviation of one sample in each block, on a common arbitrary scale; above 0 for every block.
// Pooled over neighbours, and clamped between a fraction of their mean, so that no block starves, and a
// multiple of it.
std::vector<float> samplingWeights(glm::ivec2 blocks, std::span<const shared::BlockNoise> noises,
                                   std::span<const std::uint32_t> samples);

// Blocks are numbered row by row. Every pass visits its blocks in an order that spreads any few of them
// evenly over the picture, so that half a pass is even too. Gives out each sample index of a block only once.
class SamplingPlan {
  public:
    SamplingPlan() = default;
    SamplingPlan(int width, int height);  // pixels; no samples yet

    glm::ivec2 blocks() const { return blocks_; }
    std::uint32_t blockCount() const { return static_cast<std::uint32_t>(samples_.size()); }
    std::span<const std::uint32_t> samples() const { return samples_; }  // by block
    std::uint32_t leastSamples() const;
    // Whether every block has at least `samples`, and no pass is under way. Both, because the blocks with the
    // fewest samples may be done before the rest of their pass.
    bool hasAll(std::uint32_t samples) const;
    double meanSamples() const;  // of a pixel

    bool hasPass() const { return position_ < blockCount() && passMost_ > 0; }
    bool isAdaptive() const { return !counts_.empty(); }  // the pass under way, or the last one
    std::uint32_t passMost() const { return passMost_; }  // the most samples of a block in the last pass

    // Begins a pass; drops one under way, whose samples so far stay.
    void beginEven(std::uint32_t samples);
    // Likewise. Plans about `mean` samples for each block on average; fewer where a limit of `most` samples
    // for a block would leave no room to adapt.
    void beginAdaptive(std::span<const shared::BlockNoise> noises, double mean, std::uint32_t most);
    void dropPass() { position_ = blockCount(); }

    // The next blocks of the pass, each once: as few as have `blockSamples` samples together, but at least
    // `leastBlocks` and at most `mostBlocks`. They count as done. The last call of a pass gives what is left.
    std::vector<shared::PlannedBlock> next(double blockSamples, std::uint32_t leastBlocks,
                                           std::uint32_t mostBlocks);

  private:
    glm::ivec2 size_{0};  // pixels
    glm::ivec2 blocks_{0};
    std::uint32_t stride_ = 1;
    std::vector<std::uint32_t> samples_;
    std::vector<std::uint16_t> counts_;  // samples in the pass, by block; empty: passMost_ for each
    std::uint32_t passMost_ = 0;
    std::uint32_t position_ = 0;  // in the order of the pass: blocks before it are done
};

}  // namespace macula::trace
