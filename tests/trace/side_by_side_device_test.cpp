// Samples of a pixel that are traced side by side: the same samples and the same sums, however many there
// are.
#include <algorithm>
#include <cmath>

#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"
#include "trace/small_scenes.h"

namespace macula::trace {
namespace {

class SideBySideOnDevice : public DeviceTest {
  protected:
    // Side by side, only shaders trace.
    static PathTracer tracer(const std::shared_ptr<const Volume>& volume, const TransferFunction& function,
                             const Environment& environment, const View& view, const Settings& settings) {
        return tracerOn(deviceOfShaders(), volume, function, environment, view, settings);
    }
    static PathTracer tracerOf(const scenes::SmallScene& scene, std::uint32_t seed) {
        PathTracer made = tracer(scene.volume, scene.function, scene.environment(), scene.view,
                                 scene.settings(Look::cinematic, Filter::trilinear, seed));
        EXPECT_TRUE(made.scene().setClip(scene.clip).ok());
        return made;
    }
    static TracedImage picture(PathTracer& t, std::uint32_t sideBySide, std::uint32_t samples) {
        t.setSideBySide(sideBySide);
        const auto traced = t.trace(samples);
        EXPECT_TRUE(traced.ok() && *traced);
        auto image = t.readback();
        EXPECT_TRUE(image.ok());
        EXPECT_EQ(t.statistics()->abandonedSamples, 0u);
        return std::move(image).value();
    }

    static void expectSameBits(const TracedImage& a, const TracedImage& b) {
        EXPECT_EQ(a.samples, b.samples);
        EXPECT_EQ(a.radiance, b.radiance);
        EXPECT_EQ(a.variance, b.variance);
    }

    // One kernel and another may round differently, and send a few paths elsewhere.
    static void expectAlike(const TracedImage& a, const TracedImage& b) {
        EXPECT_EQ(a.samples, b.samples);
        ASSERT_EQ(a.radiance.size(), b.radiance.size());
        std::size_t different = 0;
        for (std::size_t i = 0; i < a.radiance.size(); ++i) {
            const double size = glm::length(glm::dvec4(a.radiance[i]));
            if (glm::length(glm::dvec4(a.radiance[i]) - glm::dvec4(b.radiance[i])) > 1e-5 * (1.0 + size))
                ++different;
        }
        EXPECT_LE(different, a.radiance.size() / 50);
    }
};

// 7 samples are no multiple of 2, 4 or 16, and are two rows of 4, or 7 threads.
TEST_F(SideBySideOnDevice, ThePictureDoesNotDependOnHowManyThereAre) {
    const std::vector<scenes::SmallScene> scenes = scenes::smallScenes();
    for (const std::size_t which : {0, 1, 3, 7}) {  // even light, long paths, a clip, a foveated view
        const scenes::SmallScene& scene = scenes.at(which);
        SCOPED_TRACE(scene.name);
        PathTracer t = tracerOf(scene, 5);
        const TracedImage usual = picture(t, 0, 7);
        const TracedImage one = picture(t, 1, 7);
        expectAlike(one, usual);
        EXPECT_GT(std::count_if(one.radiance.begin(), one.radiance.end(),
                                [](const glm::vec4& pixel) { return pixel.w > 0.0f; }),
                  10);
        for (const std::uint32_t sideBySide : {2u, 4u, 16u}) {
            SCOPED_TRACE(sideBySide);
            expectSameBits(picture(t, sideBySide, 7), one);
        }
    }
}

TEST_F(SideBySideOnDevice, NorOnPortionsAndTurns) {
    const scenes::SmallScene scene = scenes::smallScenes().front();
    PathTracer t = tracerOf(scene, 5);
    const TracedImage whole = picture(t, 4, 12);
    expectSameBits(picture(t, 4, 12), whole);  // once more from the beginning
    t.setSideBySide(4);
    for (const std::uint32_t samples : {1u, 3u, 8u}) ASSERT_TRUE(*t.trace(samples));
    const auto portions = t.readback();
    ASSERT_TRUE(portions.ok());
    expectSameBits(*portions, whole);
    PathTracer other = tracerOf(scene, 6);
    EXPECT_NE(picture(other, 4, 12).radiance, whole.radiance) << "another seed";
}

TEST_F(SideBySideOnDevice, OfOnePixelAndOfPicturesThatAreNoWholeBlocks) {
    scenes::SmallScene scene = scenes::smallScenes().front();
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(9, 1), glm::ivec2(7, 17)}) {
        SCOPED_TRACE(size.x);
        scene.view.width = size.x;
        scene.view.height = size.y;
        PathTracer t = tracerOf(scene, 3);
        const TracedImage usual = picture(t, 0, 5);
        ASSERT_EQ(usual.radiance.size(), std::size_t(size.x) * std::size_t(size.y));
        const TracedImage one = picture(t, 1, 5);
        EXPECT_EQ(one.samples, usual.samples);
        for (std::size_t i = 0; i < one.radiance.size(); ++i)
            EXPECT_LT(glm::length(one.radiance[i] - usual.radiance[i]), 0.05f) << i;
        expectSameBits(picture(t, 4, 5), one);
    }
}

