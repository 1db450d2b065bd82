// Whether a trend is told from noise.
#include "pipeline/hybrid/model/error_trend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace macula::hybrid {
namespace {

// Sum of twelve uniform numbers less six: standard deviation 1, nearly normal, the same everywhere.
double normal(std::mt19937& random) {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += (random() + 0.5) / 4294967296.0;
    return sum;
}

ErrorTrend trendOf(double fall, double noise, unsigned seed, int count = 9) {
    std::mt19937 random(seed);
    ErrorTrend trend;
    for (int i = 0; i < count; ++i) trend.add(i, 0.1 * std::exp(-fall * i + noise * normal(random)));
    return trend;
}

TEST(ErrorTrend, IsExactWithoutNoise) {
    for (const double fall : {0.05, 0.0, -0.02}) {
        const ErrorTrend trend = trendOf(fall, 0.0, 1);
        ASSERT_TRUE(trend.fallPerSecond());
        EXPECT_NEAR(*trend.fallPerSecond(), fall, 1e-12);
        EXPECT_EQ(trend.isFlat(), fall < 0.002);
    }
}

TEST(ErrorTrend, SaysNothingBeforeTheWindowIsFull) {
    EXPECT_FALSE(trendOf(0.0, 0.0, 1, 8).isFlat());
    EXPECT_FALSE(trendOf(0.0, 0.0, 1, 8).fallPerSecond());
    ErrorTrend trend = trendOf(0.0, 0.0, 1);
    EXPECT_TRUE(trend.isFlat());
    trend.forget();
    EXPECT_FALSE(trend.isFlat());
    // What is no error is no measurement.
    for (int i = 0; i < 9; ++i) trend.add(i, i % 2 == 0 ? 0.0 : std::nan(""));
    EXPECT_FALSE(trend.fallPerSecond());
}

// With noise of 0.5 % and measurements a second apart the header says 0.0007: what falls by 0.006 a second is
// taken for flat with a probability below 1e-7, what stands still for falling with one of 0.2 %. The seeds
// are fixed: of 1000 each, none and at most ten.
TEST(ErrorTrend, IsToldFromNoise) {
    int stopped = 0;
    int wentOn = 0;
    double squares = 0.0;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        stopped += trendOf(0.006, 0.005, seed).isFlat() ? 1 : 0;
        const ErrorTrend still = trendOf(0.0, 0.005, seed);
        wentOn += still.isFlat() ? 0 : 1;
        squares += *still.fallPerSecond() * *still.fallPerSecond();
    }
    EXPECT_EQ(stopped, 0);
    EXPECT_LE(wentOn, 10);
    EXPECT_NEAR(std::sqrt(squares / 1000.0), 0.14 * 0.005, 0.05 * 0.005);
}

// As when two views that the model has just learnt pull it aside.
TEST(ErrorTrend, IsNotDecidedByTwoThatAreFarOff) {
    for (const double factor : {0.3, 3.0}) {
        ErrorTrend falling;
        ErrorTrend still;
        for (int i = 0; i < 9; ++i) {
            const double off = i == 7 || i == 8 ? factor : 1.0;
            falling.add(i, off * std::exp(-0.05 * i));
            still.add(i, off * (1.0 + 1e-4 * (i % 2)));
        }
        EXPECT_NEAR(*falling.fallPerSecond(), 0.05, factor < 1.0 ? 0.12 : 0.06);
        EXPECT_LT(std::abs(*still.fallPerSecond()), 0.002);
    }
}

TEST(ErrorTrend, MeasurementsThatComeFastAreAveraged) {
    ErrorTrend trend;
    for (int i = 0; i < 200; ++i) {
        EXPECT_FALSE(trend.fallPerSecond()) << "not before nine times a quarter of a second";
        trend.add(0.01 * i, i % 2 == 0 ? 0.1 : 0.2);
    }
    for (int i = 200; i < 400; ++i) trend.add(0.01 * i, i % 2 == 0 ? 0.1 : 0.2);
    ASSERT_TRUE(trend.fallPerSecond());
    EXPECT_LT(std::abs(*trend.fallPerSecond()), 0.02) << "of noise of 35 % a measurement";
}

}  // namespace
}  // namespace macula::hybrid
