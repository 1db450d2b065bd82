// Curves of steep matter on the device, against the same maths in double, and at the extremes.
#include <cmath>
#include <limits>

#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/gpu_scene.h"
#include "trace/small_scenes.h"

namespace macula::trace {
namespace {

using SteepOnDevice = DeviceTest;

const Environment kSky = Environment::constant(glm::vec3(1.0f));
constexpr std::uint32_t kSamples = 16;

// Those of smallScenes() that have such curves: of other opacities, and of other colours alone.
std::vector<scenes::SmallScene> steepScenes() {
    std::vector<scenes::SmallScene> steep;
    for (const scenes::SmallScene& scene : scenes::smallScenes())
        if (usesSteepCurves(scene.function)) steep.push_back(scene);
    return steep;
}

glm::dvec4 meanOf(const std::vector<glm::dvec4>& sums, double samples) {
    glm::dvec4 mean(0.0);
    for (const glm::dvec4& sum : sums) mean += sum / (samples * double(sums.size()));
    return mean;
}

glm::dvec4 meanOf(const TracedImage& image) {
    glm::dvec4 mean(0.0);
    for (const glm::vec4& pixel : image.radiance) mean += glm::dvec4(pixel) / double(image.radiance.size());
    return mean;
}

ReferenceTracer referenceOf(const scenes::SmallScene& scene, Filter filter, Medium& medium) {
    medium = makeMedium(*scene.volume, makeBrickGrid(*scene.volume, reachOf(filter)), scene.function);
    return ReferenceTracer(*scene.volume, medium, kSky);
}

TEST_F(SteepOnDevice, PathsGiveThePictureOfTheReference) {
    const auto scenes = steepScenes();
    ASSERT_EQ(scenes.size(), 2u);
    for (const scenes::SmallScene& scene : scenes) {
        for (const Filter filter : kFilters) {
            const Settings settings{.bounces = 4, .seed = 5, .filter = filter, .look = Look::cinematic};
            PathTracer t = tracer(scene.volume, scene.function, kSky, scene.view, settings);
            ASSERT_TRUE(t.trace(kSamples).ok());
            const glm::dvec4 found = meanOf(*t.readback());
            Medium medium;
            const ReferenceTracer reference = referenceOf(scene, filter, medium);
            const auto params = *makeTraceParams(*scene.volume, medium, kSky, scene.view, settings);
            const glm::dvec4 expected =
                meanOf(reference.trace(params, filter, Precision::twofold, 0, kSamples), kSamples);
            // The same samples: what differs is where rounding decides.
            for (int channel = 0; channel < 4; ++channel)
                EXPECT_NEAR(found[channel], expected[channel], 0.02 * expected[channel])
                    << scene.name << ' ' << int(filter) << ' ' << channel;
            const auto statistics = t.statistics();
            ASSERT_TRUE(statistics.ok());
            EXPECT_EQ(statistics->nonFiniteSamples, 0u);
            EXPECT_EQ(statistics->collisionsAboveBound, 0u);

            TransferFunction flat = scene.function;
            flat.steep = {};
            ASSERT_TRUE(t.scene().setTransferFunction(flat).ok());
            ASSERT_TRUE(t.trace(kSamples).ok());
            EXPECT_GT(glm::length(meanOf(*t.readback()) - found), 0.03) << scene.name;
        }
    }
}

TEST_F(SteepOnDevice, RaysGiveThePictureOfTheReference) {
    for (const scenes::SmallScene& scene : steepScenes()) {
        for (const Shading shading : {Shading::none, Shading::headlight}) {
            const Settings settings{.seed = 5, .look = Look::dvr, .shading = shading};
            PathTracer t = tracer(scene.volume, scene.function, kSky, scene.view, settings);
            ASSERT_TRUE(t.trace(4).ok());
            const auto image = t.readback();
            ASSERT_TRUE(image.ok());
            Medium medium;
            const ReferenceTracer reference = referenceOf(scene, settings.filter, medium);
            const auto params = *makeTraceParams(*scene.volume, medium, kSky, scene.view, settings);
            const auto expected =
                reference.cast(params, {.shading = shading == Shading::headlight}, Precision::twofold, 0, 4);
            double worst = 0.0;
            for (std::size_t i = 0; i < expected.size(); ++i)
                worst = std::max(worst, glm::length(glm::dvec4(image->radiance[i]) - expected[i] / 4.0));
            EXPECT_LT(worst, 2e-3) << scene.name;
        }
    }
}

TEST_F(SteepOnDevice, GuidesAreThoseOfTheReference) {
    for (const scenes::SmallScene& scene : steepScenes()) {
        PathTracer t = tracer(scene.volume, scene.function, kSky, scene.view, {});
        const auto pixels = t.readGuides();
        ASSERT_TRUE(pixels.ok());
        Medium medium;
        const ReferenceTracer reference = referenceOf(scene, Settings{}.filter, medium);
        const auto params = *makeTraceParams(*scene.volume, medium, kSky, scene.view, {});
        const auto expected =
            reference.guides(params, *guidePush(scene.view, scene.view), Precision::twofold);
        ASSERT_EQ(pixels->size(), expected.size());
        int different = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const GuidePixel& d = (*pixels)[i];
            const double off = std::abs(d.coverage - expected[i].coverage) +
                               glm::distance(glm::dvec3(d.albedo), expected[i].albedo);
            EXPECT_TRUE(std::isfinite(off)) << i;
            if (!(off < 0.01)) ++different;
        }
        EXPECT_LT(different, int(expected.size() / 50)) << scene.name;
    }
}

// Steep curves that are those of flat matter change no number that is drawn: whatever is steep, the
// extinction and the colour are the same, and flights ask for no gradient.
TEST_F(SteepOnDevice, TheSameCurvesTwiceAreThePictureOfOnePair) {
    const scenes::SmallScene scene = scenes::smallScenes().front();
    TransferFunction twice = scene.function;
    twice.steep = {.opacity = twice.opacity, .colour = twice.colour, .gradientPerMm = 50.0};
    for (const Look look : {Look::cinematic, Look::dvr}) {
        const Settings settings{.bounces = 3, .seed = 9, .look = look};
        PathTracer one = tracer(scene.volume, scene.function, kSky, scene.view, settings);
        PathTracer two = tracer(scene.volume, twice, kSky, scene.view, settings);
        ASSERT_TRUE(one.trace(64).ok() && two.trace(64).ok());
        const glm::dvec4 a = meanOf(*one.readback());
        const glm::dvec4 b = meanOf(*two.readback());
        // Paths draw one more number at each vertex; rays take two steps in each cell, at least.
        EXPECT_LT(glm::length(a - b), look == Look::dvr ? 1e-3 : 0.01);
    }
}

// One voxel, no gradient anywhere, gradients of 65535 within a micrometre, and halves at both ends of what is
// allowed: pictures are finite and hold their bounds; with no gradient all matter is flat.
TEST_F(SteepOnDevice, ExtremesAreFiniteAndNoGradientIsFlat) {
    const auto flatVolume = scenes::volumeOf({9, 9, 9}, scenes::grid(glm::dvec3(1.0), {9, 9, 9}),
                                             [](int, int, int) { return std::uint16_t(700); });
    const auto one = scenes::volumeOf({1, 1, 1}, scenes::grid(glm::dvec3(9.0), {1, 1, 1}),
                                      [](int, int, int) { return std::uint16_t(700); });
    const auto steepest =
        scenes::volumeOf({9, 9, 9}, scenes::grid(glm::dvec3(1e-3), {9, 9, 9}),
                         [](int i, int j, int k) { return std::uint16_t((i + j + k) % 4 < 2 ? 65535 : 0); });
    for (const auto& volume : {flatVolume, one, steepest}) {
        for (const double half : {1e-6, 200.0, 1e6}) {
            TransferFunction function = scenes::ramp(0, 1000, 0.5, 1.0);
            function.steep = {
                .opacity = {{0, 0.999}}, .colour = {{0, {0.0, 0.0, 1.0}}}, .gradientPerMm = half};
            for (const Look look : {Look::cinematic, Look::dvr}) {
                const Settings settings{.bounces = 3, .seed = 2, .look = look};
                PathTracer t = tracer(volume, function, kSky, scenes::lookAt(*volume, 20.0, 8), settings);
                ASSERT_TRUE(t.trace(8).ok());
                const auto image = t.readback();
                ASSERT_TRUE(image.ok());
                for (const glm::vec4& pixel : image->radiance)
                    EXPECT_TRUE(std::isfinite(glm::dot(pixel, pixel)) && pixel.w <= 1.0f + 1e-5f);
                const auto statistics = t.statistics();
                EXPECT_EQ(statistics->nonFiniteSamples, 0u);
                EXPECT_EQ(statistics->collisionsAboveBound, 0u);
                if (volume == steepest) continue;
                TransferFunction flat = function;
                flat.steep = {};
                PathTracer plain = tracer(volume, flat, kSky, scenes::lookAt(*volume, 20.0, 8), settings);
                ASSERT_TRUE(plain.trace(8).ok());
                const double slack = look == Look::dvr ? 1e-3 : 0.05;  // of steps, of chance
                EXPECT_LT(glm::length(meanOf(*image) - meanOf(*plain.readback())), slack) << half;
            }
        }
    }
}

TEST_F(SteepOnDevice, CurvesThatMeanNothingAreRefused) {
    const scenes::SmallScene scene = steepScenes().front();
    PathTracer t = tracer(scene.volume, scene.function, kSky, scene.view, {});
    TransferFunction wrong = scene.function;
    wrong.steep.gradientPerMm = std::numeric_limits<double>::infinity();
    const auto refused = t.scene().setTransferFunction(wrong);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.english().find("gradient of steep matter"), std::string::npos);
    EXPECT_FALSE(refused.error().hint.empty());
}

}  // namespace
}  // namespace macula::trace
