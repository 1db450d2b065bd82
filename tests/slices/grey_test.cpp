// Against numbers worked out by hand from the formulas of PS3.3 C.11.2.1.2 and C.11.2.1.3.
#include "slices/grey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::slices {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

DisplayWindow window(double center, double width, const char* function = "") {
    return {.center = center, .width = width, .explanation = {}, .function = function};
}

// The four examples of the standard: what is black, what is white, and the line between.
TEST(Grey, LinearIsThatOfTheStandard) {
    for (const char* function : {"", "LINEAR", "what nobody knows"}) {
        const DisplayWindow wide = window(2048, 4096, function);
        EXPECT_EQ(greyOf(0, wide), 0.0);
        EXPECT_EQ(greyOf(-1, wide), 0.0);
        EXPECT_NEAR(greyOf(1, wide), 1.0 / 4095.0, 1e-12);
        EXPECT_NEAR(greyOf(2047.5, wide), 0.5, 1e-12);
        EXPECT_NEAR(greyOf(4094, wide), 4094.0 / 4095.0, 1e-12);
        EXPECT_NEAR(greyOf(4095, wide), 1.0, 1e-12);
        EXPECT_EQ(greyOf(4095.5, wide), 1.0);
        const DisplayWindow step = window(2048, 1, function);
        EXPECT_EQ(greyOf(2047.5, step), 0.0);
        EXPECT_EQ(greyOf(2047.6, step), 1.0);
        const DisplayWindow hundred = window(0, 100, function);
        EXPECT_EQ(greyOf(-50, hundred), 0.0);
        EXPECT_NEAR(greyOf(-49, hundred), 1.0 / 99.0, 1e-12);
        EXPECT_NEAR(greyOf(0, hundred), 50.0 / 99.0, 1e-12);
        EXPECT_NEAR(greyOf(49, hundred), 1.0, 1e-12);
        EXPECT_EQ(greyOf(50, hundred), 1.0);
        const DisplayWindow least = window(0, 1, function);
        EXPECT_EQ(greyOf(-0.5, least), 0.0);
        EXPECT_EQ(greyOf(-0.4, least), 1.0);
    }
}

TEST(Grey, LinearExactIsThatOfTheStandard) {
    const DisplayWindow wide = window(2048, 4096, "LINEAR_EXACT");
    EXPECT_EQ(greyOf(0, wide), 0.0);
    EXPECT_EQ(greyOf(1024, wide), 0.25);
    EXPECT_EQ(greyOf(2048, wide), 0.5);
    EXPECT_EQ(greyOf(4096, wide), 1.0);
    EXPECT_EQ(greyOf(4097, wide), 1.0);
    const DisplayWindow narrow = window(0, 0.5, "LINEAR_EXACT");  // narrower than LINEAR can be
    EXPECT_EQ(greyOf(-0.25, narrow), 0.0);
    EXPECT_EQ(greyOf(0.125, narrow), 0.75);
    EXPECT_EQ(greyOf(0.25, narrow), 1.0);
}

TEST(Grey, SigmoidIsThatOfTheStandard) {
    const DisplayWindow lung = window(-600, 1600, "SIGMOID");
    EXPECT_EQ(greyOf(-600, lung), 0.5);
    EXPECT_NEAR(greyOf(-200, lung), 0.7310585786300049, 1e-12);   // 1 / (1 + 1 / e)
    EXPECT_NEAR(greyOf(-1400, lung), 0.1192029220221175, 1e-12);  // 1 / (1 + e^2)
    EXPECT_EQ(greyOf(1e9, lung), 1.0);
    EXPECT_EQ(greyOf(-1e9, lung), 0.0);
}

TEST(Grey, AWidthThatIsNotAllowedIsTheSmallestThatIs) {
    for (const double width : {0.5, 0.0, -100.0}) {
        EXPECT_EQ(greyOf(99.5, window(100, width)), 0.0);
        EXPECT_EQ(greyOf(99.6, window(100, width)), 1.0);
    }
    for (const double width : {0.0, -100.0}) {
        for (const char* function : {"LINEAR_EXACT", "SIGMOID"}) {
            EXPECT_EQ(greyOf(99.99, window(100, width, function)), 0.0);
            EXPECT_EQ(greyOf(100.01, window(100, width, function)), 1.0);
        }
    }
}

TEST(Grey, IsDefinedForWhatIsNoNumber) {
    for (const char* function : {"LINEAR", "LINEAR_EXACT", "SIGMOID"}) {
        const DisplayWindow good = window(40, 400, function);
        EXPECT_EQ(greyOf(kNan, good), 0.0);
        EXPECT_EQ(greyOf(-kInfinity, good), 0.0);
        EXPECT_EQ(greyOf(kInfinity, good), 1.0);
        EXPECT_EQ(greyOf(1e300, good), 1.0);
        for (const double bad : {kNan, kInfinity, -kInfinity}) {
            EXPECT_EQ(greyOf(40, window(bad, 400, function)), 0.0);
            EXPECT_EQ(greyOf(40, window(40, bad, function)), 0.0);
        }
        for (const double extreme : {1e300, -1e300, 1.7e308, -1.7e308}) {
            for (const double value : {-1e300, 0.0, 1e300}) {
                const double grey = greyOf(value, window(extreme, 1.7e308, function));
                EXPECT_TRUE(grey >= 0.0 && grey <= 1.0);
            }
        }
    }
}

// A window of 256 whole numbers: each is its own shade.
TEST(Grey, BytesAreRoundedToTheNearest) {
    std::vector<float> values;
    for (int n = -3; n < 260; ++n) values.push_back(static_cast<float>(n));
    for (const bool inverted : {false, true}) {
        const auto bytes = toGrey(values, window(128, 256), inverted);
        ASSERT_EQ(bytes.size(), values.size());
        for (std::size_t n = 0; n < bytes.size(); ++n) {
            const int shade = std::clamp(static_cast<int>(n) - 3, 0, 255);
            EXPECT_EQ(bytes[n], inverted ? 255 - shade : shade);
        }
    }
    EXPECT_EQ(toGrey(std::vector<float>{0.4F, 0.6F}, window(128, 256), false),
              (std::vector<std::uint8_t>{0, 1}));
}

TEST(Grey, BytesAreThoseOfTheFunctions) {
    std::vector<float> values;
    for (int n = -1500; n < 3000; ++n) values.push_back(static_cast<float>(n) * 0.7F);
    for (const char* function : {"LINEAR", "LINEAR_EXACT", "SIGMOID"}) {
        for (const double width : {1.0, 80.0, 1500.0}) {
            const DisplayWindow of = window(40, width, function);
            const auto bytes = toGrey(values, of, false);
            for (std::size_t n = 0; n < values.size(); ++n)
                EXPECT_NEAR(bytes[n], greyOf(values[n], of) * 255.0, 0.5 + 1e-9);
        }
    }
}

TEST(Grey, WhereThereIsNoValueIsBlackInvertedOrNot) {
    const std::vector<float> values{kNoValue, 1000.0F, -1000.0F, std::numeric_limits<float>::infinity()};
    for (const char* function : {"LINEAR", "LINEAR_EXACT", "SIGMOID"}) {
        EXPECT_EQ(toGrey(values, window(0, 100, function), false),
                  (std::vector<std::uint8_t>{0, 255, 0, 255}));
        EXPECT_EQ(toGrey(values, window(0, 100, function), true), (std::vector<std::uint8_t>{0, 0, 255, 0}));
    }
    EXPECT_TRUE(toGrey({}, window(0, 100), false).empty());
}

}  // namespace
}  // namespace macula::slices
