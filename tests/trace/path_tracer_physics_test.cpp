// The device against answers known on paper.
#include <cmath>

#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

class PathTracerPhysics : public DeviceTest, public ::testing::WithParamInterface<Filter> {};

// Coverage is one minus transmittance.
TEST_P(PathTracerPhysics, SlabTransmittanceIsExponentialFromThinToOpaque) {
    constexpr int kPixels = 64;
    constexpr std::uint32_t kSamples = 64;
    const auto [volume, view] = scenes::slab(10.0, kPixels);
    for (const double depth : {1e-4, 1e-3, 0.1, 1.0, 5.0, 20.0, 50.0}) {
        PathTracer t =
            tracer(volume, scenes::homogeneous(depth / 10.0), Environment::constant(glm::vec3(1.0f)), view,
                   {.bounces = 1, .seed = 3, .filter = GetParam()});
        ASSERT_TRUE(*t.trace(kSamples));
        const auto image = t.readback();
        ASSERT_TRUE(image.ok());
        double coverage = 0.0;
        for (const glm::vec4& pixel : image->radiance) coverage += double(pixel.a);
        coverage /= double(image->radiance.size());
        const double exact = std::exp(-depth);
        const double error = std::sqrt(exact * (1.0 - exact) / (double(kPixels) * kPixels * kSamples));
        EXPECT_NEAR(1.0 - coverage, exact, 4.5 * error + 2e-6) << depth;
    }
}

TEST_P(PathTracerPhysics, WhiteFurnaceIsOneInEveryPartOfThePicture) {
    const auto volume = scenes::volumeOf(
        {20, 20, 20}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-9.5, -9.5, -9.5}),
        [](int i, int j, int k) { return std::uint16_t(std::hypot(i - 9.5, j - 9.5, k - 9.5) < 8 ? 1 : 0); });
    constexpr int kPixels = 32;
    constexpr int kBatches = 16;
    const View view{
        .camera = {.positionMm = {0, -60, 0}, .targetMm = {0, 0, 0}}, .width = kPixels, .height = kPixels};
    PathTracer t = tracer(volume, scenes::homogeneous(0.25), Environment::constant(glm::vec3(1.0f)), view,
                          {.bounces = 1024, .seed = 4, .filter = GetParam()});
    // 16 parts of 8 x 8 pixels each, and independent batches to know the error.
    std::vector<double> sum(16, 0.0);
    std::vector<double> squares(16, 0.0);
    for (int batch = 0; batch < kBatches; ++batch) {
        ASSERT_TRUE(
            t.setSettings({.bounces = 1024, .seed = std::uint32_t(100 + batch), .filter = GetParam()}).ok());
        ASSERT_TRUE(*t.trace(16));
        const auto image = t.readback();
        std::vector<double> mean(16, 0.0);
        for (int y = 0; y < kPixels; ++y) {
            for (int x = 0; x < kPixels; ++x) {
                const glm::vec4 pixel = image->radiance[std::size_t(y * kPixels + x)];
                mean[std::size_t(y / 8 * 4 + x / 8)] += (double(pixel.r) + 1.0 - double(pixel.a)) / 64.0;
            }
        }
        for (std::size_t i = 0; i < 16; ++i) {
            sum[i] += mean[i] / kBatches;
            squares[i] += mean[i] * mean[i] / kBatches;
        }
    }
    const auto statistics = t.statistics();
    EXPECT_EQ(statistics->abandonedSamples, 0u);
    EXPECT_EQ(statistics->nonFiniteSamples, 0u);
    for (std::size_t i = 0; i < 16; ++i) {
        const double error = std::sqrt(std::max(squares[i] - sum[i] * sum[i], 0.0) / (kBatches - 1));
        EXPECT_NEAR(sum[i], 1.0, 5.0 * error + 1e-5) << "part " << i;
        EXPECT_LT(error, 0.03);
    }
}

INSTANTIATE_TEST_SUITE_P(Filters, PathTracerPhysics, ::testing::Values(Filter::trilinear, Filter::stochastic),
                         [](const auto& p) {
                             return p.param == Filter::trilinear ? "Trilinear" : "Stochastic";
                         });

using PathTracerDepth = DeviceTest;

TEST_F(PathTracerDepth, IsWhereTransmittanceFallsToOneHalf) {
    const auto [volume, view] = scenes::slab(10.0, 8);
    PathTracer t = tracer(volume, scenes::homogeneous(0.2), Environment::constant(glm::vec3(1.0f)), view, {});
    const auto image = t.readback();
    ASSERT_TRUE(image.ok());
    for (const float mm : image->depthMm) EXPECT_NEAR(mm, 3000 - 5 + std::log(2.0) / 0.2, 0.01);
    ASSERT_TRUE(t.setTransferFunction(scenes::homogeneous(0.05)).ok());
    const auto thin = t.readback();
    for (const float mm : thin->depthMm) EXPECT_TRUE(std::isinf(mm));
}

}  // namespace
}  // namespace macula::trace
