// The noise of a block as the shader works it out, against its definition.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "base/glsl_in_cpp.h"
#include "pipeline/trace/sampling_plan.h"

namespace macula::trace {
namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE
struct NoiseHost : GlslInCpp<double> {
    std::vector<vec4> sums_;
    std::vector<uint> counts_;
    std::vector<double> squares_;
    vec4 fetchSums(int pixel) const { return sums_[std::size_t(pixel)]; }
    uint fetchCount(int pixel) const { return counts_[std::size_t(pixel)]; }
    double fetchSquares(int pixel) const { return squares_[std::size_t(pixel)]; }
#define float double
#include "lib/noise.glsl"
#include "lib/picture.glsl"
#undef float

    explicit NoiseHost(std::size_t pixels)
        : sums_(pixels, vec4(0.0)), counts_(pixels, 0u), squares_(pixels, 0.0) {}
    void add(std::size_t pixel, double light, double coverage) {
        sums_[pixel] += vec4(light, light, light, coverage);
        squares_[pixel] += light * light;
        counts_[pixel] += 1;
    }
};
#undef OUT
#undef INOUT
#undef PRECISE

// Of light that is either there or not, `brightness` with `odds`: what is shown of many pictures of so many
// samples differs from what is shown of the truth by about what one picture of them says.
TEST(Noise, IsHowFarPicturesAreFromTheTruth) {
    for (const double brightness : {0.02, 0.3, 2.0}) {
        for (const double exposure : {0.5, 1.0}) {
            for (const unsigned samples : {8u, 64u}) {
                std::mt19937 random(7);
                constexpr double kOdds = 0.3;
                double estimated = 0.0;
                double truth = 0.0;
                constexpr int kPictures = 100;
                for (int picture = 0; picture < kPictures; ++picture) {
                    NoiseHost host(64);
                    for (std::size_t i = 0; i < 64; ++i) {
                        for (unsigned s = 0; s < samples; ++s)
                            host.add(i, std::bernoulli_distribution(kOdds)(random) ? brightness : 0.0, 1.0);
                        const double off = host.shownGrey(exposure * host.sums_[i].x / samples, false) -
                                           host.shownGrey(exposure * brightness * kOdds, false);
                        truth += off * off;
                    }
                    estimated += 64.0 * host.noiseOfBlock({0, 0}, {8, 8}, exposure, 0.18, false).x;
                }
                EXPECT_NEAR(std::sqrt(estimated / truth), 1.0, 0.15)
                    << brightness << " " << exposure << " " << samples;
            }
        }
    }
}

TEST(Noise, OfCoverageShowsOnABackdrop) {
    NoiseHost host(64);
    for (std::size_t i = 0; i < 64; ++i) {
        for (int s = 0; s < 16; ++s) host.add(i, 0.0, s % 2 == 0 ? 1.0 : 0.0);
    }
    EXPECT_EQ(host.noiseOfBlock({0, 0}, {8, 8}, 1.0, 0.0, false).x, 0.0);
    const double standardError = 0.18 * std::sqrt(0.25 / 15.0);
    const double shown = 0.5 * host.shownGrey(standardError, false);
    EXPECT_NEAR(host.noiseOfBlock({0, 0}, {8, 8}, 1.0, 0.18, false).x, shown * shown, 1e-9);
    EXPECT_EQ(host.noiseOfBlock({0, 0}, {8, 8}, 1.0, 0.18, false).y, 1.0);
}

// Samples decide where the next ones go, which must not lean on the mean: of blocks that happened to have few
// bright samples, fewer are taken. Pictures of soft light on the left, and on the right of light that comes
// in few samples, adapted as the tracer does it. That it draws the very samples that the plan says,
// Adaptive.EachPixelHasTheFirstOfItsSamples shows.
TEST(Noise, APlanThatFollowsItDoesNotLeanOnTheMean) {
    constexpr int kSide = 48;
    constexpr std::size_t kPixels = kSide * kSide;
    constexpr int kPictures = 1000;
    const auto oddsAt = [](std::size_t i) { return i % kSide < kSide / 2 ? 0.5 : 0.02; };
    constexpr double kLight = 0.2;  // everywhere, on average
    std::mt19937 random(11);
    const auto draw = [&](NoiseHost& host, std::size_t i, unsigned samples) {
        const double brightness = kLight / oddsAt(i);
        const int bright = std::binomial_distribution<int>(int(samples), oddsAt(i))(random);
        host.sums_[i] += NoiseHost::vec4(NoiseHost::vec3(bright * brightness), double(samples));
        host.squares_[i] += bright * brightness * brightness;
        host.counts_[i] += samples;
    };
    std::array<double, 2> sums{};  // of the halves
    std::array<double, 2> squares{};
    double samplesOfHalves[2] = {};
    for (int picture = 0; picture < kPictures; ++picture) {
        NoiseHost host(kPixels);
        SamplingPlan plan(kSide, kSide);
        plan.beginEven(kEvenSamples);
        while (true) {
            while (plan.hasPass()) {
                for (const shared::PlannedBlock& planned : plan.next(1e9, 1, 1000)) {
                    for (int p = 0; p < 64; ++p) {
                        const int x = int(planned.block) % plan.blocks().x * 8 + p % 8;
                        const int y = int(planned.block) / plan.blocks().x * 8 + p / 8;
                        draw(host, std::size_t(y * kSide + x), planned.sampleCount);
                    }
                }
            }
            if (plan.meanSamples() >= 16.0) break;
            std::vector<shared::BlockNoise> noises;
            for (int y = 0; y < plan.blocks().y; ++y) {
                for (int x = 0; x < plan.blocks().x; ++x) {
                    const NoiseHost::vec2 noise = host.noiseOfBlock({x, y}, {kSide, kSide}, 1.0, 0.18, false);
                    noises.push_back({.squaredError = float(noise.x), .isSeen = noise.y > 0.0 ? 1u : 0u});
                }
            }
            plan.beginAdaptive(noises, 0.5 * plan.meanSamples(), 16);
        }
        std::array<double, 2> halves{};
        for (std::size_t i = 0; i < kPixels; ++i) {
            halves[i % kSide < kSide / 2 ? 0 : 1] += host.sums_[i].x / host.counts_[i] / (0.5 * kPixels);
            samplesOfHalves[i % kSide < kSide / 2 ? 0 : 1] += host.counts_[i] / (0.5 * kPixels) / kPictures;
        }
        for (std::size_t half = 0; half < 2; ++half) {
            sums[half] += halves[half] / kPictures;
            squares[half] += halves[half] * halves[half] / kPictures;
        }
    }
    EXPECT_GT(samplesOfHalves[1], 1.2 * samplesOfHalves[0]);  // it adapts
    for (std::size_t half = 0; half < 2; ++half) {
        const double error = std::sqrt((squares[half] - sums[half] * sums[half]) / (kPictures - 1));
        EXPECT_NEAR(sums[half], kLight, 4.5 * error) << half;
        EXPECT_LT(4.5 * error, 0.01 * kLight) << half;
    }
}

// Nothing there, one pixel in the corner block, nothing sampled, and what is no number.
TEST(Noise, AtTheExtremes) {
    NoiseHost empty(9 * 9);
    for (auto& count : empty.counts_) count = 16;
    EXPECT_EQ(empty.noiseOfBlock({0, 0}, {9, 9}, 1.0, 0.18, false), NoiseHost::vec2(0.0));
    EXPECT_EQ(empty.noiseOfBlock({1, 1}, {9, 9}, 1.0, 0.18, false), NoiseHost::vec2(0.0));
    empty.sums_[80] = NoiseHost::vec4(16.0);  // one steady pixel, in the block of the corner only
    empty.squares_[80] = 16.0;
    EXPECT_EQ(empty.noiseOfBlock({1, 1}, {9, 9}, 1.0, 0.0, false), NoiseHost::vec2(0.0, 1.0));
    EXPECT_EQ(empty.noiseOfBlock({0, 1}, {9, 9}, 1.0, 0.0, false), NoiseHost::vec2(0.0));
    for (const unsigned count : {0u, 1u}) {
        NoiseHost unknown(1);
        unknown.counts_[0] = count;
        EXPECT_EQ(unknown.noiseOfBlock({0, 0}, {1, 1}, 1.0, 0.18, false).x, 1.0);
    }
    for (const double value : {std::nan(""), double(INFINITY), 3e38, 1e18}) {
        NoiseHost wild(64);
        for (std::size_t i = 0; i < 64; ++i) wild.counts_[i] = 4;
        wild.sums_[3] = NoiseHost::vec4(value, value, value, 1.0);
        wild.squares_[3] = value * value;
        for (const double exposure : {1e-6, 1.0, 1e6}) {
            const NoiseHost::vec2 noise = wild.noiseOfBlock({0, 0}, {8, 8}, exposure, 0.18, false);
            EXPECT_GT(noise.x, 0.0);
            EXPECT_LE(noise.x, 1.0);
            EXPECT_EQ(noise.y, 1.0);
        }
    }
}

}  // namespace
}  // namespace macula::trace
