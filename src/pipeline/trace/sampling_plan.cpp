#include "pipeline/trace/sampling_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/check.h"

namespace macula::trace {

namespace {

constexpr int kBlock = shared::kBlockEdge;

// Fractions of the mean weight of the blocks that show something. A block always gets samples if it or a
// neighbour shows something; others get a few now and then.
constexpr double kLeastWeight = 0.25;
constexpr double kLeastWeightUnseen = 1.0 / 16.0;
constexpr double kMostWeight = 8.0;

// kRoom: the average samples of a block in an adaptive pass, as a fraction of the most that a block may get.
// kWorthIt: a block is not visited for fewer samples than this fraction of the mean over the picture.
constexpr double kRoom = 0.25;
constexpr double kWorthIt = 0.25;

constexpr double kNearlyWorst = 0.95;
// The 95th percentile of a converged picture is at most so many times the threshold.
constexpr double kNearlyWorstFactor = 2.0;

// A step through `blocks` that visits each once and spreads any few of them evenly: near the golden section
// and coprime.
std::uint32_t spreadingStride(std::uint32_t blocks) {
    constexpr double kGolden = 0.6180339887;
    auto stride = std::max(static_cast<std::uint32_t>(kGolden * blocks), 1u);
    while (std::gcd(stride, blocks) != 1) ++stride;
    return stride;
}

std::size_t indexOf(glm::ivec2 blocks, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(blocks.x) + static_cast<std::size_t>(x);
}

double known(float squaredError) {
    return squaredError >= 0.0f && squaredError <= 1.0f ? static_cast<double>(squaredError) : 1.0;
}

// The samples that a block gets now if it is `owed` so many: whole nets, if there is room for one. A few are
// not worth a visit: lanes of a SIMD group wait for its longest path, which many samples even out.
double visit(double owed, double worthIt, double most) {
    const double grain = most < shared::kNetSamples ? 1.0 : shared::kNetSamples;
    return owed < worthIt ? 0.0 : std::floor(std::min(owed, most) / grain) * grain;
}

}  // namespace

ErrorEstimate estimateOf(std::span<const shared::BlockNoise> noises) {
    std::vector<double> squares;
    for (const shared::BlockNoise& noise : noises) {
        if (noise.isSeen != 0) squares.push_back(known(noise.squaredError));
    }
    if (squares.empty()) return {};
    const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
    const auto at = squares.begin() + static_cast<std::ptrdiff_t>(kNearlyWorst * double(squares.size() - 1));
    std::nth_element(squares.begin(), at, squares.end());
    return {.rms = std::sqrt(sum / double(squares.size())), .nearlyWorst = std::sqrt(*at)};
}

bool isConverged(const ErrorEstimate& estimate, double threshold) {
    return threshold > 0.0 && estimate.rms <= threshold &&
           estimate.nearlyWorst <= kNearlyWorstFactor * threshold;
}

std::vector<float> samplingWeights(glm::ivec2 blocks, std::span<const shared::BlockNoise> noises,
                                   std::span<const std::uint32_t> samples) {
    const auto count = static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y);
    MACULA_CHECK_EQ(noises.size(), count);
    MACULA_CHECK_EQ(samples.size(), count);
    std::vector<float> weights(count, 1.0f);
    std::vector<bool> seen(count, false);
    double sum = 0.0;
    std::size_t seenCount = 0;
    for (int y = 0; y < blocks.y; ++y) {
        for (int x = 0; x < blocks.x; ++x) {
            const auto here = indexOf(blocks, x, y);
            double variance = 0.0;  // of one sample
            int neighbours = 0;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, blocks.y - 1); ++v) {
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, blocks.x - 1); ++u) {
                    const auto at = indexOf(blocks, u, v);
                    variance += known(noises[at].squaredError) * samples[at];
                    seen[here] = seen[here] || noises[at].isSeen != 0;
                    ++neighbours;
                }
            }
            weights[here] = static_cast<float>(std::sqrt(variance / neighbours));
            if (!seen[here]) continue;
            sum += weights[here];
            ++seenCount;
        }
    }
    if (!(sum > 0.0)) {
        std::fill(weights.begin(), weights.end(), 1.0f);
        return weights;
    }
    const double mean = sum / double(seenCount);
    for (std::size_t i = 0; i < count; ++i) {
        const double least = seen[i] ? kLeastWeight : kLeastWeightUnseen;
        weights[i] = static_cast<float>(std::clamp(double(weights[i]), least * mean, kMostWeight * mean));
    }
    return weights;
}

