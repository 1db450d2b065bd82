// Scrambled Sobol points against what makes them: nets in base two.
#include "pipeline/hybrid/views/pose_sampling.h"

#include <gtest/gtest.h>

#include <set>

namespace macula::hybrid {
namespace {

// Of 2^k points, one lies in each interval of 2^-a by 2^-(k - a), whatever a is and however they are
// scrambled.
TEST(Sobol, EveryElementaryIntervalHasOnePoint) {
    constexpr unsigned kPower = 8;
    constexpr std::uint32_t kCount = 1u << kPower;
    for (const std::uint64_t seed : {0ull, 1ull, 42ull, ~0ull}) {
        for (const std::uint32_t first : {0u, kCount, 5 * kCount}) {
            for (unsigned a = 0; a <= kPower; ++a) {
                std::set<std::pair<int, int>> cells;
                for (std::uint32_t i = first; i < first + kCount; ++i) {
                    const glm::dvec2 p = scrambledSobol(i, seed);
                    ASSERT_TRUE(p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0);
                    cells.emplace(int(p.x * double(1u << a)), int(p.y * double(1u << (kPower - a))));
                }
                EXPECT_EQ(cells.size(), kCount) << "seed " << seed << ", a " << a;
            }
        }
    }
}

TEST(Sobol, SeedsGiveOtherPointsAndTheSameSeedTheSame) {
    EXPECT_EQ(scrambledSobol(7, 42), scrambledSobol(7, 42));
    std::set<double> first;
    for (std::uint64_t seed = 0; seed < 64; ++seed) {
        const glm::dvec2 p = scrambledSobol(0, seed);
        first.insert({p.x, p.y});
    }
    EXPECT_EQ(first.size(), 128u);  // of 2^32 values each: two alike are a chance of 2e-6
}

}  // namespace
}  // namespace macula::hybrid
