// Whether slices alternate: noise, anatomy, steps and single odd slices do not.
#include "dicom/pixels/alternation.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <vector>

namespace macula::dicom {
namespace {

constexpr std::size_t kPixels = 4000;

using ValueAt = std::function<double(std::size_t slice, std::size_t pixel)>;

bool doAlternate(std::size_t count, double noise, const ValueAt& valueAt) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal(0.0, noise);
    std::vector<std::vector<float>> values(count, std::vector<float>(kPixels));
    std::vector<std::span<const float>> slices;
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t p = 0; p < kPixels; ++p)
            values[k][p] = static_cast<float>(valueAt(k, p) + (noise > 0.0 ? normal(random) : 0.0));
        slices.emplace_back(values[k]);
    }
    return alternates(std::span<const std::span<const float>>(slices));
}

TEST(Alternation, IsSeenInAllPixelsAndInFew) {
    const ValueAt all = [](std::size_t k, std::size_t) { return k % 2 ? 100.0 : 0.0; };
    EXPECT_TRUE(doAlternate(8, 0.0, all));
    EXPECT_TRUE(doAlternate(12, 30.0, all));
    // Contrast in vessels of one of two acquisitions, in noise.
    EXPECT_TRUE(doAlternate(60, 30.0,
                            [](std::size_t k, std::size_t p) { return k % 2 && p % 50 == 0 ? 150.0 : 0.0; }));
}

TEST(Alternation, IsNothingElse) {
    const ValueAt none = [](std::size_t, std::size_t) { return 0.0; };
    for (const std::size_t count : {8u, 9u, 40u, 200u}) {
        SCOPED_TRACE(count);
        EXPECT_FALSE(doAlternate(count, 0.0, none));
        EXPECT_FALSE(doAlternate(count, 30.0, none));
        // Edges of organs, each at a slice of its own.
        EXPECT_FALSE(doAlternate(count, 0.0,
                                 [&](std::size_t k, std::size_t p) { return k > p % count ? 1000.0 : 0.0; }));
        EXPECT_FALSE(
            doAlternate(count, 1.0, [](std::size_t k, std::size_t) { return k == 5 ? 3000.0 : 0.0; }));
        EXPECT_FALSE(doAlternate(count, 1.0, [](std::size_t k, std::size_t) { return k > 4 ? 500.0 : 0.0; }));
        // Pairs of slices that are alike.
        EXPECT_FALSE(
            doAlternate(count, 1.0, [](std::size_t k, std::size_t) { return k / 2 % 2 ? 500.0 : 0.0; }));
    }
}

// Noise of every other slice alone: of a sharp kernel among soft ones.
TEST(Alternation, OfNoiseIsSeenToo) {
    const auto doesNoise = [](std::size_t count, const std::function<double(std::size_t)>& noiseOf) {
        std::mt19937 random(7);
        std::normal_distribution<double> normal(0.0, 1.0);
        std::vector<std::vector<float>> values(count, std::vector<float>(kPixels));
        std::vector<std::span<const float>> slices;
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t p = 0; p < kPixels; ++p)
                values[k][p] = static_cast<float>((p % 97 < 40 ? 300.0 : 0.0) + noiseOf(k) * normal(random));
            slices.emplace_back(values[k]);
        }
        EXPECT_FALSE(alternates(slices));
        return noiseAlternates(slices);
    };
    for (const std::size_t count : {8u, 9u, 48u}) {
        SCOPED_TRACE(count);
        EXPECT_TRUE(doesNoise(count, [](std::size_t k) { return k % 2 ? 30.0 : 12.0; }));
        EXPECT_TRUE(doesNoise(count, [](std::size_t k) { return k % 2 ? 12.0 : 18.0; }));
        EXPECT_FALSE(doesNoise(count, [](std::size_t) { return 12.0; }));
        EXPECT_FALSE(doesNoise(count, [](std::size_t) { return 0.0; }));
        // More towards the shoulders, another kernel from the middle on, one noisy slice, a helix.
        EXPECT_FALSE(doesNoise(count, [](std::size_t k) { return 10.0 + double(k); }));
        EXPECT_FALSE(doesNoise(count, [&](std::size_t k) { return k < count / 2 ? 12.0 : 30.0; }));
        EXPECT_FALSE(doesNoise(count, [](std::size_t k) { return k == 4 ? 60.0 : 12.0; }));
        EXPECT_FALSE(doesNoise(count, [](std::size_t k) { return k % 2 ? 12.0 : 13.0; }));
    }
    EXPECT_FALSE(doesNoise(7, [](std::size_t k) { return k % 2 ? 30.0 : 12.0; }));
}

TEST(Alternation, NeedsEightSlices) {
    EXPECT_FALSE(doAlternate(7, 0.0, [](std::size_t k, std::size_t) { return k % 2 ? 100.0 : 0.0; }));
}

}  // namespace
}  // namespace macula::dicom
