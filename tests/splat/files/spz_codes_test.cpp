#include "pipeline/splat/files/spz_codes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace macula::splat::spz {
namespace {

TEST(SpzCodes, EveryByteReadsBackAsItself) {
    for (int byte = 0; byte < 256; ++byte) {
        const auto b = static_cast<std::uint8_t>(byte);
        bool held = true;
        EXPECT_EQ(alphaByte(opacityLogit(b)), b);
        EXPECT_TRUE(std::isfinite(opacityLogit(b)));
        EXPECT_EQ(scaleByte(logScale(b), held), b);
        EXPECT_EQ(colourByte(dcOf(b), held), b);
        EXPECT_EQ(shByte(shOf(b), held), b);
        EXPECT_TRUE(held);
    }
}

TEST(SpzCodes, ExtremesAreClamped) {
    for (const float huge : {1e38f, -1e38f}) {
        bool scale = true;
        bool colour = true;
        bool sh = true;
        const std::uint8_t end = huge > 0 ? 255 : 0;
        EXPECT_EQ(scaleByte(huge, scale), end);
        EXPECT_EQ(colourByte(huge, colour), end);
        EXPECT_EQ(shByte(huge, sh), end);
        EXPECT_EQ(alphaByte(huge), end);
        EXPECT_FALSE(scale || colour || sh);
    }
}

TEST(SpzCodes, KnownRotations) {
    EXPECT_EQ(rotationBits({1, 0, 0, 0}), 0xC0000000u);   // w is the fourth
    EXPECT_EQ(rotationBits({-7, 0, 0, 0}), 0xC0000000u);  // the same rotation
    EXPECT_EQ(rotationBits({0, 0, 0, 2}), 0x80000000u);
    // A quarter turn about -y: w = sqrt(1/2), y = -sqrt(1/2). y is the first of the two largest; w then is
    // negative and of full size.
    EXPECT_EQ(rotationBits({1, 0, -1, 0}), 0x40000000u | 512u | 511u);
    const glm::vec4 back = rotationOf(0x40000000u | 512u | 511u);
    EXPECT_NEAR(back[0], -std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(back[2], std::sqrt(0.5), 1e-6);
}

// Why version 3 is written: the three bytes of version 2 leave w to what is missing to 1.
TEST(SpzCodes, RotationsOfVersion3AreMuchBetter) {
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    const auto angle = [](const glm::dvec4& a, const glm::vec4& b) {
        return 2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, glm::normalize(glm::dvec4(b))))));
    };
    double worst2 = 0.0;
    double worst3 = 0.0;
    for (int i = 0; i < 20000; ++i) {
        glm::dvec4 q(0.2 * normal(random), normal(random), normal(random), normal(random));
        q *= (q[0] < 0.0 ? -1.0 : 1.0) / glm::length(q);
        const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(127.5 * v + 127.5)); };
        worst2 = std::max(worst2, angle(q, rotationOf(byte(q[1]), byte(q[2]), byte(q[3]))));
        worst3 = std::max(worst3, angle(q, rotationOf(rotationBits(glm::vec4(q)))));
    }
    EXPECT_GT(worst2, 0.1);
    EXPECT_LT(worst2, 0.25);
    EXPECT_LT(worst3, 0.0048);
    RecordProperty("worst_version_2_rad", std::to_string(worst2));
    RecordProperty("worst_version_3_rad", std::to_string(worst3));
}

TEST(SpzCodes, RotationsOfAnyBitsAreUnit) {
    std::mt19937 random(5);
    for (int i = 0; i < 10000; ++i) {
        const glm::vec4 q = rotationOf(static_cast<std::uint32_t>(random()));
        const float length = glm::length(q);
        ASSERT_GE(length, 0.999f);
        ASSERT_LE(length, 1.2249f);  // three full sizes at once, which no writer makes: sqrt(3 / 2)
        const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
        const std::uint8_t x = byte();
        const std::uint8_t y = byte();
        const glm::vec4 first = rotationOf(x, y, byte());
        ASSERT_GE(first[0], 0.0f);
        ASSERT_GE(glm::length(first), 0.999f);
    }
}

TEST(SpzCodes, EncodingOfColoursIsSmoothAndInvertible) {
    for (float linear = -0.2f; linear < 3.0f; linear += 0.0007f) {
        EXPECT_NEAR(linearOf(encoded(linear)), linear, 2e-6f + 1e-6f * linear);
        const float step = 1e-3f;
        const float difference = (encoded(linear + step) - encoded(linear - step)) / (2 * step);
        if (linear > 0.01f) {
            EXPECT_NEAR(slope(linear) / difference, 1.0f, 0.02f) << linear;
        }
    }
    EXPECT_NEAR(encoded(1.0f), 1.0f, 1e-6f);
    EXPECT_EQ(slope(-1.0f), 12.92f);
}

}  // namespace
}  // namespace macula::splat::spz
