// Samples where noise is, until there is little left: on the device, as users of the tracer meet it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/phantom.h"
#include "pipeline/gpu/transfer.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

std::shared_ptr<const Volume> smallPhantom() {
    static const auto volume =
        std::make_shared<const Volume>(phantom::make({.size = {96, 84, 60}, .spacingMm = {3.2, 3.2, 5.0}}));
    return volume;
}

TransferFunction bone() {
    TransferFunction function = scenes::homogeneous(1.0);
    function.opacity = {{150, 0.0}, {400, 0.8}};
    return function;
}

// Light that is soft, or comes from one lamp so small and strong that few samples meet it: fireflies.
Environment sky(bool fireflies) {
    LightRig rig;
    rig.ambientHorizon = {0.4, 0.4, 0.45};
    rig.lights = {{.azimuthDeg = 30,
                   .elevationDeg = 40,
                   .angularRadiusDeg = fireflies ? 3.0 : 15.0,
                   .colour = {1, 0.9, 0.8},
                   .radiance = fireflies ? 300.0 : 8.0}};
    return Environment::fromRig(rig);
}

View front(int size) {
    return {.camera = frameBox(smallPhantom()->worldBox(), ViewDirection::anterior, 30, 1.0),
            .width = size,
            .height = size};
}

class Adaptive : public DeviceTest {
  protected:
    static constexpr int kTruthSize = 40;
    // Of what is compared with the truth: more bounces take longer, and tell no more.
    static Settings compared(std::uint32_t seed) { return {.bounces = 4, .seed = seed}; }

    // A dispatch at a time to the end of a pass, so that the picture does not depend on the machine.
    static void traceAbout(PathTracer& t, double samples) {
        for (bool whole = false; !whole || t.statistics()->meanSamplesPerPixel < samples;) {
            const auto traced = t.traceFor(0.0);
            ASSERT_TRUE(traced.ok());
            whole = *traced;
        }
    }
    static PathTracer phantomTracer(int size, const Settings& settings, bool fireflies = false) {
        return tracer(smallPhantom(), bone(), sky(fireflies), front(size), settings);
    }
    // As it is shown, after so many samples that chance is little of it; for the tests of the program.
    static const std::vector<std::uint8_t>& truth(bool fireflies) {
        static std::map<bool, std::vector<std::uint8_t>> made;
        auto& shown = made[fireflies];
        if (!shown.empty()) return shown;
        PathTracer converged = phantomTracer(kTruthSize, compared(1), fireflies);
        EXPECT_TRUE(*converged.trace(1024));
        shown = *converged.readDisplay(glm::vec3(0.0f));
        return shown;
    }
    // The mean of all pixels.
    static double lightOf(PathTracer& t) {
        const auto image = t.readback();
        double sum = 0.0;
        for (const glm::vec4& pixel : image->radiance) sum += double(pixel.r) + pixel.g + pixel.b;
        return sum / double(image->radiance.size());
    }
    // Display-encoded values of black to white, over the blocks that show something.
    static double errorOf(PathTracer& t, bool fireflies) {
        constexpr int size = kTruthSize;
        const std::vector<std::uint8_t>& right = truth(fireflies);
        const auto shown = *t.readDisplay(glm::vec3(0.0f));
        const auto image = t.readback();
        std::set<int> seen;
        for (int i = 0; i < size * size; ++i) {
            if (image->radiance[std::size_t(i)].a > 0.0f) seen.insert(i / size / 8 * size + i % size / 8);
        }
        double squares = 0.0;
        double count = 0.0;
        for (int i = 0; i < size * size; ++i) {
            if (!seen.contains(i / size / 8 * size + i % size / 8)) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                const double d =
                    (double(shown[4 * std::size_t(i) + c]) - right[4 * std::size_t(i) + c]) / 255.0;
                squares += d * d;
                count += 1.0;
            }
        }
        return std::sqrt(squares / count);
    }
    // Of few samples and of many.
    static void expectHonestEstimates(bool fireflies) {
        PathTracer t = phantomTracer(kTruthSize, {}, fireflies);
        for (const std::uint32_t count : {4u, 8u, 32u}) {
            ASSERT_TRUE(t.setSettings(compared(2)).ok());
            ASSERT_TRUE(*t.trace(count));
            const double ratio = t.estimateError()->rms / errorOf(t, fireflies);
            EXPECT_NEAR(std::log(ratio), 0.0, std::log(1.25)) << fireflies << " " << count;
            RecordProperty((fireflies ? "fireflies" : "soft") + std::to_string(count), std::to_string(ratio));
        }
        ASSERT_TRUE(t.setSettings(compared(3)).ok());
        traceAbout(t, 24.0);
        const double ratio = t.estimateError()->rms / errorOf(t, fireflies);
        EXPECT_NEAR(std::log(ratio), 0.0, std::log(1.25)) << fireflies;
        RecordProperty(fireflies ? "firefliesAdaptive" : "softAdaptive", std::to_string(ratio));
    }
};

