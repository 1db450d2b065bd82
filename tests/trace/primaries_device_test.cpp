// Where samples meet matter, and the light that leaves there: of the same samples that the picture is made
// of.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "shader/statistics.h"
#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"
#include "trace/small_scenes.h"

namespace macula::trace {
namespace {

using shared::PrimaryVertex;

using PrimariesTest = DeviceTest;

bool met(const PrimaryVertex& vertex) {
    return vertex.fromEyeMm != glm::vec3(0.0f);
}

std::vector<PrimaryVertex> found(PathTracer& tracer, std::uint32_t samples) {
    auto result = tracer.tracePrimaries(samples);
    EXPECT_TRUE(result.ok()) << result.error().message;
    return result.ok() ? std::move(result).value() : std::vector<PrimaryVertex>();
}

// The picture is the mean of what they tell.
void expectSumsOfPicture(PathTracer& tracer, const std::vector<PrimaryVertex>& vertices,
                         std::uint32_t samples) {
    const auto picture = tracer.readback();
    ASSERT_TRUE(picture.ok());
    const std::size_t pixels = picture->radiance.size();
    ASSERT_EQ(vertices.size(), samples * pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        glm::dvec4 sum(0.0);
        for (std::size_t s = 0; s < samples; ++s) {
            const PrimaryVertex& vertex = vertices[s * pixels + i];
            for (int axis = 0; axis < 3; ++axis) ASSERT_TRUE(std::isfinite(vertex.fromEyeMm[axis])) << i;
            sum += glm::dvec4(glm::dvec3(vertex.radiance), met(vertex) ? 1.0 : 0.0);
        }
        const glm::dvec4 mean = sum / double(samples);
        for (int c = 0; c < 4; ++c)
            ASSERT_NEAR(mean[c], picture->radiance[i][c], 1e-5 * (1.0 + std::abs(mean[c]))) << i;
    }
}

TEST_F(PrimariesTest, TellOfThePictureInEachSmallScene) {
    for (const scenes::SmallScene& scene : scenes::smallScenes()) {
        SCOPED_TRACE(scene.name);
        const Settings settings = scene.settings(Look::cinematic, Filter::trilinear, 5);
        PathTracer tracer =
            DeviceTest::tracer(scene.volume, scene.function, scene.environment(), scene.view, settings);
        ASSERT_TRUE(tracer.scene().setClip(scene.clip).ok());
        std::vector<PrimaryVertex> vertices;
        for (const std::uint32_t samples : {2u, 1u, 2u}) {
            const auto more = found(tracer, samples);
            vertices.insert(vertices.end(), more.begin(), more.end());
        }
        expectSumsOfPicture(tracer, vertices, 5);

        // Rays of the pixel, on the side where it is.
        const auto eye = basis(scene.view.camera);
        ASSERT_TRUE(eye.ok());
        const double half = std::tan(glm::radians(scene.view.camera.verticalFovDeg) / 2.0);
        const auto width = std::size_t(scene.view.width);
        const std::size_t pixels = width * std::size_t(scene.view.height);
        std::size_t seen = 0;
        for (std::size_t n = 0; n < vertices.size(); ++n) {
            if (!met(vertices[n])) continue;
            ++seen;
            if (scene.view.foveation) continue;
            const glm::dvec3 way(vertices[n].fromEyeMm);
            const double along = glm::dot(way, eye->forward) * half;
            const double x = 0.5 * double(width) * (1.0 + glm::dot(way, eye->right) / along);
            const double y = 0.5 * double(scene.view.height) * (1.0 - glm::dot(way, eye->up) / along);
            const std::size_t i = n % pixels;
            ASSERT_NEAR(x, double(i % width) + 0.5, 0.501);
            ASSERT_NEAR(y, double(i / width) + 0.5, 0.501);
        }
        EXPECT_GT(seen, 50u);
    }
}

TEST_F(PrimariesTest, AreFiniteAtTheExtremes) {
    for (const scenes::ExtremeScene& scene : scenes::extremeScenes()) {
        SCOPED_TRACE(scene.name);
        PathTracer tracer =
            DeviceTest::tracer(scene.volume, scene.function, scene.environment, scene.view, {.seed = 3});
        const auto vertices = found(tracer, 2);
        expectSumsOfPicture(tracer, vertices, 2);
    }
}

// Evenly dense matter: they lie as deep as free flights end, and where in the patient that is.
TEST_F(PrimariesTest, LieWhereFreeFlightsEnd) {
    constexpr double kPerMm = 0.5;
    const glm::ivec3 size(20, 60, 20);
    const auto volume =
        scenes::volumeOf(size, scenes::grid(glm::dvec3(1.0), size), [](int, int, int) { return 500; });
    View view = scenes::lookAt(*volume, 1.0, 32);
    view.camera.positionMm = {0, -300, 0};
    view.camera.targetMm = {0, 0, 0};
    PathTracer tracer = DeviceTest::tracer(volume, scenes::homogeneous(kPerMm),
                                           Environment::constant(glm::vec3(1.0f)), view, {.seed = 9});
    std::vector<double> depths;
    for (const PrimaryVertex& vertex : found(tracer, 2)) {
        ASSERT_TRUE(met(vertex));
        const glm::dvec3 atMm = view.camera.positionMm + glm::dvec3(vertex.fromEyeMm);
        depths.push_back(atMm.y + 30.0);
        ASSERT_GE(depths.back(), -1e-3);
    }
    double mean = 0.0;
    for (const double depth : depths) mean += depth / double(depths.size());
    // The mean of exponential numbers has a standard deviation of itself over the root of their count.
    EXPECT_NEAR(mean, 1.0 / kPerMm, 5.0 / kPerMm / std::sqrt(double(depths.size())));
    std::sort(depths.begin(), depths.end());
    EXPECT_NEAR(depths[depths.size() / 2], std::log(2.0) / kPerMm, 0.1);
}

TEST_F(PrimariesTest, OfFacesShowTheirGrey) {
    const glm::ivec3 size(20, 20, 20);
    const auto volume =
        scenes::volumeOf(size, scenes::grid(glm::dvec3(1.0), size), [](int, int, int) { return 500; });
    // So thin that hardly a ray ends before the face or behind it.
    PathTracer tracer =
        DeviceTest::tracer(volume, scenes::homogeneous(1e-6), Environment::constant(glm::vec3(1.0f)),
                           scenes::lookAt(*volume), {});
    Clip clip;
    clip.planes = {{.normal = {0, 1, 0}, .offsetMm = 2.0}};
    clip.greyFaces = DisplayWindow{.center = 500, .width = 1000};
    ASSERT_TRUE(tracer.scene().setClip(clip).ok());
    std::size_t onFace = 0;
    for (const PrimaryVertex& vertex : found(tracer, 2)) {
        if (!met(vertex)) continue;
        const glm::dvec3 atMm = scenes::lookAt(*volume).camera.positionMm + glm::dvec3(vertex.fromEyeMm);
        EXPECT_NEAR(atMm.y, 2.0, 1e-3);
        EXPECT_GT(vertex.radiance.x, 0.05f);
        EXPECT_EQ(vertex.radiance.x, vertex.radiance.y);
        ++onFace;
    }
    EXPECT_GT(onFace, 50u);
}

TEST_F(PrimariesTest, LeaveAPictureThatGoesOn) {
    const glm::ivec3 size(24, 24, 24);
    const auto volume = scenes::volumeOf(size, scenes::grid(glm::dvec3(1.0), size), scenes::blob(size, 1000));
    const TransferFunction function = scenes::ramp(100, 500, 0.6, 1.0);
    const Environment light = Environment::constant(glm::vec3(1.0f));
    PathTracer tracer = DeviceTest::tracer(volume, function, light, scenes::lookAt(*volume), {.seed = 3});
    found(tracer, 2);
    ASSERT_TRUE(*tracer.trace(3));
    const auto mixed = tracer.readback();
    PathTracer plain = DeviceTest::tracer(volume, function, light, scenes::lookAt(*volume), {.seed = 3});
    ASSERT_TRUE(*plain.trace(5));
    const auto expected = plain.readback();
    ASSERT_TRUE(mixed.ok() && expected.ok());
    EXPECT_EQ(mixed->samples, expected->samples);
    for (std::size_t i = 0; i < expected->radiance.size(); ++i)
        for (int c = 0; c < 4; ++c) ASSERT_NEAR(mixed->radiance[i][c], expected->radiance[i][c], 1e-5) << i;

    ASSERT_TRUE(tracer.setSettings({.look = Look::dvr}).ok());
    const auto cast = tracer.tracePrimaries(1);
    ASSERT_FALSE(cast.ok());
    EXPECT_EQ(cast.error().code, ErrorCode::usage);
}

// What is on its way is what was waited for, whatever is traced meanwhile, and where memory is the device's
// own as well.
TEST_F(PrimariesTest, ComeWithTheirPictureWhileTheNextIsTraced) {
    const glm::ivec3 size(24, 24, 24);
    const auto volume = scenes::volumeOf(size, scenes::grid(glm::dvec3(1.0), size), scenes::blob(size, 1000));
    const TransferFunction function = scenes::ramp(100, 500, 0.6, 1.0);
    const Environment light = Environment::constant(glm::vec3(1.0f));
    const auto card = *gpu::Device::create(instance(), {.separateMemory = true});
    for (const Denoising denoising : {Denoising::little, Denoising::off}) {
        for (const int side : {40, 1}) {
            SCOPED_TRACE(side);
            const View view = scenes::lookAt(*volume, 20.0, side);
            const Settings settings{.seed = 3, .denoising = denoising};
            Settings other = settings;
            other.seed = 4;
            for (const auto& on : {card, device()}) {
                PathTracer waiting = tracerOn(on, volume, function, light, view, settings);
                const auto vertices = found(waiting, 2);
                const auto colours = waiting.readColours();
                ASSERT_TRUE(colours.ok());
                ASSERT_TRUE(waiting.setSettings(other).ok());
                const auto verticesOfOther = found(waiting, 1);
                PathTracer tracer = tracerOn(on, volume, function, light, view, settings);
                ASSERT_TRUE(tracer.addPrimaries(2).ok());
                ViewReading reading;
                ASSERT_TRUE(tracer.beginReading(reading, {.primaries = true, .colours = true}).ok());
                ASSERT_TRUE(tracer.setSettings(other).ok());
                ASSERT_TRUE(tracer.addPrimaries(1).ok());
                ViewReading next;
                ASSERT_TRUE(tracer.beginReading(next, {.primaries = true}).ok());
                ASSERT_TRUE(reading.finish().ok() && next.finish().ok());
                ASSERT_EQ(reading.primaries().size_bytes(), vertices.size() * sizeof(PrimaryVertex));
                EXPECT_EQ(std::memcmp(reading.primaries().data(), vertices.data(),
                                      reading.primaries().size_bytes()),
                          0);
                ASSERT_EQ(next.primaries().size(), verticesOfOther.size());
                EXPECT_EQ(std::memcmp(next.primaries().data(), verticesOfOther.data(),
                                      next.primaries().size_bytes()),
                          0);
                const TracedColours came = reading.colours();
                EXPECT_EQ(came.width, side);
                EXPECT_EQ(came.radiance, colours->radiance);
                EXPECT_EQ(came.samples, colours->samples);
                EXPECT_EQ(came.coverage, colours->coverage);
                EXPECT_EQ(came.meanSamples, 2.0);
            }
        }
    }
}

// Of a picture that takes more than one dispatch.
TEST_F(PrimariesTest, AreStoppedBetweenDispatches) {
    const glm::ivec3 size(24, 24, 24);
    const auto volume = scenes::volumeOf(size, scenes::grid(glm::dvec3(1.0), size), scenes::blob(size, 1000));
    const int side = device()->isCpu() ? 256 : 1024;
    PathTracer tracer =
        DeviceTest::tracer(volume, scenes::ramp(100, 500, 0.6, 1.0), Environment::constant(glm::vec3(1.0f)),
                           scenes::lookAt(*volume, 20.0, side), {});
    const auto stopped = tracer.tracePrimaries(2, [] { return false; });
    ASSERT_FALSE(stopped.ok());
    EXPECT_EQ(stopped.error().code, ErrorCode::cancelled);
    EXPECT_EQ(found(tracer, 1).size(), std::size_t(side) * std::size_t(side));
}

}  // namespace
}  // namespace macula::trace
