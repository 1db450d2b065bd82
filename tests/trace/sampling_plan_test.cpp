// Who gets samples, and how much is believed of the noise that decides it.
#include "pipeline/trace/sampling_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

namespace macula::trace {
namespace {

using shared::BlockNoise;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Gives the whole pass, and checks what holds of every pass: no block twice, none of nothing, no index again.
std::vector<std::uint32_t> givenBy(SamplingPlan& plan, double blockSamples = 1e9) {
    std::vector<std::uint32_t> given(plan.blockCount(), 0);
    const std::vector<std::uint32_t> before(plan.samples().begin(), plan.samples().end());
    while (plan.hasPass()) {
        const auto blocks = plan.next(blockSamples, 1, 1000000);
        EXPECT_FALSE(blocks.empty());
        for (const shared::PlannedBlock& block : blocks) {
            EXPECT_EQ(given.at(block.block), 0u);
            EXPECT_GT(block.sampleCount, 0u);
            EXPECT_EQ(block.firstSample, before.at(block.block));
            given.at(block.block) = block.sampleCount;
        }
    }
    for (std::size_t i = 0; i < given.size(); ++i) EXPECT_EQ(plan.samples()[i], before[i] + given[i]);
    return given;
}

std::uint64_t sumOf(const std::vector<std::uint32_t>& values) {
    return std::accumulate(values.begin(), values.end(), std::uint64_t(0));
}

// As the header says it, in double and without a thought of speed.
double weightAt(glm::ivec2 blocks, const std::vector<BlockNoise>& noises,
                const std::vector<std::uint32_t>& samples, int x, int y, bool* seen) {
    double sum = 0.0;
    int count = 0;
    *seen = false;
    for (int v = 0; v < blocks.y; ++v) {
        for (int u = 0; u < blocks.x; ++u) {
            if (std::abs(u - x) > 1 || std::abs(v - y) > 1) continue;
            const auto i = std::size_t(v * blocks.x + u);
            const double e2 = double(noises[i].squaredError);
            sum += (e2 >= 0.0 && e2 <= 1.0 ? e2 : 1.0) * samples[i];
            *seen = *seen || noises[i].isSeen != 0;
            ++count;
        }
    }
    return std::sqrt(sum / count);
}

TEST(SamplingPlan, WeightsAreWhatTheHeaderSays) {
    std::mt19937 random(1);
    for (const glm::ivec2 blocks : {glm::ivec2(9, 7), glm::ivec2(1, 5), glm::ivec2(6, 1), glm::ivec2(1, 1)}) {
        const auto count = std::size_t(blocks.x * blocks.y);
        std::vector<BlockNoise> noises(count);
        std::vector<std::uint32_t> samples(count);
        for (std::size_t i = 0; i < count; ++i) {
            const float size = std::uniform_real_distribution<float>(0.0f, 0.1f)(random);
            noises[i] = {.squaredError = i % 5 == 0 ? 0.0f : size * size, .isSeen = i % 3 == 0 ? 1u : 0u};
            samples[i] = 8 + unsigned(random() % 50);
        }
        noises[count / 2].squaredError = kNan;  // counts as 1
        const auto weights = samplingWeights(blocks, noises, samples);
        double mean = 0.0;
        int seenCount = 0;
        for (int pass = 0; pass < 2; ++pass) {
            for (int y = 0; y < blocks.y; ++y) {
                for (int x = 0; x < blocks.x; ++x) {
                    bool seen = false;
                    const double weight = weightAt(blocks, noises, samples, x, y, &seen);
                    if (pass == 0 && seen) {
                        mean += weight;
                        ++seenCount;
                    } else if (pass == 1) {
                        const double expected = std::clamp(weight, (seen ? 0.25 : 0.0625) * mean, 8.0 * mean);
                        EXPECT_NEAR(weights[std::size_t(y * blocks.x + x)], expected, 1e-5 * expected);
                    }
                }
            }
            if (pass == 0) mean /= seenCount;
        }
    }
}

TEST(SamplingPlan, EvenPassesGiveEachBlockTheSameInAnOrderThatIsSpread) {
    SamplingPlan plan(160, 120);  // 20 x 15 blocks
    plan.beginEven(3);
    const auto half = plan.next(3.0 * 150, 1, 1000);  // half of them
    ASSERT_EQ(half.size(), 150u);
    EXPECT_EQ(plan.leastSamples(), 0u);
    EXPECT_DOUBLE_EQ(plan.meanSamples(), 1.5);
    for (int y = 0; y < 15; y += 5) {
        for (int x = 0; x < 20; x += 5) {
            int here = 0;
            for (const auto& block : half) {
                const int u = int(block.block) % 20 - x;
                const int v = int(block.block) / 20 - y;
                here += u >= 0 && u < 5 && v >= 0 && v < 5 ? 1 : 0;
            }
            EXPECT_NEAR(here, 12.5, 3.0) << x << " " << y;
        }
    }
    EXPECT_EQ(plan.next(1e9, 1, 100).size(), 100u);  // as many as a dispatch may have
    EXPECT_EQ(plan.next(1e9, 1, 100).size(), 50u);
    EXPECT_FALSE(plan.hasPass());
    EXPECT_EQ(plan.leastSamples(), 3u);
    plan.beginEven(2);
    EXPECT_EQ(plan.next(0.0, 4, 100).size(), 4u);  // the least that keep a device busy
    EXPECT_EQ(plan.next(1.0, 1, 100).front().firstSample, 3u);
}

TEST(SamplingPlan, SamplesComeToBeInProportionToNoise) {
    constexpr int kEdge =
        24;  // blocks; noise grows from left to right, smoothly, so that pooling changes little
    const auto deviation = [](int x) { return 0.02f * (1.0f + 3.0f * float(x) / (kEdge - 1)); };
    SamplingPlan plan(8 * kEdge, 8 * kEdge);
    plan.beginEven(8);
    givenBy(plan);
    for (int pass = 0; pass < 40; ++pass) {
        std::vector<BlockNoise> noises(plan.blockCount());
        for (std::uint32_t i = 0; i < plan.blockCount(); ++i) {
            const float s = deviation(int(i) % kEdge);
            noises[i] = {.squaredError = s * s / float(plan.samples()[i]), .isSeen = 1};
        }
        const double asked = 0.5 * plan.meanSamples();
        plan.beginAdaptive(noises, asked, 16);
        const auto given = givenBy(plan, 100.0);
        EXPECT_LE(*std::max_element(given.begin(), given.end()), 16u);
        EXPECT_GE(double(sumOf(given)) / double(given.size()), 0.95 * std::min(asked, 4.0));
        EXPECT_LE(double(sumOf(given)) / double(given.size()), 2.0 * std::min(asked, 4.0));
    }
    const double perNoise = plan.meanSamples() / 0.05;  // 0.05: the mean deviation
    for (int x = 1; x + 1 < kEdge; ++x) {
        EXPECT_NEAR(plan.samples()[std::size_t(12 * kEdge + x)], perNoise * double(deviation(x)),
                    0.15 * plan.meanSamples())
            << x;
    }
}

// The block that is visited last had more than others before: when it alone is left, none has too few any
// more.
TEST(SamplingPlan, AllHaveTheirsOnlyWhenThePassIsOver) {
    SamplingPlan plan(80, 80);
    plan.beginEven(8);
    std::uint32_t last = 0;
    while (plan.hasPass()) last = plan.next(1.0, 1, 1).front().block;
    EXPECT_TRUE(plan.hasAll(8));
    EXPECT_FALSE(plan.hasAll(9));
    std::vector<BlockNoise> noises(plan.blockCount(), {.squaredError = 1e-6f, .isSeen = 1});
    noises[last].squaredError = 1e-2f;
    plan.beginAdaptive(noises, 0.5, 16);
    givenBy(plan);
    ASSERT_GT(plan.samples()[last], 8u);
    ASSERT_EQ(plan.leastSamples(), 8u);
    plan.beginEven(1);
    while (plan.hasPass()) {
        EXPECT_FALSE(plan.hasAll(9));
        plan.next(1.0, 1, 1);
    }
    EXPECT_TRUE(plan.hasAll(9));
}

// A lucky block among noisy ones, a noisy one among quiet ones, and one far from everything.
TEST(SamplingPlan, NobodyStarvesAndNobodyTakesAll) {
    SamplingPlan plan(8 * 32, 8 * 32);
    plan.beginEven(8);
    givenBy(plan);
    std::vector<BlockNoise> noises(plan.blockCount(), {.squaredError = 1e-4f, .isSeen = 1});
    const std::size_t lucky = 10 * 32 + 10;
    const std::size_t noisy = 20 * 32 + 20;
    noises[lucky].squaredError = 0.0f;
    noises[noisy].squaredError = 1.0f;
    for (std::size_t i = 0; i < 5 * 32; ++i) noises[i] = {};  // nothing is seen there
    for (int pass = 0; pass < 40; ++pass) {
        plan.beginAdaptive(noises, 0.5 * plan.meanSamples(), 16);
        givenBy(plan);
    }
    const double mean = plan.meanSamples();
    EXPECT_GT(plan.samples()[lucky], 0.5 * mean);
    EXPECT_GT(plan.samples()[noisy], 1.5 * mean);
    EXPECT_LT(plan.samples()[noisy], 20.0 * mean);
    EXPECT_GT(plan.leastSamples(), 0.02 * mean);
    EXPECT_LT(plan.samples()[0], 0.2 * mean);
}

TEST(SamplingPlan, TakesWhateverNoiseThereIs) {
    for (const float error : {0.0f, 1e-20f, 1.0f, 1e30f, -1.0f, kInfinity, kNan}) {
        for (const std::uint32_t seen : {0u, 1u}) {
            for (const int size : {1, 8, 9, 100}) {
                for (const std::uint32_t most : {1u, 16u}) {
                    SamplingPlan plan(size, 3);
                    plan.beginEven(8);
                    givenBy(plan);
                    std::vector<BlockNoise> noises(plan.blockCount(),
                                                   {.squaredError = error, .isSeen = seen});
                    noises.front().squaredError = 1e-6f;
                    plan.beginAdaptive(noises, 4.0, most);
                    ASSERT_TRUE(plan.hasPass());
                    EXPECT_GT(sumOf(givenBy(plan)), 0u);
                }
            }
        }
    }
    EXPECT_FALSE(SamplingPlan().hasPass());
    EXPECT_EQ(SamplingPlan().leastSamples(), 0u);
}

TEST(SamplingPlan, AnEstimateIsOfWhatIsSeen) {
    std::vector<BlockNoise> noises;
    EXPECT_EQ(estimateOf(noises).rms, 0.0);
    for (int i = 0; i < 100; ++i) noises.push_back({.squaredError = 1e-4f, .isSeen = 1});
    for (int i = 0; i < 1000; ++i) noises.push_back({});
    EXPECT_NEAR(estimateOf(noises).rms, 0.01, 1e-6);
    EXPECT_NEAR(estimateOf(noises).nearlyWorst, 0.01, 1e-6);
    EXPECT_TRUE(isConverged(estimateOf(noises), 0.0101));
    EXPECT_FALSE(isConverged(estimateOf(noises), 0.0099));
    EXPECT_FALSE(isConverged(estimateOf(noises), 0.0));
    for (int i = 0; i < 10; ++i)
        noises[std::size_t(i)].squaredError = 9e-4f;  // a tenth is three times as noisy
    EXPECT_NEAR(estimateOf(noises).rms, std::sqrt(1.8e-4), 1e-6);
    EXPECT_NEAR(estimateOf(noises).nearlyWorst, 0.03, 1e-6);
    EXPECT_FALSE(isConverged(estimateOf(noises), 0.0145));
    for (const float error : {kNan, kInfinity, -1.0f, 7.0f}) {
        noises[50].squaredError = error;
        EXPECT_NEAR(estimateOf(noises).rms, std::sqrt((89e-4 + 90e-4 + 1.0) / 100.0), 1e-5) << error;
    }
}

}  // namespace
}  // namespace macula::trace