// No sample is drawn twice and none is left out, however the passes went.
TEST_F(Adaptive, EachPixelHasTheFirstOfItsSamples) {
    constexpr int kSize = 60;  // blocks are cut at two sides
    PathTracer t = phantomTracer(kSize, {.seed = 9});
    traceAbout(t, 14.0);
    const auto image = t.readback();
    std::map<std::uint32_t, int> pixels;
    for (const std::uint32_t count : image->samples) ++pixels[count];
    ASSERT_GT(pixels.size(), 3u);
    EXPECT_EQ(t.statistics()->samplesPerPixel, pixels.begin()->first);
    EXPECT_LT(pixels.begin()->first, 14u);
    EXPECT_GT(pixels.rbegin()->first, 14u);
    double sum = 0.0;
    for (const auto& [count, number] : pixels) sum += double(count) * number;
    EXPECT_NEAR(t.statistics()->meanSamplesPerPixel, sum / (kSize * kSize), 1e-9);

    PathTracer even = phantomTracer(kSize, {.seed = 9});
    std::uint32_t done = 0;
    int compared = 0;
    for (const auto& [count, number] : pixels) {
        ASSERT_TRUE(*even.trace(count - done));
        done = count;
        const auto expected = even.readback();
        for (std::size_t i = 0; i < image->samples.size(); ++i) {
            if (image->samples[i] != count) continue;
            ++compared;
            ASSERT_LT(glm::length(image->radiance[i] - expected->radiance[i]), 1e-5f) << i;
            ASSERT_LE(glm::length(image->variance[i] - expected->variance[i]),
                      1e-5f + 1e-3f * glm::length(expected->variance[i]));
        }
    }
    EXPECT_EQ(compared, kSize * kSize);

    // And then exactly as many more as are asked for, for every pixel; what was planned is dropped.
    ASSERT_TRUE(t.traceFor(0.0).ok());
    const auto before = t.readback()->samples;
    ASSERT_TRUE(*t.trace(3));
    const auto after = t.readback()->samples;
    for (std::size_t i = 0; i < before.size(); ++i) ASSERT_EQ(after[i], before[i] + 3);
}

// The more noise, the more samples; and with as many in all, less error than even ones have.
TEST_F(Adaptive, SamplesFollowNoiseAndAreWorthMore) {
    constexpr std::uint32_t kPictures = 6;
    double adaptive = 0.0;  // mean squares
    double even = 0.0;
    PathTracer t = phantomTracer(kTruthSize, {});
    for (std::uint32_t i = 0; i < kPictures; ++i) {
        ASSERT_TRUE(t.setSettings(compared(2 + i)).ok());
        traceAbout(t, 32.0);
        const double mean = t.statistics()->meanSamplesPerPixel;
        const auto samples = t.readback()->samples;
        EXPECT_LT(double(*std::min_element(samples.begin(), samples.end())), 0.75 * mean);
        EXPECT_GT(double(*std::max_element(samples.begin(), samples.end())), 1.25 * mean);
        adaptive += std::pow(errorOf(t, false), 2) / kPictures;
        ASSERT_TRUE(t.setSettings(compared(102 + i)).ok());
        ASSERT_TRUE(*t.trace(std::uint32_t(std::ceil(mean))));
        even += std::pow(errorOf(t, false), 2) / kPictures;
    }
    EXPECT_LT(std::sqrt(adaptive), 0.95 * std::sqrt(even));
    RecordProperty("adaptiveError", std::to_string(std::sqrt(adaptive)));
    RecordProperty("evenError", std::to_string(std::sqrt(even)));
    expectHonestEstimates(false);  // the truth is at hand
}

