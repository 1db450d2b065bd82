// SSIM by sum and difference, as the kernels have it (shaders/lib/splat_ssim.glsl), in double.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "base/glsl_in_cpp.h"

namespace macula::splat {
namespace {

struct Ssim : GlslInCpp<double> {
#define float double
#include "lib/splat_ssim.glsl"
#undef float
};

TEST(Ssim, TapsAreAGaussian) {
    double sum = 0.0;
    for (int i = -5; i <= 5; ++i) sum += std::exp(-i * i / 4.5);
    for (int i = -8; i <= 8; ++i)
        EXPECT_NEAR(Ssim{}.ssimTap(i), std::abs(i) <= 5 ? std::exp(-i * i / 4.5) / sum : 0.0, 1e-15) << i;
}

// Any weights will do for the means: here those of six equal pixels, and the gradient by central differences.
TEST(Ssim, BySumAndDifferenceIsThatOfTheTextbook) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int round = 0; round < 50; ++round) {
        const double range = round % 2 == 0 ? 1.0 : 0.05;
        std::array<double, 6> x{};
        std::array<double, 6> y{};
        for (double& value : x) value = 0.3 + range * uniform(random);
        for (double& value : y) value = 0.4 + range * uniform(random);
        const auto window = [&] {
            double u = 0.0;
            double v = 0.0;
            double uu = 0.0;
            double vv = 0.0;
            for (std::size_t i = 0; i < x.size(); ++i) {
                u += (x[i] + y[i]) / 6;
                v += (x[i] - y[i]) / 6;
                uu += (x[i] + y[i]) * (x[i] + y[i]) / 6;
                vv += (x[i] - y[i]) * (x[i] - y[i]) / 6;
            }
            return Ssim{}.ssimWindow(glm::dvec4(u), glm::dvec4(v), glm::dvec4(uu), glm::dvec4(vv));
        };
        double mx = 0.0;
        double my = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            mx += x[i] / 6;
            my += y[i] / 6;
        }
        double xx = 0.0;
        double yy = 0.0;
        double xy = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            xx += (x[i] - mx) * (x[i] - mx) / 6;
            yy += (y[i] - my) * (y[i] - my) / 6;
            xy += (x[i] - mx) * (y[i] - my) / 6;
        }
        const double ssim =
            (2 * mx * my + 1e-4) * (2 * xy + 9e-4) / ((mx * mx + my * my + 1e-4) * (xx + yy + 9e-4));
        const auto now = window();
        EXPECT_NEAR(now.dissimilarity.x, 1.0 - ssim, 1e-12);
        const double gradient =
            (now.plain.x + now.ofSum.x * (x[2] + y[2]) + now.ofDifference.x * (x[2] - y[2])) / 6;
        const double value = x[2];
        x[2] = value + 1e-6;
        const double above = window().dissimilarity.x;
        x[2] = value - 1e-6;
        EXPECT_NEAR((above - window().dissimilarity.x) / 2e-6, gradient, 1e-6 * (1.0 + std::abs(gradient)));
    }
}

}  // namespace
}  // namespace macula::splat
