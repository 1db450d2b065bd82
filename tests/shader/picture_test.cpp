#include <gtest/gtest.h>

#include <limits>

#include "shader/shader_lib.h"

namespace macula {
namespace {

TEST(Picture, AMillionSamplesDoNotDrift) {
    ShaderLibSingle lib;
    ShaderLibSingle::vec4 sum(0.0f);
    ShaderLibSingle::vec4 lost(0.0f);
    double exact = 0.0;
    for (int i = 0; i < 1000000; ++i) {
        const float value = 0.1f + 0.9f * float(i % 1000) / 1000.0f;
        lib.accumulate(sum, lost, ShaderLibSingle::vec4(value, 1.0f, 1e-6f, 0.0f));
        exact += double(value);
    }
    EXPECT_NEAR(double(sum.x) / exact, 1.0, 1e-7);
    EXPECT_EQ(sum.y, 1e6f);
    EXPECT_NEAR(double(sum.z), 1.0, 1e-6);
    EXPECT_EQ(sum.w, 0.0f);
}

TEST(Picture, OnlyFiniteSamplesPass) {
    ShaderLibSingle lib;
    using vec4 = ShaderLibSingle::vec4;
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(lib.isFinite(vec4(0, -1, 1e30f, std::numeric_limits<float>::denorm_min())));
    EXPECT_FALSE(lib.isFinite(vec4(0, kNan, 0, 0)));
    EXPECT_FALSE(lib.isFinite(vec4(0, 0, 0, kInfinity)));
    EXPECT_FALSE(lib.isFinite(vec4(-kInfinity, 0, 0, 0)));
}

TEST(Picture, ToneMapKeepsOrderAndStaysInRange) {
    ShaderLibTwofold lib;
    double last = -1.0;
    for (double x = 1e-6; x < 1e6; x *= 1.01) {
        const auto mapped = lib.toneMapNeutral(ShaderLibTwofold::vec3(x));
        EXPECT_GE(mapped.x, last);
        EXPECT_GE(mapped.x, 0.0);
        EXPECT_LE(mapped.x, 1.0);
        last = mapped.x;
    }
    // In the middle, grey keeps its value but for the constant 0.04 that a dielectric reflects.
    EXPECT_NEAR(lib.toneMapNeutral(ShaderLibTwofold::vec3(0.5)).x, 0.46, 1e-12);
}

TEST(Picture, SrgbEncodingHasTheStandardsValues) {
    ShaderLibTwofold lib;
    EXPECT_EQ(lib.encodeSrgb(0.0), 0.0);
    EXPECT_NEAR(lib.encodeSrgb(1.0), 1.0, 1e-12);
    EXPECT_NEAR(lib.encodeSrgb(0.5), 0.735357, 1e-6);
    EXPECT_EQ(lib.encodeSrgb(-3.0), 0.0);
    EXPECT_NEAR(lib.encodeSrgb(7.0), 1.0, 1e-12);
}

TEST(Picture, TransparentPixelsShowTheBackground) {
    ShaderLibTwofold lib;
    using vec4 = ShaderLibTwofold::vec4;
    using vec3 = ShaderLibTwofold::vec3;
    const vec3 background(0.2, 0.3, 0.4);
    for (const bool keepsHue : {false, true}) {
        EXPECT_EQ(lib.displayColour(vec4(0), background, 1.0, keepsHue),
                  lib.displayColour(vec4(0), background, 8.0, keepsHue));
        EXPECT_EQ(lib.displayColour(vec4(0.25, 0.5, 0.5, 1), background, 1.0, keepsHue),
                  lib.displayColour(vec4(0.25, 0.5, 0.5, 1), vec3(0), 1.0, keepsHue));
    }
}

// No tone map and no exposure changes it, white too; matter that covers half of it halves its light.
TEST(Picture, TheBackgroundIsDisplayedAsItIs) {
    ShaderLibTwofold lib;
    using vec4 = ShaderLibTwofold::vec4;
    using vec3 = ShaderLibTwofold::vec3;
    for (const bool keepsHue : {false, true}) {
        for (int byte = 0; byte <= 255; byte += 5) {
            const double encoded = byte / 255.0;
            const double light = lib.decodeSrgb(encoded);
            for (const double exposure : {0.1, 1.0, 30.0}) {
                const vec3 bare = lib.displayColour(vec4(0), vec3(light, 0.0, 1.0), exposure, keepsHue);
                EXPECT_NEAR(bare.x, encoded, 1e-6) << byte;
                EXPECT_EQ(bare.y, 0.0);
                EXPECT_NEAR(bare.z, 1.0, 1e-12);
                const vec3 half = lib.displayColour(vec4(0, 0, 0, 0.5), vec3(light), exposure, keepsHue);
                EXPECT_NEAR(half.x, lib.encodeSrgb(0.5 * light), 1e-12) << byte;
            }
        }
    }
}

}  // namespace
}  // namespace macula
