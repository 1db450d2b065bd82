// The device at the ends of what may come: as the reference in double, and finite.
#include "pipeline/trace/reference_tracer.h"
#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"

namespace macula::trace {
namespace {

using ExtremesOnDevice = DeviceTest;

TEST_F(ExtremesOnDevice, areThoseOfTheReference) {
    constexpr std::uint32_t kSamples = 16;
    for (const scenes::ExtremeScene& scene : scenes::extremeScenes()) {
        SCOPED_TRACE(scene.name);
        const Settings settings{.bounces = 2, .seed = 77, .filter = Filter::trilinear};
        PathTracer t = tracer(scene.volume, scene.function, scene.environment, scene.view, settings);
        ASSERT_TRUE(*t.trace(kSamples));
        const auto image = t.readback();
        ASSERT_TRUE(image.ok());
        EXPECT_EQ(t.statistics()->nonFiniteSamples, 0u);
        const Medium medium = makeMedium(*scene.volume, makeBrickGrid(*scene.volume), scene.function);
        const auto params = makeTraceParams(*scene.volume, medium, scene.environment, scene.view, settings);
        const auto sums = ReferenceTracer(*scene.volume, medium, scene.environment)
                              .trace(*params, settings.filter, Precision::twofold, 0, kSamples);
        // The same random numbers; float sends a few paths another way.
        double device = 0.0;
        double reference = 0.0;
        int different = 0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(image->radiance[i][c]));
            device += double(image->radiance[i].a);
            reference += sums[i].a / kSamples;
            different += std::abs(double(image->radiance[i].a) - sums[i].a / kSamples) > 1e-4 ? 1 : 0;
        }
        EXPECT_NEAR(device, reference, 0.01 * reference + 1e-6);
        EXPECT_LE(different, int(sums.size()) / 6);
    }
}

// Every sample of a million counts as much as the first.
TEST_F(ExtremesOnDevice, aMillionSamplesDoNotDrift) {
    const auto [volume, view] = scenes::slab(10.0, 1);
    const Environment sky = Environment::constant(glm::vec3(0.7f, 0.7f, 0.7f));
    const Settings settings{.bounces = 1, .seed = 5, .filter = Filter::stochastic};
    const TransferFunction function = scenes::homogeneous(0.1);
    PathTracer t = tracer(volume, function, sky, view, settings);
    constexpr std::uint32_t kSamples = 1'000'000;
    ASSERT_TRUE(*t.trace(kSamples));
    const auto image = t.readback();
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), function);
    const auto params = makeTraceParams(*volume, medium, sky, view, settings);
    const glm::dvec4 sum = ReferenceTracer(*volume, medium, sky)
                               .trace(*params, settings.filter, Precision::twofold, 0, kSamples)
                               .front();
    EXPECT_EQ(t.statistics()->samplesPerPixel, kSamples);
    EXPECT_NEAR(double(image->radiance[0].a), sum.a / kSamples, 2e-6);
    EXPECT_NEAR(double(image->radiance[0].g), sum.g / kSamples, 2e-6);
    EXPECT_NEAR(sum.a / kSamples, -std::expm1(-1.0), 5.0 * 0.482 / 1000.0);
}

}  // namespace
}  // namespace macula::trace
