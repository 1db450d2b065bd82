#include "scene/transfer/histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace macula::scene {
namespace {

Volume noise() {
    std::mt19937 random(7);
    std::vector<std::uint16_t> voxels(17 * 13 * 11);
    for (std::uint16_t& voxel : voxels) voxel = std::uint16_t(random() % 900);
    return *Volume::create({.size = {17, 13, 11},
                            .unitsFromStored = {.slope = 2.5, .intercept = -1000.0},
                            .unit = Unit::hounsfield,
                            .padding = StoredRange{0, 40}},
                           voxels);
}

// Column i of all rows has the value i.
Volume columns(int length) {
    std::vector<std::uint16_t> voxels(std::size_t(length) * std::size_t(length) * std::size_t(length));
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = std::uint16_t(i % std::size_t(length));
    return *Volume::create({.size = glm::ivec3(length)}, voxels);
}

std::uint64_t sumOf(const Histogram& histogram) {
    return std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t(0));
}

// Bins of which the value lies between the edges, found one by one.
std::vector<std::uint64_t> bruteForce(const Volume& volume, const Histogram& like) {
    std::vector<std::uint64_t> counts(like.counts.size(), 0);
    const glm::ivec3 size = volume.size();
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                if (volume.isPadding(i, j, k)) continue;
                const double value = volume.value(i, j, k);
                for (std::size_t bin = 0; bin < counts.size(); ++bin) {
                    if (like.edge(bin) <= value && value < like.edge(bin + 1)) ++counts[bin];
                }
            }
        }
    }
    return counts;
}

TEST(HistogramOf, IsThatOfBruteForce) {
    const Volume volume = noise();
    const std::optional<Bins> bins = binsOf(volume);
    ASSERT_TRUE(bins);
    EXPECT_EQ(bins->count, std::size_t(volume.storedRange().high - volume.storedRange().low + 1));
    const auto histogram = histogramOf(volume, *bins);
    ASSERT_TRUE(histogram);
    EXPECT_EQ(histogram->stride, 1u);
    EXPECT_EQ(histogram->counts, bruteForce(volume, *histogram));
    EXPECT_EQ(histogram->below + histogram->above, 0u);

    // 101.25 and 998.75 are no values, nor are edges between them: 2.5 times a whole number.
    const auto part = histogramOf(volume, {.range = {101.25, 998.75}, .count = 359});
    ASSERT_TRUE(part);
    EXPECT_EQ(part->counts, bruteForce(volume, *part));
    EXPECT_GT(part->below, 0u);
    EXPECT_GT(part->above, 0u);
    EXPECT_EQ(part->below + sumOf(*part) + part->above, sumOf(*histogram));
}

TEST(HistogramOf, LeavesOutWhatIsNoNumber) {
    std::vector<float> voxels(60, 1.5F);
    std::fill_n(voxels.begin(), 10, std::numeric_limits<float>::quiet_NaN());
    std::fill_n(voxels.begin() + 10, 5, -3024.0F);
    std::fill_n(voxels.begin() + 15, 5, std::numeric_limits<float>::infinity());
    voxels.back() = 4.5F;
    const Volume volume = *Volume::createFloat({.size = {5, 4, 3}, .floatPadding = -3024.0F}, voxels);
    const auto histogram = histogramOf(volume, *binsOf(volume));
    ASSERT_TRUE(histogram);
    EXPECT_EQ(sumOf(*histogram), 40u);
    EXPECT_EQ(histogram->counts.front(), 39u);
    EXPECT_EQ(histogram->counts.back(), 1u);
}

TEST(HistogramOf, OfOneValueOrOfNone) {
    const Volume one = *Volume::create({.size = glm::ivec3(3)}, std::vector<std::uint16_t>(27, 9));
    const auto histogram = histogramOf(one, *binsOf(one));
    ASSERT_TRUE(histogram);
    EXPECT_EQ(histogram->counts, std::vector<std::uint64_t>{27});
    const Volume same = *Volume::createFloat({.size = glm::ivec3(3)}, std::vector<float>(27, 9e30F));
    EXPECT_EQ(histogramOf(same, *binsOf(same))->counts, std::vector<std::uint64_t>{27});
    const Volume none = *Volume::create({.size = glm::ivec3(3), .padding = StoredRange{9, 9}},
                                        std::vector<std::uint16_t>(27, 9));
    EXPECT_FALSE(binsOf(none));
}

