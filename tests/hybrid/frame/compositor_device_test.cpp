// Splats and a traced picture as one: held to the same in double, and at the extremes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "gpu/shared_layout.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/hybrid/frame/compositor.h"
#include "pipeline/hybrid/frame/texel_room.h"
#include "shader/shader_lib.h"
#include "shaders/hybrid.h"
#include "shared/compose_params.h"
#include "trace/gpu_scene.h"

namespace macula::hybrid {
namespace {

constexpr glm::ivec2 kSize{37, 21};
constexpr std::size_t kPixels = 37 * 21;
constexpr double kGain = 0.75;
// Half a step of 255 and what a power is off by: 0.01 on lavapipe, 0.054 on an H100.
constexpr double kRounding = 0.5 + 0.08;

class CompositorTest : public trace::DeviceTest {
  protected:
    std::mt19937 random_{5};

    std::vector<glm::vec4> premultiplied(float brightest) {
        std::uniform_real_distribution<float> share(0.0f, 1.0f);
        std::vector<glm::vec4> pixels(kPixels);
        for (glm::vec4& p : pixels) {
            p.w = share(random_);
            for (int k = 0; k < 3; ++k) p[k] = p.w * brightest * share(random_);
        }
        return pixels;
    }
    struct OnDevice {
        splat::DevicePicture splats;
        gpu::Buffer traced;
        gpu::Buffer counts;
    };
    OnDevice upload(const std::vector<glm::vec4>& splats, const std::vector<glm::vec4>& traced,
                    const std::vector<std::uint32_t>& counts) {
        OnDevice result{
            .splats = std::move(*splat::DevicePicture::upload(device(), "splats", kSize.x, kSize.y, splats)),
            .traced = std::move(*gpu::Buffer::create(device(), {.bytes = kPixels * sizeof(glm::vec4)})),
            .counts = std::move(*gpu::Buffer::create(device(), {.bytes = kPixels * 4}))};
        EXPECT_TRUE(gpu::uploadTo<glm::vec4>(result.traced, traced).ok());
        EXPECT_TRUE(gpu::uploadTo<std::uint32_t>(result.counts, counts).ok());
        return result;
    }
    std::vector<glm::u8vec4> composed(const OnDevice& on, float share, bool areMeans,
                                      const Display& display) {
        auto compositor = Compositor::create(device());
        const trace::TracedLight light{.values = &on.traced, .counts = &on.counts, .areMeans = areMeans};
        const auto picture = compositor->compose({.splats = share < 1.0f ? &on.splats : nullptr,
                                                  .traced = share > 0.0f ? &light : nullptr,
                                                  .sizePx = kSize,
                                                  .splatGain = float(kGain),
                                                  .tracedShare = share},
                                                 display);
        EXPECT_TRUE(picture.ok());
        return gpu::read<glm::u8vec4>(**picture).value();
    }
    static glm::dvec3 expected(const glm::dvec4& light, const Display& display) {
        ShaderLibTwofold lib;
        return lib.displayColour(light, glm::dvec3(display.background), double(display.exposure),
                                 display.toneMap == trace::ToneMap::hue);
    }
};

TEST(ComposeLayout, PushConstantsAgree) {
    using shared::ComposePush;
    const auto compose = gpu::reflectSpirv(shaders::hybrid_compose_comp.words);
    ASSERT_TRUE(compose.ok());
    expectLayoutMatches<ComposePush>(
        *compose->pushConstants->block.find("push"),
        {MACULA_FIELD(ComposePush, background), MACULA_FIELD(ComposePush, exposure),
         MACULA_FIELD(ComposePush, splatGain), MACULA_FIELD(ComposePush, tracedShare),
         MACULA_FIELD(ComposePush, tracedAreMeans), MACULA_FIELD(ComposePush, keepsHue)});
}

TEST_F(CompositorTest, MixesAsLightAndShowsAsTheTracerDoes) {
    for (const float brightest : {0.01f, 1.0f, 300.0f}) {
        const auto splats = premultiplied(brightest);
        const auto traced = premultiplied(brightest);
        std::vector<std::uint32_t> counts(kPixels);
        std::vector<glm::vec4> sums = traced;
        for (std::size_t i = 0; i < kPixels; ++i) {
            counts[i] = std::uint32_t(i % 5);  // also of a pixel that has no sample yet
            sums[i] *= float(std::max(counts[i], 1u));
        }
        const bool isWarm = brightest == 1.0f;
        const Display display{.background = {0.02f, 0.1f, 0.3f},
                              .exposure = 1.7f,
                              .toneMap = isWarm ? trace::ToneMap::neutral : trace::ToneMap::hue};
        for (const float share : {0.0f, 0.25f, 0.9f, 1.0f}) {
            const auto ofSums = composed(upload(splats, sums, counts), share, false, display);
            const auto ofMeans = composed(upload(splats, traced, counts), share, true, display);
            for (std::size_t i = 0; i < kPixels; ++i) {
                const glm::dvec4 bright = glm::dvec4(splats[i]) * glm::dvec4(glm::dvec3(kGain), 1.0);
                const glm::dvec3 shown =
                    expected(glm::mix(bright, glm::dvec4(traced[i]), double(share)), display);
                for (int k = 0; k < 3; ++k) {
                    ASSERT_NEAR(ofSums[i][k], 255.0 * shown[k], kRounding) << share;
                    ASSERT_NEAR(ofMeans[i][k], 255.0 * shown[k], kRounding) << share;
                }
                ASSERT_EQ(ofSums[i].w, 255);
            }
        }
    }
}

// To be laid over something else: what covers a part of a pixel has that part of its light.
TEST_F(CompositorTest, KeepsTheCoverageWhereItIsWanted) {
    const auto encoded = [](double c) {
        return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
    };
    const auto decoded = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    auto splats = premultiplied(2.0f);
    splats[0] = glm::vec4(0.0f);
    splats[1] = glm::vec4(0.2f, 0.3f, 0.4f, 1.5f);  // rounding may go beyond all
    const std::vector<std::uint32_t> counts(kPixels, 1);
    const Display display{.background = {0.5f, 0.5f, 0.5f}, .exposure = 1.3f, .keepsCoverage = true};
    const auto shown = composed(upload(splats, splats, counts), 0.0f, true, display);
    Display black = display;
    black.background = glm::vec3(0.0f);
    EXPECT_EQ(shown[0], glm::u8vec4(0)) << "nothing is clear, whatever the background";
    for (std::size_t i = 1; i < kPixels; ++i) {
        const double coverage = std::min(double(splats[i].w), 1.0);
        if (coverage < 1e-3) continue;
        const glm::dvec3 light = glm::dvec3(splats[i]) * kGain / coverage;
        const glm::dvec3 opaque = expected(glm::dvec4(light, 1.0), black);
        ASSERT_NEAR(shown[i].w, 255.0 * coverage, kRounding) << i;
        for (int k = 0; k < 3; ++k)
            ASSERT_NEAR(shown[i][k], 255.0 * encoded(coverage * decoded(opaque[k])), 0.6) << i;
    }
}

TEST_F(CompositorTest, TheFoveaTakesThePlaceOfSplatsByItsWeight) {
    const auto splats = premultiplied(1.0f);
    const auto fovea = premultiplied(1.0f);
    const auto traced = premultiplied(1.0f);
    std::vector<float> weights(kPixels);
    for (std::size_t i = 0; i < kPixels; ++i) weights[i] = float(i % 5) / 4.0f;
    auto broken = fovea;
    for (std::size_t i = 0; i < kPixels; i += 5)
        broken[i] = glm::vec4(std::numeric_limits<float>::quiet_NaN());
    const std::vector<std::uint32_t> counts(kPixels, 1);
    const OnDevice on = upload(splats, traced, counts);
    const auto texels = [](VkFormat format) {
        return std::move(*gpu::TexelBuffer::create(
            device(),
            {.elements = kPixels,
             .format = format,
             .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT}));
    };
    const gpu::TexelBuffer lightTexels = texels(VK_FORMAT_R32G32B32A32_SFLOAT);
    const gpu::TexelBuffer weightTexels = texels(VK_FORMAT_R32_SFLOAT);
    ASSERT_TRUE(gpu::uploadTo<glm::vec4>(lightTexels.buffer(), broken).ok());
    ASSERT_TRUE(gpu::uploadTo<float>(weightTexels.buffer(), weights).ok());
    const ReprojectedPicture seen{.lights = &lightTexels, .weights = &weightTexels};
    const trace::TracedLight light{.values = &on.traced, .counts = &on.counts, .areMeans = true};
    const Display display{.background = {0.02f, 0.1f, 0.3f}, .exposure = 1.0f};
    auto compositor = Compositor::create(device());
    for (const float share : {0.0f, 0.5f}) {
        const auto picture = compositor->compose({.splats = &on.splats,
                                                  .fovea = &seen,
                                                  .traced = share > 0.0f ? &light : nullptr,
                                                  .sizePx = kSize,
                                                  .splatGain = float(kGain),
                                                  .tracedShare = share},
                                                 display);
        ASSERT_TRUE(picture.ok());
        const auto shown = gpu::read<glm::u8vec4>(**picture).value();
        for (std::size_t i = 0; i < kPixels; ++i) {
            const glm::dvec4 bright = glm::dvec4(splats[i]) * glm::dvec4(glm::dvec3(kGain), 1.0);
            const glm::dvec4 hybrid = glm::mix(bright, glm::dvec4(fovea[i]), double(weights[i]));
            const glm::dvec3 right =
                expected(glm::mix(hybrid, glm::dvec4(traced[i]), double(share)), display);
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(shown[i][k], 255.0 * right[k], kRounding) << i;
        }
    }
}

// What is traced takes the place of splats by trust, and that of both by its share.
TEST_F(CompositorTest, WhatIsTracedIsShownAsFarAsItIsTrusted) {
    const auto splats = premultiplied(1.0f);
    const auto traced = premultiplied(1.0f);
    std::vector<float> trusts(kPixels);
    for (std::size_t i = 0; i < kPixels; ++i) trusts[i] = float(i % 5) / 4.0f;
    const OnDevice on = upload(splats, traced, std::vector<std::uint32_t>(kPixels, 1));
    const gpu::TexelBuffer trustTexels =
        std::move(*makeTexels(device(), "trusts", VK_FORMAT_R32_SFLOAT, kPixels));
    ASSERT_TRUE(gpu::uploadTo<float>(trustTexels.buffer(), trusts).ok());
    const trace::TracedLight light{.values = &on.traced, .counts = &on.counts, .areMeans = true};
    const Display display{.background = {0.02f, 0.1f, 0.3f}, .exposure = 1.0f};
    auto compositor = Compositor::create(device());
    for (const float share : {0.0f, 0.5f, 1.0f}) {
        const auto picture = compositor->compose({.splats = &on.splats,
                                                  .traced = share > 0.0f ? &light : nullptr,
                                                  .tracedTrusts = &trustTexels,
                                                  .sizePx = kSize,
                                                  .splatGain = float(kGain),
                                                  .tracedShare = share},
                                                 display);
        ASSERT_TRUE(picture.ok());
        const auto shown = gpu::read<glm::u8vec4>(**picture).value();
        for (std::size_t i = 0; i < kPixels; ++i) {
            const glm::dvec4 bright = glm::dvec4(splats[i]) * glm::dvec4(glm::dvec3(kGain), 1.0);
            const glm::dvec4 trusted = glm::mix(bright, glm::dvec4(traced[i]), double(trusts[i]));
            const glm::dvec3 right = expected(glm::mix(bright, trusted, double(share)), display);
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(shown[i][k], 255.0 * right[k], kRounding) << i;
        }
    }
}

// What has no share in it cannot spoil the picture; the most and the least that light can be show as such.
TEST_F(CompositorTest, HoldsAtTheExtremes) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const float denormal = std::numeric_limits<float>::denorm_min();
    const std::vector<std::uint32_t> counts(kPixels, 1);
    const std::vector<glm::vec4> good(kPixels, glm::vec4(0.2f, 0.3f, 0.1f, 0.5f));
    const Display display{.background = glm::vec3(0.02f), .exposure = 1.0f};
    const auto onlySplats = composed(upload(good, good, counts), 0.0f, false, display);
    const auto onlyTraced = composed(upload(good, good, counts), 1.0f, false, display);
    for (const float bad : {nan, infinity, -infinity}) {
        const std::vector<glm::vec4> broken(kPixels, glm::vec4(bad));
        EXPECT_EQ(composed(upload(good, broken, counts), 0.0f, false, display), onlySplats);
        EXPECT_EQ(composed(upload(broken, good, counts), 1.0f, false, display), onlyTraced);
    }
    const std::vector<glm::vec4> faint(kPixels, glm::vec4(denormal));
    const std::vector<glm::vec4> none(kPixels, glm::vec4(0.0f));
    EXPECT_EQ(composed(upload(faint, faint, counts), 0.5f, false, display),
              composed(upload(none, none, counts), 0.5f, false, display));
    const std::vector<glm::vec4> bright(kPixels, glm::vec4(1e30f, 1e30f, 1e30f, 1.0f));
    for (const glm::u8vec4& p : composed(upload(bright, none, counts), 0.5f, false, display))
        ASSERT_GE(p.x, 254);
    // Weaker than what it is mixed with by a million to one.
    const std::vector<glm::vec4> weak(kPixels, good[0] * 1e-6f);
    const auto dim = composed(upload(good, weak, counts), 0.5f, false, display);
    const glm::dvec4 light = glm::dvec4(good[0]) * glm::dvec4(glm::dvec3(kGain), 1.0);
    const glm::dvec3 half = expected(0.5 * (light + 1e-6 * glm::dvec4(good[0])), display);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(dim[0][k], 255.0 * half[k], 0.52);
}

}  // namespace
}  // namespace macula::hybrid
