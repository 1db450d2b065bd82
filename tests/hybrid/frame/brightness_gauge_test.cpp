#include "pipeline/hybrid/frame/brightness_gauge.h"

#include <gtest/gtest.h>

#include <limits>

namespace macula::hybrid {
namespace {

using Pictures = std::vector<std::vector<glm::vec4>>;

Pictures even(const glm::vec4& value, std::size_t pixels = 100, std::size_t pictures = 2) {
    return Pictures(pictures, std::vector<glm::vec4>(pixels, value));
}

TEST(BrightnessGain, IsTheRatioOfTheMeansWhereBothCoverMoreThanHalf) {
    Pictures traced = even({0.4f, 0.4f, 0.4f, 0.9f});
    Pictures drawn = even({0.5f, 0.5f, 0.5f, 0.8f});
    EXPECT_NEAR(brightnessGain(traced, drawn), 0.8, 1e-6);
    // What only one of them covers does not count, however bright.
    traced[0][3] = {90.0f, 90.0f, 90.0f, 0.4f};
    drawn[1][7] = {90.0f, 90.0f, 90.0f, 0.5f};
    EXPECT_NEAR(brightnessGain(traced, drawn), 0.8, 1e-6);
    // Mean over mean, not the mean of ratios: noise in single pixels does not matter.
    for (std::size_t i = 0; i < 100; i += 2) {
        traced[0][i] = {0.8f, 0.8f, 0.8f, 0.9f};
        traced[0][i + 1] = {0.0f, 0.0f, 0.0f, 0.9f};
    }
    EXPECT_NEAR(brightnessGain(traced, drawn), 0.8, 0.005);
    // By luminance.
    EXPECT_NEAR(brightnessGain(even({0, 1, 0, 1}), even({1, 1, 1, 1})), 0.7152, 1e-6);
}

TEST(BrightnessGain, IsOneWhereNothingCanBeToldAndStaysNearOne) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(brightnessGain({}, {}), 1.0);
    EXPECT_EQ(brightnessGain(even(glm::vec4(0.0f)), even(glm::vec4(1.0f))), 1.0);
    EXPECT_EQ(brightnessGain(even({0, 0, 0, 1}), even(glm::vec4(1.0f))), 1.0);
    EXPECT_EQ(brightnessGain(even(glm::vec4(1.0f)), even({0, 0, 0, 1})), 1.0);
    EXPECT_EQ(brightnessGain(even(glm::vec4(1.0f), 1, 1), even(glm::vec4(0.5f), 1, 1)), 1.0);
    EXPECT_EQ(brightnessGain(even(glm::vec4(nan)), even(glm::vec4(1.0f))), 1.0);
    EXPECT_EQ(brightnessGain(even(glm::vec4(1.0f)), even(glm::vec4(infinity))), 1.0);
    // A million to one is not a matter of brightness.
    EXPECT_EQ(brightnessGain(even({1e6f, 1e6f, 1e6f, 1}), even(glm::vec4(1.0f))), 2.0);
    EXPECT_EQ(brightnessGain(even({1e-6f, 1e-6f, 1e-6f, 1}), even(glm::vec4(1.0f))), 0.5);
    Pictures broken = even({0.5f, 0.5f, 0.5f, 1.0f});
    broken[0][5] = glm::vec4(nan);
    broken[1][6] = glm::vec4(infinity, 0, 0, 1);
    EXPECT_NEAR(brightnessGain(broken, even(glm::vec4(1.0f))), 0.5, 1e-9);
}

}  // namespace
}  // namespace macula::hybrid