TEST(HistogramOf, HasTheSameNumberOfStoredValuesInEachBin) {
    std::vector<std::uint16_t> voxels(40 * 41 * 40);
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = std::uint16_t(i);
    const Volume volume = *Volume::create({.size = {40, 41, 40}}, voxels);
    const std::optional<Bins> bins = binsOf(volume);
    ASSERT_TRUE(bins);
    EXPECT_LE(bins->count, 16384u);
    const auto histogram = histogramOf(volume, *bins);
    const auto [least, most] = std::minmax_element(histogram->counts.begin(), histogram->counts.end());
    EXPECT_LE(*most - *least, *most / 2 + 2);  // what is wrapped around is twice there
    EXPECT_EQ(sumOf(*histogram), voxels.size());
}

// With a stride of 16, which comes first, only every 16th column would be seen.
TEST(HistogramOf, PrefersNoColumnWhereItTakesAFew) {
    const Volume volume = columns(64);
    const auto histogram = histogramOf(volume, *binsOf(volume), {}, 64 * 64 * 64 / 16);
    ASSERT_TRUE(histogram);
    EXPECT_GT(histogram->stride, 16u);
    ASSERT_EQ(histogram->counts.size(), 64u);
    const auto [least, most] = std::minmax_element(histogram->counts.begin(), histogram->counts.end());
    EXPECT_GT(*least, 200u);
    EXPECT_LE(*most - *least, 1u);
}

TEST(HistogramOf, EndsWhenCancelled) {
    const Volume volume = noise();
    const CancelToken token;
    token.cancel();
    const auto histogram = histogramOf(volume, *binsOf(volume), token);
    ASSERT_FALSE(histogram);
    EXPECT_EQ(histogram.error().code, ErrorCode::cancelled);
}

TEST(Percentile, IsAnEdge) {
    const Histogram histogram{.bins = {.range = {0.0, 30.0}, .count = 3}, .counts = {10, 80, 10}};
    EXPECT_EQ(percentile(histogram, 0.0), 0.0);
    EXPECT_EQ(percentile(histogram, 0.05), 10.0);
    EXPECT_EQ(percentile(histogram, 0.5), 20.0);
    EXPECT_EQ(percentile(histogram, 1.0), 30.0);
    EXPECT_EQ(percentile({.bins = {.range = {0.0, 30.0}, .count = 3}, .counts = {0, 0, 0}}, 0.5), 0.0);
}

TEST(LogHeights, AreLogarithmsOfTheHighestBinOfAColumn) {
    const Histogram histogram{.bins = {.range = {-2.0, 2.0}, .count = 4}, .counts = {0, 1, 3, 7}};
    const auto expect = [&](const ValueRange& shown, const std::vector<double>& wanted) {
        const std::vector<double> heights = logHeights(histogram, shown, wanted.size());
        ASSERT_EQ(heights.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(heights[i], wanted[i], 1e-12) << i;
    };
    expect({-2.0, 2.0}, {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0});
    expect({-2.0, 2.0}, {1.0 / 3.0, 1.0});
    expect({-4.0, 4.0}, {0.0, 1.0 / 3.0, 1.0, 0.0});
    expect({-100.0, -50.0}, {0.0, 0.0});
    expect({50.0, 100.0}, {0.0, 0.0});
    expect({0.5, 0.5 + 1e-12}, {2.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0});
    expect({2.0, -2.0}, {0.0, 0.0});
    EXPECT_EQ(logHeights({.bins = histogram.bins, .counts = {0, 0, 0, 0}}, {-2.0, 2.0}, 2),
              std::vector<double>(2, 0.0));
}

}  // namespace
}  // namespace macula::scene