TEST_F(SideBySideOnDevice, OfNothing) {
    scenes::SmallScene scene = scenes::smallScenes().front();
    scene.view.camera.targetMm = 2.0 * scene.view.camera.positionMm - scene.view.camera.targetMm;  // away
    PathTracer t = tracerOf(scene, 3);
    const TracedImage image = picture(t, 4, 6);
    for (std::size_t i = 0; i < image.radiance.size(); ++i) {
        ASSERT_EQ(image.radiance[i], glm::vec4(0.0f)) << i;
        ASSERT_EQ(image.samples[i], 6u) << i;
    }
    EXPECT_EQ(t.statistics()->nonFiniteSamples, 0u);
}

// Where noise decides, each block has another number of samples.
TEST_F(SideBySideOnDevice, WhereNoiseDecidesEachPixelHasTheSamplesOfItsBlock) {
    scenes::SmallScene scene = scenes::smallScenes().front();
    scene.view.width = 64;
    scene.view.height = 64;
    PathTracer t = tracerOf(scene, 3);
    t.setSideBySide(4);
    for (bool whole = false; !whole || t.statistics()->meanSamplesPerPixel < 40.0;) {
        const auto traced = t.traceFor(0.0);
        ASSERT_TRUE(traced.ok());
        whole = *traced;
    }
    const auto image = t.readback();
    ASSERT_TRUE(image.ok());
    double sum = 0.0;
    for (std::size_t i = 0; i < image->samples.size(); ++i) {
        const std::size_t first = i / 64 / 8 * 8 * 64 + i % 64 / 8 * 8;  // of the block
        ASSERT_EQ(image->samples[i], image->samples[first]) << i;
        sum += image->samples[i];
    }
    const auto [least, most] = std::minmax_element(image->samples.begin(), image->samples.end());
    EXPECT_LT(*least, *most);
    EXPECT_DOUBLE_EQ(sum / double(image->samples.size()), t.statistics()->meanSamplesPerPixel);
    const TracedImage even = picture(t, 4, 40);
    glm::dvec4 adaptiveMean(0.0);
    glm::dvec4 evenMean(0.0);
    for (std::size_t i = 0; i < even.radiance.size(); ++i) {
        adaptiveMean += glm::dvec4(image->radiance[i]) / double(even.radiance.size());
        evenMean += glm::dvec4(even.radiance[i]) / double(even.radiance.size());
    }
    EXPECT_LT(glm::length(adaptiveMean - evenMean), 0.02 * glm::length(evenMean));
}

TEST_F(SideBySideOnDevice, SamplesThatAreNoNumberAreLeftOutAndCountedAlike) {
    for (const scenes::ExtremeScene& scene : scenes::extremeScenes()) {
        SCOPED_TRACE(scene.name);
        PathTracer t = tracer(scene.volume, scene.function, scene.environment, scene.view, {.seed = 3});
        ASSERT_TRUE(*t.trace(3));
        const auto usual = t.readback();
        const auto before = t.statistics();
        t.setSideBySide(2);
        ASSERT_TRUE(*t.trace(3));
        const auto image = t.readback();
        ASSERT_TRUE(usual.ok() && image.ok() && before.ok());
        expectAlike(*image, *usual);
        EXPECT_EQ(t.statistics()->nonFiniteSamples, before->nonFiniteSamples);
        EXPECT_EQ(t.statistics()->abandonedSamples, before->abandonedSamples);
    }
}

// Looks without chance, and paths that tell their first vertices, have kernels of their own.
TEST_F(SideBySideOnDevice, OtherLooksAreWhatTheyWere) {
    const scenes::SmallScene scene = scenes::smallScenes().front();
    PathTracer t = tracerOf(scene, 5);
    ASSERT_TRUE(t.setSettings(scene.settings(Look::dvr, Filter::trilinear, 5)).ok());
    const TracedImage usual = picture(t, 0, 3);
    expectSameBits(picture(t, 4, 3), usual);
    ASSERT_TRUE(t.setSettings(scene.settings(Look::cinematic, Filter::trilinear, 5)).ok());
    t.setSideBySide(4);
    const auto vertices = t.tracePrimaries(2);
    ASSERT_TRUE(vertices.ok());
    EXPECT_EQ(vertices->size(), 2u * scenes::kSmallPixels * scenes::kSmallPixels);
    ASSERT_TRUE(*t.trace(3));  // goes on with the same picture
    const auto mixed = t.readback();
    ASSERT_TRUE(mixed.ok());
    expectAlike(*mixed, picture(t, 4, 5));
}

}  // namespace
}  // namespace macula::trace
