// Two volumes and coloured segments in one picture, on the device against the same maths in double.
#include <cmath>

#include "pipeline/trace/device_scene.h"
#include "trace/gpu_scene.h"
#include "trace/mixed_scenes.h"

namespace macula::trace {
namespace {

using MixtureOnDevice = DeviceTest;

const Environment kSky = Environment::constant(glm::vec3(1.0f));
constexpr int kPixels = 48;

class Phantom {
  public:
    Phantom() : scene(scenes::mixedPhantom(kPixels)), medium(scenes::mediumOf(scene)) {}

    ReferenceTracer reference() const {
        return ReferenceTracer(*scene.volume, medium, kSky, nullptr, scene.additions);
    }
    shared::TraceParams params(const Settings& settings) const {
        return *makeTraceParams(*scene.volume, medium, kSky, scene.view, settings, {}, scene.additions);
    }

    scenes::MixedScene scene;
    Medium medium;
};

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

// Of the box around points.
double extentMm(const std::vector<glm::dvec3>& points) {
    glm::dvec3 low = points.at(0);
    glm::dvec3 high = low;
    for (const glm::dvec3& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    return glm::length(high - low);
}

TEST_F(MixtureOnDevice, PathsAndRaysGiveThePictureOfTheReference) {
    const Phantom phantom;
    constexpr std::uint32_t kSamples = 8;
    for (const Look look : {Look::cinematic, Look::dvr}) {
        const Settings settings{.bounces = 4, .seed = 21, .look = look};
        PathTracer t =
            tracer(phantom.scene.volume, phantom.scene.function, kSky, phantom.scene.view, settings);
        ASSERT_TRUE(t.trace(kSamples).ok());
        const glm::dvec4 alone = meanOf(*t.readback());
        ASSERT_TRUE(t.scene().setAdditions(phantom.scene.additions).ok());
        ASSERT_TRUE(t.trace(kSamples).ok());
        const glm::dvec4 found = meanOf(*t.readback());
        const auto params = phantom.params(settings);
        const auto sums =
            look == Look::dvr
                ? phantom.reference().cast(params, {}, Precision::twofold, 0, kSamples)
                : phantom.reference().trace(params, Filter::trilinear, Precision::twofold, 0, kSamples);
        const glm::dvec4 expected = meanOf(sums, kSamples);
        // The same samples: what differs is where rounding decides.
        for (int channel = 0; channel < 4; ++channel)
            EXPECT_NEAR(found[channel], expected[channel], 0.02 * expected[channel])
                << int(look) << ' ' << channel;
        EXPECT_GT(found.w, 1.05 * alone.w);
        const auto statistics = t.statistics();
        ASSERT_TRUE(statistics.ok());
        EXPECT_EQ(statistics->nonFiniteSamples, 0u);
        EXPECT_EQ(statistics->collisionsAboveBound, 0u);

        // Without them it is the picture of before, to the last bit.
        ASSERT_TRUE(t.scene().setAdditions({}).ok());
        ASSERT_TRUE(t.trace(kSamples).ok());
        EXPECT_EQ(meanOf(*t.readback()), alone);
    }
}

TEST_F(MixtureOnDevice, GuidesAreThoseOfTheReference) {
    const Phantom phantom;
    PathTracer t = tracer(phantom.scene.volume, phantom.scene.function, kSky, phantom.scene.view, {});
    ASSERT_TRUE(t.scene().setAdditions(phantom.scene.additions).ok());
    const auto pixels = t.readGuides();
    ASSERT_TRUE(pixels.ok());
    const auto expected = phantom.reference().guides(
        phantom.params({}), *guidePush(phantom.scene.view, phantom.scene.view), Precision::twofold);
    ASSERT_EQ(pixels->size(), expected.size());
    int different = 0;
    int hits = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const GuidePixel& d = (*pixels)[i];
        const double off = std::abs(d.depthMm - expected[i].depthMm) +
                           std::abs(d.coverage - expected[i].coverage) +
                           glm::distance(glm::dvec3(d.albedo), expected[i].albedo) +
                           glm::distance(glm::dvec3(d.normal), expected[i].normal);
        EXPECT_TRUE(std::isfinite(off)) << i;
        if (!(off < 0.05)) ++different;
        if (expected[i].depthMm > 0) ++hits;
    }
    EXPECT_GT(hits, 200);
    EXPECT_LT(different, int(expected.size() / 50));
}

// What is seen by an eye, and what a view is framed around, has the second volume in it; projections have
// not.
TEST_F(MixtureOnDevice, WhatIsSeenIsOfBoth) {
    Phantom phantom;
    PathTracer t = tracer(phantom.scene.volume, phantom.scene.function, kSky, phantom.scene.view, {});
    const Box bones = *t.seenMm();
    const double outline = extentMm(*t.outlineMm());
    Additions soft = phantom.scene.additions;
    soft.tints.reset();
    ASSERT_TRUE(t.scene().setAdditions(soft).ok());
    const Box both = *t.seenMm();
    EXPECT_GT(glm::length(both.high - both.low), glm::length(bones.high - bones.low));
    EXPECT_GT(extentMm(*t.outlineMm()), outline + 10.0);

    ASSERT_TRUE(t.setSettings({.look = Look::mip}).ok());
    ASSERT_TRUE(t.trace(1).ok());
    const glm::dvec4 with = meanOf(*t.readback());
    ASSERT_TRUE(t.scene().setAdditions({}).ok());
    ASSERT_TRUE(t.trace(1).ok());
    EXPECT_EQ(meanOf(*t.readback()), with);
}

// Another colour or opacity of a segment is another table: bounds and voxels stay, and the picture is that of
// a tracer that never had other ones.
TEST_F(MixtureOnDevice, OtherColoursAreATableAlone) {
    const Phantom phantom;
    Additions other = phantom.scene.additions;
    other.tints->colours.front() = {.rgb = {0.9f, 0.1f, 0.7f}, .opacity = 0.1f};
    DeviceScene scene(device());
    ASSERT_TRUE(scene.setVolume(phantom.scene.volume).ok());
    ASSERT_TRUE(scene.setAdditions(phantom.scene.additions).ok());
    ASSERT_TRUE(scene.setTransferFunction(phantom.scene.function).ok());
    ASSERT_TRUE(scene.setEnvironment(kSky).ok());
    const float* const bounds = scene.bounds().data();
    const std::uint64_t edition = scene.edition();
    ASSERT_TRUE(scene.setAdditions(other).ok());
    EXPECT_TRUE(scene.isComplete());
    EXPECT_EQ(scene.bounds().data(), bounds) << "they were made anew";
    EXPECT_GT(scene.edition(), edition) << "pictures begin anew";
    other.second->secondFromVolumeMm[3].x += 5.0;
    ASSERT_TRUE(scene.setAdditions(other).ok());
    EXPECT_NE(scene.bounds().data(), bounds) << "the second volume lies elsewhere";
    other.second = phantom.scene.additions.second;

    const auto pictureOf = [&](PathTracer& t) {
        EXPECT_TRUE(t.trace(2).ok());
        return t.readback().value().radiance;
    };
    const auto fresh = [&](const Additions& additions) {
        PathTracer t = tracer(phantom.scene.volume, phantom.scene.function, kSky, phantom.scene.view, {});
        EXPECT_TRUE(t.scene().setAdditions(additions).ok());
        return pictureOf(t);
    };
    PathTracer t = tracer(phantom.scene.volume, phantom.scene.function, kSky, phantom.scene.view, {});
    ASSERT_TRUE(t.scene().setAdditions(phantom.scene.additions).ok());
    const auto before = pictureOf(t);
    ASSERT_TRUE(t.scene().setAdditions(other).ok());
    const auto after = pictureOf(t);
    EXPECT_NE(after, before);
    EXPECT_EQ(after, fresh(other));
    // Segments that come and go change no bounds either.
    other.tints.reset();
    ASSERT_TRUE(t.scene().setAdditions(other).ok());
    EXPECT_EQ(pictureOf(t), fresh(other));
    ASSERT_TRUE(t.scene().setAdditions(phantom.scene.additions).ok());
    EXPECT_EQ(pictureOf(t), before);
}

// Colours are of a volume: another one, of another size, has none until they are set for it.
TEST_F(MixtureOnDevice, AnotherVolumeHasNoColoursOfTheLastOne) {
    const Phantom phantom;
    PathTracer t = tracer(phantom.scene.volume, phantom.scene.function, kSky, phantom.scene.view, {});
    ASSERT_TRUE(t.scene().setAdditions(phantom.scene.additions).ok());
    const auto slab = scenes::slab(10.0, kPixels);
    ASSERT_TRUE(t.scene().setVolume(slab.volume).ok());
    ASSERT_TRUE(t.scene().setTransferFunction(scenes::homogeneous(0.2)).ok());
    ASSERT_TRUE(t.trace(1).ok());
    EXPECT_FALSE(t.scene().setAdditions(phantom.scene.additions).ok());
    ASSERT_TRUE(t.scene().setAdditions({}).ok());
    ASSERT_TRUE(t.trace(1).ok());
}

}  // namespace
}  // namespace macula::trace
