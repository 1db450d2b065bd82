// The estimators against answers known on paper, in float and in double, without a GPU.
#include <gtest/gtest.h>

#include "base/phantom.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

class Reference : public ::testing::TestWithParam<std::tuple<Precision, Filter>> {
  protected:
    Precision precision() const { return std::get<0>(GetParam()); }
    Filter filter() const { return std::get<1>(GetParam()); }
};

TEST_P(Reference, TransmittanceOfASlabIsExponential) {
    const auto [volume, view] = scenes::slab(10.0, 4);
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    for (const double depth : {1e-4, 1e-2, 0.5, 3.0, 10.0, 50.0}) {
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(depth / 10.0));
        const auto params = makeTraceParams(*volume, medium, sky, view, {.seed = 5});
        const ReferenceTracer tracer(*volume, medium, sky);
        const std::uint32_t kSamples = depth < 0.1 ? 5000000 : 200000;  // enough to see the thinnest
        const auto moments =
            tracer.transmittance(*params, filter(), precision(), {8, -100, 8}, {0, 1, 0}, kSamples);
        const double mean = moments.sum / kSamples;
        const double exact = std::exp(-depth);
        // The variance is known too: a collision ends the ray, as the bound is tight.
        const double error = std::sqrt(exact * (1.0 - exact) / kSamples);
        EXPECT_NEAR(mean, exact, 4.5 * error + 2e-6) << depth;
        EXPECT_LT(4.5 * error, 0.25 * -std::expm1(-depth)) << "the test must be able to see the matter";
    }
}

// Ratio tracking through matter that varies, against the integral of the extinction.
TEST_P(Reference, TransmittanceOfARampIsTheExponentialOfItsIntegral) {
    const auto volume =
        scenes::volumeOf({8, 64, 8}, glm::dmat4(1.0), [](int, int j, int) { return std::uint16_t(j); });
    TransferFunction ramp = scenes::homogeneous(1.0);
    ramp.opacity = {{0, 0.0}, {63, 0.1}};
    ramp.density = 1.0;
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume, reachOf(filter())), ramp);
    const auto params = makeTraceParams(*volume, medium, sky, {}, {.seed = 6});
    const ReferenceTracer tracer(*volume, medium, sky);
    double depth = 0.0;
    constexpr int kSteps = 64000;
    for (int i = 0; i < kSteps; ++i) {
        const double j = std::clamp(64.0 * (i + 0.5) / kSteps - 0.5, 0.0, 63.0);
        depth += extinctionPerMm(ramp, j) * 64.0 / kSteps;
    }
    constexpr std::uint32_t kSamples = 100000;
    const auto moments =
        tracer.transmittance(*params, filter(), precision(), {4, -1, 4}, {0, 1, 0}, kSamples);
    const double mean = moments.sum / kSamples;
    const double error = std::sqrt((moments.sumOfSquares / kSamples - mean * mean) / kSamples);
    EXPECT_NEAR(mean, std::exp(-depth), 4.5 * error);
    EXPECT_LT(error, 0.002);
}

// White matter in a white sky is white, however dense: no light is lost or made.
TEST_P(Reference, WhiteFurnaceIsOneEverywhere) {
    const auto volume = scenes::volumeOf(
        {20, 20, 20}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-9.5, -9.5, -9.5}), [](int i, int j, int k) {
            const double r = std::hypot(i - 9.5, j - 9.5, k - 9.5);
            return std::uint16_t(r < 8 ? 1 : 0);
        });
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const Surface wet{.weight = 1.0, .gradientPerMm = 0.1, .roughness = 0.3, .reflectance = 0.1};
    for (const auto& [g, surface] : {std::pair(0.0, Surface{}), {0.6, Surface{}}, {0.0, wet}}) {
        TransferFunction white = scenes::homogeneous(0.25);
        white.anisotropy = g;
        white.surface = surface;
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume, reachOf(filter())), white);
        const View view{
            .camera = {.positionMm = {0, -60, 0}, .targetMm = {0, 0, 0}}, .width = 16, .height = 16};
        const auto params = makeTraceParams(*volume, medium, sky, view, {.bounces = 1024, .seed = 7});
        const ReferenceTracer tracer(*volume, medium, sky);
        constexpr int kBatches = 16;
        constexpr std::uint32_t kSamples = 64;
        double sum = 0.0;
        double squares = 0.0;
        for (int batch = 0; batch < kBatches; ++batch) {
            double mean = 0.0;
            for (const glm::dvec4& pixel :
                 tracer.trace(*params, filter(), precision(), kSamples * unsigned(batch), kSamples)) {
                // What the pixel shows over the sky: radiance and the sky through what was not met.
                mean += (pixel.r + (kSamples - pixel.a)) / kSamples / 256.0;
            }
            sum += mean;
            squares += mean * mean;
        }
        const double mean = sum / kBatches;
        const double error = std::sqrt((squares / kBatches - mean * mean) / (kBatches - 1));
        // The table of the coat is not exact.
        EXPECT_NEAR(mean, 1.0, 4.5 * error + (surface.weight > 0.0 ? 1e-3 : 0.0)) << g;
        EXPECT_LT(error, 0.005);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Reference,
                         ::testing::Combine(::testing::Values(Precision::single, Precision::twofold),
                                            ::testing::ValuesIn(kFilters)),
                         [](const auto& p) {
                             return std::string(std::get<0>(p.param) == Precision::single ? "Float"
                                                                                          : "Double") +
                                    std::string(nameOf(std::get<1>(p.param)));
                         });

TEST(ReferencePrecision, FloatAndDoubleSeeTheSamePhantom) {
    const Volume volume = phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}});
    TransferFunction bone = scenes::homogeneous(1.0);
    bone.opacity = {{150, 0.0}, {400, 0.8}};
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const Medium medium = makeMedium(volume, makeBrickGrid(volume), bone);
    const View view{
        .camera = frameBox(volume.worldBox(), ViewDirection::anterior, 30, 1), .width = 48, .height = 48};
    const auto params = makeTraceParams(volume, medium, sky, view, {});
    const ReferenceTracer tracer(volume, medium, sky);
    const auto single = tracer.trace(*params, Filter::trilinear, Precision::single, 0, 16);
    const auto twofold = tracer.trace(*params, Filter::trilinear, Precision::twofold, 0, 16);
    glm::dvec4 a(0.0);
    glm::dvec4 b(0.0);
    for (std::size_t i = 0; i < single.size(); ++i) {
        a += single[i];
        b += twofold[i];
    }
    // The same random numbers: the same paths, but for the few that a rounding sends elsewhere.
    EXPECT_NEAR(a.r / b.r, 1.0, 2e-3);
    EXPECT_NEAR(a.a / b.a, 1.0, 1e-3);
}

}  // namespace
}  // namespace macula::trace
