// What a picture takes from the views before it, and what it must not.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "pipeline/gpu/transfer.h"
#include "trace/denoise_pictures.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"
#include "trace/small_scenes.h"

namespace macula::trace {
namespace {

using ViewHistoryOnDevice = DeviceTest;

constexpr double kRadiusMm = 20.0;

std::shared_ptr<const Volume> ball() {
    const glm::ivec3 size(48);
    const glm::dvec3 first(-23.5);
    return scenes::volumeOf(size, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, first), [=](int i, int j, int k) {
        const double mm = glm::length(first + glm::dvec3(i, j, k)) - kRadiusMm;
        return static_cast<std::uint16_t>(std::clamp(1000.0 - 100.0 * mm, 0.0, 4000.0));
    });
}

TransferFunction dense() {
    TransferFunction function = scenes::homogeneous(20.0, 0.9);
    function.opacity = {{1000, 0.0}, {1000, 0.5}};
    return function;
}

View around(double azimuthDeg, int pixels) {
    const double azimuth = glm::radians(azimuthDeg);
    return {.camera = {.positionMm = 150.0 * glm::dvec3(std::sin(azimuth), -std::cos(azimuth), 0.0),
                       .targetMm = {0, 0, 0},
                       .up = {0, 0, 1},
                       .verticalFovDeg = 20},
            .width = pixels,
            .height = pixels};
}

// Where the light is, of the width of the picture.
double centreOfLight(const TracedImage& image) {
    double sum = 0.0;
    double across = 0.0;
    for (std::size_t i = 0; i < image.radiance.size(); ++i) {
        const double light = double(image.radiance[i].y);
        sum += light;
        across += light * (double(i % std::size_t(image.width)) + 0.5) / double(image.width);
    }
    return across / sum;
}

// A light that turns with the eye lights a ball the same way all around it, and so does the picture of an
// orbit.
TEST_F(ViewHistoryOnDevice, LightOnTheCameraDoesNotLagBehindASteadyOrbit) {
    constexpr int kPixels = 48;
    const scenes::Sky sky = scenes::oneLight(12, 3, glm::vec3(40.0f), 0.02f);
    const Environment light =
        *Environment::fromImage(sky.width, sky.height, sky.radiance, LightFrame::camera);
    Settings settings{.bounces = 1, .denoising = Denoising::on};
    PathTracer still = tracer(ball(), dense(), light, around(0, kPixels), settings);
    ASSERT_TRUE(*still.trace(256));
    const double expected = centreOfLight(*still.readback());
    EXPECT_GT(std::abs(expected - 0.5), 0.05) << "the light comes from one side";
    for (const double stepDeg : {0.9, -0.3}) {
        PathTracer t = tracer(ball(), dense(), light, around(0, kPixels), settings);
        double mean = 0.0;
        for (int i = 0; i < 60; ++i) {
            settings.seed = std::uint32_t(i + 1);
            ASSERT_TRUE(t.setSettings(settings).ok());
            ASSERT_TRUE(t.setView(around(stepDeg * i, kPixels)).ok());
            ASSERT_TRUE(*t.trace(1));
            const double centre = centreOfLight(*t.readback());
            if (i >= 40) mean += centre / 20.0;
        }
        // Two degrees move what the light falls on by 0.035 of the radius, which is 0.38 of the width.
        EXPECT_NEAR(mean, expected, 0.015) << stepDeg;
    }
}

// Faces that show grey values look the same at any exposure: the light that was kept of them is another.
TEST_F(ViewHistoryOnDevice, GreyFacesKeepTheirGreyWhenTheExposureChanges) {
    const Clip clip{.planes = {{{0, 1, 0}, 0.0}},
                    .greyFaces = DisplayWindow{.center = 2500, .width = 5000, .function = "LINEAR_EXACT"}};
    Settings settings{.bounces = 1, .denoising = Denoising::on};
    const Environment even = Environment::constant(glm::vec3(1.0f));
    const auto greyOf = [](PathTracer& t) { return *t.readDisplay(glm::vec3(0.0f)); };
    PathTracer t = tracer(ball(), dense(), even, around(0, 32), settings);
    ASSERT_TRUE(t.scene().setClip(clip).ok());
    ASSERT_TRUE(*t.trace(8));
    const auto before = greyOf(t);
    for (const double exposure : {4.0, 0.25}) {
        settings.exposure = exposure;
        ++settings.seed;
        ASSERT_TRUE(t.setSettings(settings).ok());
        ASSERT_TRUE(*t.trace(1));
        const auto after = greyOf(t);
        // In the middle there is the face.
        for (int y = 13; y < 19; ++y) {
            for (int x = 13; x < 19; ++x) {
                const std::size_t i = 4 * std::size_t(y * 32 + x);
                EXPECT_NEAR(int(after[i]), int(before[i]), 2) << exposure << " " << x << " " << y;
            }
        }
    }
}

// Where a picture is stored smaller than elsewhere, a pixel of it shows more.
TEST_F(ViewHistoryOnDevice, AFoveatedPixelIsAsWideAsWhatItShows) {
    const View view{.camera = {.verticalFovDeg = 60},
                    .width = 64,
                    .height = 48,
                    .foveation = Foveation{.gaze = {0.3, -0.2}, .fieldDeg = 12.0, .magnification = 3.0}};
    const FoveaInPlane fovea = foveaInPlane(view);
    const double width = 2.0 * fovea.halfSize.y / view.height;
    const TruePicture picture(view.width, view.height, [](int, int) {
        TruePixel pixel{};
        pixel.depthMm = 100.0;
        return pixel;
    });
    shared::DenoisePush push = picture.push();
    push.pixelAngle = float(width);
    push.planeHalfSize = fovea.halfSize;
    push.gaze = fovea.gaze;
    push.foveaRadius = float(fovea.radius);
    push.foveaMagnification = float(fovea.magnification);
    const DenoiseGuides guides = picture.guides();
    std::vector<glm::dvec4> masses;
    const DenoiseRecord record = denoiseGather(push, picture.film(4, 1), guides, guides, {});
    const DenoiseState state = denoisePrepare(push, record, guides, masses);
    // At the gaze a third of the width of a stored pixel, at the border more than one.
    const auto footprint = [&](int x, int y) {
        return 2.0 * state.noises[std::size_t(y * view.width + x)].z / 100.0;
    };
    const int gazeX = int((0.5 + 0.5 * 0.3) * view.width);
    const int gazeY = int((0.5 + 0.5 * 0.2) * view.height);
    EXPECT_NEAR(footprint(gazeX, gazeY), width / 3.0, 0.01 * width);
    double area = 0.0;
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) area += footprint(x, y) * footprint(x, y);
    }
    // All of them together show all of the picture.
    EXPECT_NEAR(area, 4.0 * fovea.halfSize.x * fovea.halfSize.y, 0.02 * area);
    EXPECT_GT(footprint(0, 0), 1.2 * width);

    // And so it is on the device.
    const TruePicture scene = scenery(48);
    const glm::ivec2 size(scene.width, scene.height);
    shared::DenoisePush square = push;
    square.imageSize = size;
    Denoiser denoiser = *Denoiser::create(device(), *DenoiseKernels::create(device()), size.x, size.y);
    const Film film = *Film::create(device(), size.x, size.y);
    const Guides now = *Guides::create(device(), size.x, size.y);
    const DenoiseFilm samples = scene.film(4, 1);
    const DenoiseGuides values = scene.guides();
    const auto narrowed = [](const std::vector<glm::dvec4>& from) {
        return std::vector<glm::vec4>(from.begin(), from.end());
    };
    std::vector<glm::vec2> squares;
    for (const double luminance : samples.squares) squares.emplace_back(luminance, 0.0);
    ASSERT_TRUE(gpu::uploadTo<glm::vec4>(film.sums(), narrowed(samples.sums)).ok());
    ASSERT_TRUE(gpu::uploadTo<std::uint32_t>(film.counts(), samples.counts).ok());
    ASSERT_TRUE(gpu::uploadTo<glm::vec2>(film.squares(), squares).ok());
    ASSERT_TRUE(gpu::uploadTo<glm::vec4>(now.surfaces().buffer(), narrowed(values.surfaces)).ok());
    ASSERT_TRUE(gpu::uploadTo<glm::vec4>(now.matters().buffer(), narrowed(values.matters)).ok());
    ASSERT_TRUE(gpu::uploadTo<glm::vec4>(now.motions().buffer(), narrowed(values.motions)).ok());
    ASSERT_TRUE(denoiser.run(film, now, nullptr, square.pixelAngle, Denoising::on, {}, fovea).ok());
    const auto found = gpu::read<glm::vec4>(denoiser.result());
    ASSERT_TRUE(found.ok());
    const auto expected = denoised(square, denoiseGather(square, samples, values, values, {}), values);
    double moved = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        for (int c = 0; c < 4; ++c)
            EXPECT_NEAR((*found)[i][c], expected[i][c], 2e-4 * (1 + std::abs(expected[i][c]))) << i;
        moved += glm::length(expected[i] - samples.sums[i] / 4.0);
    }
    EXPECT_GT(moved, 1.0);
}

}  // namespace
}  // namespace macula::trace