// The first samples of a pixel decide how many it gets, so its mean may be biased. This test sees a bias of 1
// % of the light. Pictures are compared with even ones of the same seed, of which they share samples.
TEST_F(Adaptive, MeansAreAsBrightAsEvenOnes) {
    constexpr std::uint32_t kPictures = 24;
    for (const bool fireflies : {false, true}) {
        PathTracer t = phantomTracer(kTruthSize, {}, fireflies);
        std::vector<double> differences;
        double light = 0.0;
        for (std::uint32_t i = 0; i < kPictures; ++i) {
            ASSERT_TRUE(t.setSettings(compared(1000 + i)).ok());
            traceAbout(t, 20.0);
            const auto samples = t.readback()->samples;
            EXPECT_NE(*std::min_element(samples.begin(), samples.end()),
                      *std::max_element(samples.begin(), samples.end()));
            const double adaptive = lightOf(t);
            ASSERT_TRUE(t.setSettings(compared(1000 + i)).ok());
            ASSERT_TRUE(*t.trace(40));
            differences.push_back(adaptive - lightOf(t));
            light += lightOf(t) / kPictures;
        }
        double mean = 0.0;
        for (const double d : differences) mean += d / kPictures;
        double squares = 0.0;
        for (const double d : differences) squares += (d - mean) * (d - mean);
        const double error = std::sqrt(squares / (kPictures - 1) / kPictures);
        EXPECT_LT(error, 0.0025 * light) << "too few pictures to tell";
        EXPECT_NEAR(mean, 0.0, 4.0 * error) << fireflies;
        RecordProperty(fireflies ? "firefliesBias" : "softBias", std::to_string(mean / light));
        RecordProperty(fireflies ? "firefliesError" : "softError", std::to_string(error / light));
    }
}

// What is said of the error is true: of fireflies; of soft light, see above.
TEST_F(Adaptive, TheEstimateIsHonest) {
    expectHonestEstimates(true);
}

TEST_F(Adaptive, StopsWhenItHasConvergedAndGoesOnWhenMoreIsAsked) {
    Settings settings{.seed = 4, .errorThreshold = 0.05};
    PathTracer t = phantomTracer(48, settings);
    EXPECT_FALSE(t.statistics()->converged);
    ASSERT_TRUE(*t.traceFor(kForever));
    const Statistics coarse = *t.statistics();
    EXPECT_TRUE(coarse.converged);
    EXPECT_LE(coarse.estimatedError, 0.05);
    EXPECT_GE(coarse.samplesPerPixel, 8u);
    ASSERT_TRUE(*t.traceFor(kForever));  // nothing is left to do
    EXPECT_EQ(t.statistics()->meanSamplesPerPixel, coarse.meanSamplesPerPixel);

    settings.errorThreshold = 0.025;
    ASSERT_TRUE(t.setSettings(settings).ok());
    EXPECT_FALSE(t.statistics()->converged);
    EXPECT_EQ(t.statistics()->meanSamplesPerPixel, coarse.meanSamplesPerPixel) << "began again";
    ASSERT_TRUE(*t.traceFor(kForever));
    const Statistics fine = *t.statistics();
    EXPECT_TRUE(fine.converged);
    EXPECT_LE(fine.estimatedError, 0.025);
    // A quarter of the variance takes four times the samples, but for the whole passes.
    EXPECT_GT(fine.meanSamplesPerPixel, 2.0 * coarse.meanSamplesPerPixel);
    EXPECT_LT(fine.meanSamplesPerPixel, 12.0 * coarse.meanSamplesPerPixel);
    ASSERT_TRUE(t.setView(front(40)).ok());
    EXPECT_FALSE(t.statistics()->converged);
    EXPECT_EQ(t.statistics()->estimatedError, kForever);
}

// Without chance there is nothing to adapt to.
TEST_F(Adaptive, WhatIsCastStaysEvenAndConvergesToo) {
    for (const Look look : {Look::dvr, Look::mip}) {
        PathTracer t = phantomTracer(48, {.look = look, .errorThreshold = 0.02});
        ASSERT_TRUE(*t.traceFor(kForever));
        EXPECT_TRUE(t.statistics()->converged);
        EXPECT_EQ(t.statistics()->meanSamplesPerPixel, double(t.statistics()->samplesPerPixel));
        EXPECT_LT(t.statistics()->samplesPerPixel, 300u);
    }
}

