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
    const auto [volume, view] = scenes::slab(10.0, kPixels);
    for (const double depth : {1e-4, 1e-3, 0.1, 1.0, 5.0, 20.0, 50.0}) {
        // At the thin end enough samples to see the effect itself: an error of 4.5 sigma is a fifth of it.
        const std::uint32_t kSamples = depth < 0.01 ? 1280 : 64;
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
        EXPECT_LT(4.5 * error, 0.25 * -std::expm1(-depth)) << "the test must be able to see the matter";
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

// Where light comes from, against what a person would see: a dense ball is bright on the side of the light.
class PathTracerLight : public DeviceTest {
  protected:
    // Mean brightness of the right, left, upper and lower half of the picture of a ball.
    struct Halves {
        double right = 0.0, left = 0.0, top = 0.0, bottom = 0.0;
    };
    static Halves ball(const Environment& environment, ViewDirection from) {
        const auto volume =
            scenes::volumeOf({32, 32, 32}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-15.5, -15.5, -15.5}),
                             [](int i, int j, int k) {
                                 return std::uint16_t(std::hypot(i - 15.5, j - 15.5, k - 15.5) < 12 ? 1 : 0);
                             });
        constexpr int kPixels = 32;
        const View view{
            .camera = frameBox(volume->worldBox(), from, 30, 1.0), .width = kPixels, .height = kPixels};
        PathTracer t = tracer(volume, scenes::homogeneous(3.0), environment, view, {.bounces = 1});
        EXPECT_TRUE(*t.trace(16));
        const auto image = t.readback();
        Halves halves;
        for (int y = 0; y < kPixels; ++y) {
            for (int x = 0; x < kPixels; ++x) {
                const double light = image->radiance[std::size_t(y * kPixels + x)].g;
                (x < kPixels / 2 ? halves.left : halves.right) += light;
                (y < kPixels / 2 ? halves.top : halves.bottom) += light;
            }
        }
        return halves;
    }
    static Environment lamp(LightFrame frame, double azimuthDeg, double elevationDeg) {
        LightRig rig;
        rig.frame = frame;
        rig.lights = {
            {.azimuthDeg = azimuthDeg, .elevationDeg = elevationDeg, .angularRadiusDeg = 8, .radiance = 20}};
        return Environment::fromRig(rig);
    }
};

TEST_F(PathTracerLight, OfThePatientsFrameStaysWithThePatient) {
    const Environment left = lamp(LightFrame::patient, 90, 0);
    const Halves anterior = ball(left, ViewDirection::anterior);
    EXPECT_GT(anterior.right, 3.0 * anterior.left);  // facing the patient, the left is on the right
    const Halves posterior = ball(left, ViewDirection::posterior);
    EXPECT_GT(posterior.left, 3.0 * posterior.right);
    const Halves above = ball(lamp(LightFrame::patient, 0, 80), ViewDirection::anterior);
    EXPECT_GT(above.top, 3.0 * above.bottom);
    const Environment front = lamp(LightFrame::patient, 0, 0);
    const Halves lit = ball(front, ViewDirection::anterior);
    const Halves unlit = ball(front, ViewDirection::posterior);
    EXPECT_GT(lit.left + lit.right, 20.0 * (unlit.left + unlit.right));
}

TEST_F(PathTracerLight, OfTheCamerasFrameStaysWithTheCamera) {
    for (const ViewDirection from : {ViewDirection::anterior, ViewDirection::left, ViewDirection::inferior}) {
        const Halves right = ball(lamp(LightFrame::camera, 90, 0), from);
        EXPECT_GT(right.right, 3.0 * right.left);
        const Halves above = ball(lamp(LightFrame::camera, 0, 80), from);
        EXPECT_GT(above.top, 3.0 * above.bottom);
    }
}

// A panorama is a view from inside: what is right of its middle, which looks to anterior, is on the patient's
// right.
TEST_F(PathTracerLight, OfAPanoramaIsNotMirrored) {
    std::vector<glm::vec3> sky(64 * 32, glm::vec3(0.0f));
    for (int row = 14; row < 18; ++row) {
        for (int column = 46; column < 50; ++column) sky[std::size_t(row * 64 + column)] = glm::vec3(50.0f);
    }
    const Halves anterior = ball(*Environment::fromImage(64, 32, sky), ViewDirection::anterior);
    EXPECT_GT(anterior.left, 3.0 * anterior.right);
}

// Single scattering in thin matter: how much brighter light from behind is than light from the front is the
// ratio of the phase function's ends.
TEST_F(PathTracerLight, ScattersForwardAsThePhaseFunctionSays) {
    const auto [volume, view] = scenes::slab(10.0, 32);
    TransferFunction thin = scenes::homogeneous(0.005);
    thin.anisotropy = 0.4;
    const auto brightness = [&](double azimuthDeg) {
        PathTracer t = tracer(volume, thin, lamp(LightFrame::patient, azimuthDeg, 0), view, {.bounces = 1});
        EXPECT_TRUE(*t.trace(256));
        const auto image = t.readback();
        double sum = 0.0;
        for (const glm::vec4& pixel : image->radiance) sum += double(pixel.g);
        return sum;
    };
    const double ratio = brightness(180) / brightness(0);
    EXPECT_NEAR(ratio / std::pow(1.4 / 0.6, 3.0), 1.0, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Filters, PathTracerPhysics, ::testing::Values(Filter::trilinear, Filter::stochastic),
                         [](const auto& p) {
                             return p.param == Filter::trilinear ? "Trilinear" : "Stochastic";
                         });

}  // namespace
}  // namespace macula::trace
