// Chance on a poor device: its log() is off by as much as Vulkan allows near 1, and it has no sin() and cos()
// beyond -pi to pi.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/glsl_in_cpp.h"

namespace macula::trace {
namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PI 3.14159265358979323846
struct PoorDevice : GlslInCpp<float> {
    static constexpr float kPi = 3.14159274f;
    static float log(float x) { return std::log(x) + 0x1p-21f; }
    static float sin(float x) { return std::abs(x) <= kPi ? std::sin(x) : nan(); }
    static float cos(float x) { return std::abs(x) <= kPi ? std::cos(x) : nan(); }
    static float nan() { return std::numeric_limits<float>::quiet_NaN(); }
#include "lib/phase.glsl"
#include "lib/rng.glsl"
};
#undef OUT
#undef INOUT
#undef PI

TEST(Chance, DepthsOfFaintFogAreRight) {
    PoorDevice poor;
    for (int n = 1; n < 1 << 24; n += 1 + n / 64) {
        const double u = std::ldexp(double(n), -24);
        const double exact = -std::log1p(-u);
        EXPECT_NEAR(double(poor.exponentialDepth(float(u))), exact, 1e-3 * exact) << n;
    }
    EXPECT_EQ(poor.exponentialDepth(0.0f), 0.0f);
    const float last = 1.0f - 0x1p-24f;  // the largest random number
    EXPECT_NEAR(poor.exponentialDepth(last), 24.0 * std::log(2.0), 1e-3);
}

TEST(Chance, LightIsScatteredAllAroundByEveryAnisotropy) {
    PoorDevice poor;
    const PoorDevice::vec3 forward(0.48f, -0.6f, 0.64f);
    constexpr int kSteps = 64;
    for (const float g : {-0.99f, -0.5f, 0.0f, 0.001f, 0.3f, 0.99f}) {
        PoorDevice::vec3 sum(0.0f);
        for (int i = 0; i < kSteps; ++i) {
            for (int j = 0; j < kSteps; ++j) {
                const auto to = poor.samplePhase(
                    forward, g,
                    {(float(i) + 0.5f) / kSteps, j + 1 == kSteps ? 1.0f - 0x1p-24f : float(j) / kSteps});
                ASSERT_NEAR(glm::length(to), 1.0, 1e-5) << g << " " << i << " " << j;
                sum += to;
            }
        }
        // The mean direction of the phase function is g times the one before.
        EXPECT_NEAR(glm::length(sum / float(kSteps * kSteps) - forward * g), 0.0, 1.2e-2) << g;
    }
}

// Also where the function is a needle, and floats would cancel.
TEST(Chance, ThePhaseFunctionIsThatOfDoubles) {
    PoorDevice poor;
    for (const float g : {-0.99f, -0.9f, 0.0f, 0.5f, 0.99f}) {
        for (int i = -1000; i <= 1000; ++i) {
            const auto cosine = float(i / 1000.0);
            const double gd = g;
            const double truth = (1.0 - gd * gd) / (4.0 * 3.14159265358979323846 *
                                                    std::pow(1.0 + gd * gd - 2.0 * gd * cosine, 1.5));
            EXPECT_NEAR(poor.phaseHenyeyGreenstein(cosine, g), truth, 1e-5 * truth) << g << " " << cosine;
        }
    }
}

}  // namespace
}  // namespace macula::trace