// Black matter in the dark has no light that could be noisy: what is left is that of its coverage, before a
// backdrop of middle grey.
TEST_F(Adaptive, CoverageIsNoisyBeforeMiddleGrey) {
    constexpr std::uint32_t kSamples = 64;
    const auto [volume, view] = scenes::slab(10.0, 32);
    PathTracer t = tracer(volume, scenes::homogeneous(0.05, 0.0), Environment::constant(glm::vec3(0.0f)),
                          view, {.seed = 3});
    ASSERT_TRUE(*t.trace(kSamples));
    const double covered = -std::expm1(-0.5);
    const double standardError = 0.18 * std::sqrt(covered * (1.0 - covered) / kSamples);
    // Khronos' neutral tone map takes x - 6.25 x^2 away from dark x; what is left is dark to sRGB, too, or
    // not.
    const double mapped = 6.25 * standardError * standardError;
    const double shown = mapped <= 0.0031308 ? 12.92 * mapped : 1.055 * std::pow(mapped, 1.0 / 2.4) - 0.055;
    EXPECT_NEAR(t.estimateError()->rms, 0.5 * shown, 0.1 * 0.5 * shown);
}

TEST_F(Adaptive, NothingVisibleConvergesAtOnce) {
    const auto volume = scenes::volumeOf({1, 1, 1}, glm::dmat4(1.0), [](int, int, int) { return 0; });
    PathTracer t = tracer(
        volume, scenes::homogeneous(1.0), Environment::constant(glm::vec3(1.0f)),
        {.camera = frameBox(volume->worldBox(), ViewDirection::anterior, 30, 1.0), .width = 9, .height = 1},
        {.errorThreshold = 1e-6});
    ASSERT_TRUE(*t.traceFor(kForever));
    EXPECT_TRUE(t.statistics()->converged);
    EXPECT_EQ(t.statistics()->samplesPerPixel, 8u);
    EXPECT_EQ(t.statistics()->estimatedError, 0.0);
}

// What is filtered is the film as it is, in the middle of a pass too.
TEST_F(Adaptive, DenoisingSeesEverySample) {
    PathTracer t = phantomTracer(48, {.seed = 5, .denoising = Denoising::on});
    traceAbout(t, 12.0);
    const auto before = t.readback();
    EXPECT_EQ(t.readback()->radiance, before->radiance);
    while (t.readback()->samples == before->samples) ASSERT_TRUE(t.traceFor(0.0).ok());
    const auto after = t.readback();
    EXPECT_TRUE(after->denoised);
    EXPECT_NE(after->radiance, before->radiance);
}

// Whoever lets go of a picture waits for one dispatch: where paths are as long as they can be, where the
// picture is large, and when the kernel has to be compiled first. How short it is, is for Pace.
TEST_F(Adaptive, IsCancelledAfterOneDispatch) {
    TransferFunction dense = scenes::homogeneous(1.0);
    dense.opacity = {{-50, 0.0}, {0, 0.0}, {300, 0.9}};
    dense.density = 20.0;
    PathTracer t = tracer(smallPhantom(), dense, sky(false), front(1024), {.bounces = kMaxBounces});
    const int asked = device()->isCpu() ? 12 : 3;  // a card is done with a pass after a few
    for (const bool budget : {false, true}) {
        int times = 0;
        double samples = t.statistics()->meanSamplesPerPixel;
        const auto keepGoing = [&] {
            const double now = t.statistics()->meanSamplesPerPixel;
            if (times > 0) {
                EXPECT_GT(now, samples);
            }
            samples = now;
            return ++times < asked;
        };
        const auto traced = budget ? t.traceFor(kForever, keepGoing) : t.trace(1000, keepGoing);
        ASSERT_TRUE(traced.ok());
        EXPECT_FALSE(*traced);
        EXPECT_EQ(times, asked) << "one dispatch for each question";
        EXPECT_EQ(t.statistics()->meanSamplesPerPixel, samples) << "and none after the last";
    }
}

}  // namespace
}  // namespace macula::trace
