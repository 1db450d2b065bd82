// The device at the ends of what may come: as the reference in double, and finite.
#include "pipeline/trace/reference_tracer.h"
#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"

namespace macula::trace {
namespace {

using ExtremesOnDevice = DeviceTest;

TEST_F(ExtremesOnDevice, AreThoseOfTheReference) {
    constexpr std::uint32_t kSamples = 16;
    for (const scenes::ExtremeScene& scene : scenes::extremeScenes()) {
        SCOPED_TRACE(scene.name);
        const Settings settings{.bounces = 2, .seed = 77, .filter = Filter::trilinear};
        PathTracer t = tracer(scene.volume, scene.function, scene.environment, scene.view, settings);
        ASSERT_TRUE(*t.trace(kSamples));
        const auto image = t.readback();
        ASSERT_TRUE(image.ok());
        EXPECT_EQ(t.statistics()->nonFiniteSamples, 0u);
        EXPECT_EQ(t.statistics()->collisionsAboveBound, 0u);
        const Medium medium = makeMedium(*scene.volume, makeBrickGrid(*scene.volume), scene.function);
        const auto params = makeTraceParams(*scene.volume, medium, scene.environment, scene.view, settings);
        const auto sums = ReferenceTracer(*scene.volume, medium, scene.environment)
                              .trace(*params, settings.filter, Precision::twofold, 0, kSamples);
        // The same random numbers; float sends hardly a path another way.
        glm::dvec4 device(0.0);
        glm::dvec4 reference(0.0);
        int different = 0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(image->radiance[i][c]));
            const glm::dvec4 here(image->radiance[i]);
            const glm::dvec4 there = sums[i] / double(kSamples);
            device += here;
            reference += there;
            const bool same =
                std::abs(here.a - there.a) < 1e-6 && std::abs(here.g - there.g) < 1e-3 * there.g + 1e-6;
            different += same ? 0 : 1;
        }
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(device[c], reference[c], 2e-3 * reference[c]) << c;
        EXPECT_LE(different, int(sums.size()) / 25);
    }
}

// Every sample of a million counts as much as the first, in the mean and in the variance. The left pixel sees
// a grey face, which is the same in all samples: where rounding adds up, it always adds up to one side. The
// right one sees a slab; the one between sees both.
TEST_F(ExtremesOnDevice, AMillionSamplesDoNotDrift) {
    auto [volume, view] = scenes::slab(10.0, 1);
    view.width = 3;
    Clip clip{.box = OrientedBox{.centreMm = {-19.9, -6, 0}, .halfSizeMm = {20, 4, 40}},
              .ofBox = Keep::outside};
    clip.greyFaces = DisplayWindow{.center = 1, .width = 2, .explanation = {}, .function = "LINEAR_EXACT"};
    const Environment sky = Environment::constant(glm::vec3(0.7f, 0.7f, 0.7f));
    const Settings settings{.bounces = 1, .seed = 5, .filter = Filter::stochastic};
    const TransferFunction function = scenes::homogeneous(0.1);
    PathTracer t = tracer(volume, function, sky, view, settings);
    ASSERT_TRUE(t.scene().setClip(clip).ok());
    constexpr std::uint32_t kSamples = 1'000'000;
    ASSERT_TRUE(*t.trace(kSamples));
    EXPECT_EQ(t.statistics()->samplesPerPixel, kSamples);
    const auto image = t.readback();

    // sRGB's 0.5 is 0.21404; the tone map takes 0.04 away.
    EXPECT_NEAR(double(image->radiance[0].g), 0.25404, 2e-5);
    EXPECT_EQ(image->radiance[0].a, 1.0f);
    const double square = std::pow(0.25404, 2.0);
    // Plain sums of floats would be off by 1e-3 and more. What there is: seen from 3 m a float tells 0.0002
    // mm, and of that much matter before the face one ray in 10^5 meets some.
    EXPECT_LT(double(image->variance[0].x) * kSamples, 5e-5 * square);
    EXPECT_LT(image->variance[0].y, 1e-12f);

    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), function, clip);
    const ReferenceTracer reference(*volume, medium, sky);
    const auto params = makeTraceParams(*volume, medium, sky, view, settings, clip);
    const glm::dvec4 sum = reference.trace(*params, settings.filter, Precision::twofold, 0, kSamples)[2];
    // Of a million paths a few are sent elsewhere by a rounding.
    EXPECT_NEAR(double(image->radiance[2].a), sum.a / kSamples, 6e-6);
    EXPECT_NEAR(double(image->radiance[2].g), sum.g / kSamples, 6e-6);
    const double coverage = -std::expm1(-1.0);
    EXPECT_NEAR(sum.a / kSamples, coverage, 5.0 * 0.482 / 1000.0);

    // The variance, from other samples: each of many small pixels is one sample of the large one. What is
    // told of a variance of n values is uncertain by sqrt((kurtosis - 1) / n), 0.3 % here.
    View fine = view;
    fine.width = 96;
    fine.height = 32;
    double first = 0.0;
    double second = 0.0;
    constexpr int kPictures = 150;
    for (std::uint32_t n = 0; n < kPictures; ++n) {
        const auto other = makeTraceParams(*volume, medium, sky, fine,
                                           {.bounces = 1, .seed = 100 + n, .filter = settings.filter}, clip);
        const auto pixels = reference.trace(*other, settings.filter, Precision::twofold, 0, 1);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (i % 96 < 64) continue;
            first += pixels[i].g;
            second += pixels[i].g * pixels[i].g;
        }
    }
    first /= 1024.0 * kPictures;
    second /= 1024.0 * kPictures;
    EXPECT_NEAR(double(image->variance[2].x) * kSamples / (second - first * first), 1.0, 0.015);
    EXPECT_NEAR(double(image->variance[2].y) * kSamples / (coverage * (1.0 - coverage)), 1.0, 0.005);
}

}  // namespace
}  // namespace macula::trace
