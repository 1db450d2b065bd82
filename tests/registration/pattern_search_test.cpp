#include "registration/pattern_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace macula::registration {
namespace {

constexpr SearchRange kRange{.firstStep = 8.0, .lastStep = 0.1};
const Parameters kTop{3.0, -7.0, 1.5, 20.0, 0.0, -4.0};

// A hill with a ridge that runs between the axes.
double hill(const Parameters& p) {
    double sum = 0.0;
    for (std::size_t n = 0; n < p.size(); ++n) sum += (p[n] - kTop[n]) * (p[n] - kTop[n]);
    const double across = p[0] - kTop[0] - (p[3] - kTop[3]);
    return -sum - 5.0 * across * across;
}

TEST(PatternSearch, FindsTheTopToAFractionOfItsLastStep) {
    const Highest found = patternSearch(hill, {}, kRange, [] { return false; });
    for (std::size_t n = 0; n < kTop.size(); ++n) EXPECT_NEAR(found.at[n], kTop[n], 0.15) << n;
    EXPECT_DOUBLE_EQ(found.value, hill(found.at));
}

TEST(PatternSearch, EndsWhereNothingIsToBeFoundAndWhenItIsTold) {
    const auto nothing = [](const Parameters&) { return -std::numeric_limits<double>::infinity(); };
    EXPECT_TRUE(std::isinf(patternSearch(nothing, kTop, kRange, [] { return false; }).value));
    const auto broken = [](const Parameters&) { return std::numeric_limits<double>::quiet_NaN(); };
    EXPECT_EQ(patternSearch(broken, kTop, kRange, [] { return false; }).at, kTop);
    int calls = 0;
    const auto counted = [&](const Parameters& p) { return ++calls, hill(p); };
    patternSearch(counted, {}, kRange, [&] { return calls >= 10; });
    EXPECT_LE(calls, 12);
    calls = 0;
    const auto slope = [&](const Parameters& p) { return ++calls, p[0]; };  // without a top
    patternSearch(slope, {}, {.firstStep = 8.0, .lastStep = 0.1, .mostCalls = 300}, [] { return false; });
    EXPECT_LE(calls, 330);
}

}  // namespace
}  // namespace macula::registration
