#include "evaluate/frame_tradeoff.h"

#include <gtest/gtest.h>

#include <limits>

namespace macula::evaluate {
namespace {

using Points = std::vector<CostAndError>;
using Front = std::vector<std::size_t>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ParetoFront, HasWhatNothingElseBeats) {
    // By cost: 3 is the cheapest, 0 costs more and is better, 4 is the best; 1 and 2 are beaten by 0.
    EXPECT_EQ(paretoFront(Points{{2, 0.5}, {3, 0.6}, {2.5, 0.5}, {1, 0.9}, {5, 0.1}}), (Front{3, 0, 4}));
    EXPECT_EQ(paretoFront(Points{{1, 3}, {2, 2}, {3, 1}}), (Front{0, 1, 2})) << "all of a trade";
    EXPECT_EQ(paretoFront(Points{{3, 3}, {2, 2}, {1, 1}}), (Front{2})) << "one beats all";
}

TEST(ParetoFront, OfNothingIsNothingAndOfOneThatOne) {
    EXPECT_TRUE(paretoFront({}).empty());
    EXPECT_EQ(paretoFront(Points{{7, 7}}), (Front{0}));
    EXPECT_EQ(paretoFront(Points{{0, -1}}), (Front{0}));
}

TEST(ParetoFront, OfTiesHasTheBetterAndOfEqualsTheFirst) {
    EXPECT_EQ(paretoFront(Points{{1, 2}, {1, 1}, {1, 3}}), (Front{1})) << "of equal cost";
    EXPECT_EQ(paretoFront(Points{{3, 1}, {1, 1}, {2, 1}}), (Front{1})) << "of equal error";
    EXPECT_EQ(paretoFront(Points{{2, 2}, {1, 3}, {1, 3}, {2, 2}}), (Front{1, 0})) << "of both";
}

TEST(ParetoFront, LeavesOutWhatIsNotFinite) {
    EXPECT_EQ(
        paretoFront(Points{
            {kNan, 0}, {0, kNan}, {1, 1}, {-kInfinity, 0}, {0, -kInfinity}, {kInfinity, 0}, {0, kInfinity}}),
        (Front{2}));
    EXPECT_TRUE(paretoFront(Points{{kNan, kNan}}).empty());
}

}  // namespace
}  // namespace macula::evaluate
