#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "shader/shader_lib.h"
#include "shader/statistics.h"

namespace macula {
namespace {

using Lib = ShaderLibTwofold;

TEST(Rng, OneStreamIsUniform) {
    Lib lib;
    auto rng = lib.makeRng(3, 4, 5, 6);
    std::vector<double> cells(256, 0.0);
    constexpr int kDraws = 1 << 20;
    for (int i = 0; i < kDraws; ++i) ++cells[std::size_t(lib.random01(rng) * 256)];
    const std::vector<double> expected(256, kDraws / 256.0);
    EXPECT_LT(std::abs(statistics::chiSquareDeviate(cells, expected)), statistics::kDeviateLimit);
}

// What a picture needs most: the first numbers of neighbouring pixels, samples and seeds are independent.
TEST(Rng, NeighbouringStreamsAreJointlyUniform) {
    Lib lib;
    constexpr int kSide = 16;
    constexpr int kPixels = 512;
    for (const auto& [dx, dSample, dSeed] : {std::tuple{1u, 0u, 0u}, {0u, 1u, 0u}, {0u, 0u, 1u}}) {
        std::vector<double> cells(kSide * kSide, 0.0);
        for (unsigned y = 0; y < kPixels; ++y) {
            for (unsigned x = 0; x < kPixels; ++x) {
                auto a = lib.makeRng(x, y, 7, 1);
                auto b = lib.makeRng(x + dx, y, 7 + dSample, 1 + dSeed);
                const auto i = std::size_t(lib.random01(a) * kSide);
                const auto j = std::size_t(lib.random01(b) * kSide);
                ++cells[i * kSide + j];
            }
        }
        const std::vector<double> expected(cells.size(), double(kPixels) * kPixels / double(cells.size()));
        EXPECT_LT(std::abs(statistics::chiSquareDeviate(cells, expected)), statistics::kDeviateLimit)
            << dx << dSample << dSeed;
    }
}

TEST(Rng, ConsecutiveDrawsAreJointlyUniform) {
    Lib lib;
    constexpr int kSide = 32;
    constexpr int kDraws = 1 << 20;
    std::vector<double> cells(kSide * kSide, 0.0);
    auto rng = lib.makeRng(100, 200, 300, 400);
    double last = lib.random01(rng);
    for (int i = 0; i < kDraws; ++i) {
        const double next = lib.random01(rng);
        ++cells[std::size_t(last * kSide) * kSide + std::size_t(next * kSide)];
        last = next;
    }
    const std::vector<double> expected(cells.size(), double(kDraws) / double(cells.size()));
    EXPECT_LT(std::abs(statistics::chiSquareDeviate(cells, expected)), statistics::kDeviateLimit);
}

TEST(Rng, StreamsOfAPictureHaveDifferentKeys) {
    Lib lib;
    std::set<std::pair<std::uint32_t, std::uint32_t>> keys;
    for (unsigned y = 0; y < 256; ++y) {
        for (unsigned x = 0; x < 256; ++x) {
            const auto rng = lib.makeRng(x, y, 0, 0);
            keys.insert({rng.key0, rng.key1});
        }
    }
    EXPECT_EQ(keys.size(), 256u * 256u);
}

TEST(Rng, IsTheSameInFloatAndDouble) {
    Lib lib;
    ShaderLibSingle single;
    auto a = lib.makeRng(1, 2, 3, 4);
    auto b = single.makeRng(1, 2, 3, 4);
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(lib.random01(a), double(single.random01(b)));
}

TEST(Rng, NeverReachesOne) {
    Lib lib;
    auto rng = lib.makeRng(9, 9, 9, 9);
    for (int i = 0; i < 1 << 20; ++i) {
        const double x = lib.random01(rng);
        ASSERT_GE(x, 0.0);
        ASSERT_LT(x, 1.0);
    }
}

}  // namespace
}  // namespace macula