SamplingPlan::SamplingPlan(int width, int height)
    : size_(width, height),
      blocks_((width + kBlock - 1) / kBlock, (height + kBlock - 1) / kBlock),
      stride_(spreadingStride(static_cast<std::uint32_t>(blocks_.x * blocks_.y))),
      samples_(static_cast<std::size_t>(blocks_.x) * static_cast<std::size_t>(blocks_.y), 0u) {}

std::uint32_t SamplingPlan::leastSamples() const {
    return samples_.empty() ? 0 : *std::min_element(samples_.begin(), samples_.end());
}

bool SamplingPlan::hasAll(std::uint32_t samples) const {
    return !hasPass() && leastSamples() >= samples;
}

double SamplingPlan::meanSamples() const {
    double sum = 0.0;
    for (int y = 0; y < blocks_.y; ++y) {
        const int rows = std::min(kBlock, size_.y - kBlock * y);
        for (int x = 0; x < blocks_.x; ++x) {
            const int columns = std::min(kBlock, size_.x - kBlock * x);
            sum += double(samples_[indexOf(blocks_, x, y)]) * rows * columns;
        }
    }
    return samples_.empty() ? 0.0 : sum / (double(size_.x) * size_.y);
}

void SamplingPlan::beginEven(std::uint32_t samples) {
    counts_.clear();
    passMost_ = samples;
    position_ = 0;
}

void SamplingPlan::beginAdaptive(std::span<const shared::BlockNoise> noises, double mean,
                                 std::uint32_t most) {
    constexpr std::uint32_t kMost = std::numeric_limits<std::uint16_t>::max();
    const std::vector<float> weights = samplingWeights(blocks_, noises, samples_);
    const double limit = std::clamp(most, 1u, kMost);
    // In a larger pass so many blocks would reach their limit that sampling would be nearly even.
    const double wanted = std::min(mean, kRoom * limit) * blockCount();
    const double worthIt = std::clamp(kWorthIt * meanSamples(), 1.0, std::max(0.5 * limit, 1.0));
    // Each block should end at level * weight samples. Finds the level at which the pass has the wanted size.
    const auto sizeAt = [&](double level) {
        double sum = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i)
            sum += visit(level * double(weights[i]) - samples_[i], worthIt, limit);
        return sum;
    };
    double low = 0.0;
    double high = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < weights.size(); ++i)  // the level at which the first block reaches its limit
        high = std::min(high, (samples_[i] + limit) / double(weights[i]));
    while (sizeAt(high) < wanted) {
        low = high;
        high *= 2.0;
    }
    for (int i = 0; i < 24; ++i) {
        const double middle = 0.5 * (low + high);
        (sizeAt(middle) < wanted ? low : high) = middle;
    }
    counts_.resize(samples_.size());
    for (std::size_t i = 0; i < weights.size(); ++i)
        counts_[i] =
            static_cast<std::uint16_t>(visit(high * double(weights[i]) - samples_[i], worthIt, limit));
    passMost_ = *std::max_element(counts_.begin(), counts_.end());
    position_ = 0;
}

std::vector<shared::PlannedBlock> SamplingPlan::next(double blockSamples, std::uint32_t leastBlocks,
                                                     std::uint32_t mostBlocks) {
    std::vector<shared::PlannedBlock> planned;
    double sum = 0.0;
    for (; hasPass() && planned.size() < mostBlocks; ++position_) {
        if (sum >= blockSamples && planned.size() >= leastBlocks) break;
        const auto block = static_cast<std::uint32_t>(std::uint64_t(position_) * stride_ % blockCount());
        const std::uint32_t count = counts_.empty() ? passMost_ : counts_[block];
        if (count == 0) continue;
        planned.push_back({.block = block, .firstSample = samples_[block], .sampleCount = count});
        samples_[block] += count;
        sum += count;
    }
    // If the remaining blocks get no samples, the pass is over.
    while (hasPass() && !counts_.empty() && counts_[std::uint64_t(position_) * stride_ % blockCount()] == 0) {
        ++position_;
    }
    return planned;
}

}  // namespace macula::trace
