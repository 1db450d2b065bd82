// The noise of a block as the shader works it out, against its definition.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/glsl_in_cpp.h"

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
                        const double off = host.shownGrey(exposure * host.sums_[i].x / samples) -
                                           host.shownGrey(exposure * brightness * kOdds);
                        truth += off * off;
                    }
                    estimated += 64.0 * host.noiseOfBlock({0, 0}, {8, 8}, exposure, 0.18).x;
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
    EXPECT_EQ(host.noiseOfBlock({0, 0}, {8, 8}, 1.0, 0.0).x, 0.0);
    const double standardError = 0.18 * std::sqrt(0.25 / 15.0);
    const double shown = 0.5 * host.shownGrey(standardError);
    EXPECT_NEAR(host.noiseOfBlock({0, 0}, {8, 8}, 1.0, 0.18).x, shown * shown, 1e-9);
    EXPECT_EQ(host.noiseOfBlock({0, 0}, {8, 8}, 1.0, 0.18).y, 1.0);
}

// Nothing there, one pixel in the corner block, nothing sampled, and what is no number.
TEST(Noise, AtTheExtremes) {
    NoiseHost empty(9 * 9);
    for (auto& count : empty.counts_) count = 16;
    EXPECT_EQ(empty.noiseOfBlock({0, 0}, {9, 9}, 1.0, 0.18), NoiseHost::vec2(0.0));
    EXPECT_EQ(empty.noiseOfBlock({1, 1}, {9, 9}, 1.0, 0.18), NoiseHost::vec2(0.0));
    empty.sums_[80] = NoiseHost::vec4(16.0);  // one steady pixel, in the block of the corner only
    empty.squares_[80] = 16.0;
    EXPECT_EQ(empty.noiseOfBlock({1, 1}, {9, 9}, 1.0, 0.0), NoiseHost::vec2(0.0, 1.0));
    EXPECT_EQ(empty.noiseOfBlock({0, 1}, {9, 9}, 1.0, 0.0), NoiseHost::vec2(0.0));
    for (const unsigned count : {0u, 1u}) {
        NoiseHost unknown(1);
        unknown.counts_[0] = count;
        EXPECT_EQ(unknown.noiseOfBlock({0, 0}, {1, 1}, 1.0, 0.18).x, 1.0);
    }
    for (const double value : {std::nan(""), double(INFINITY), 3e38, 1e18}) {
        NoiseHost wild(64);
        for (std::size_t i = 0; i < 64; ++i) wild.counts_[i] = 4;
        wild.sums_[3] = NoiseHost::vec4(value, value, value, 1.0);
        wild.squares_[3] = value * value;
        for (const double exposure : {1e-6, 1.0, 1e6}) {
            const NoiseHost::vec2 noise = wild.noiseOfBlock({0, 0}, {8, 8}, exposure, 0.18);
            EXPECT_GT(noise.x, 0.0);
            EXPECT_LE(noise.x, 1.0);
            EXPECT_EQ(noise.y, 1.0);
        }
    }
}

}  // namespace
}  // namespace macula::trace
