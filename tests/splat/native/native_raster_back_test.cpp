// The native kernel of derivatives is the same maths in double, pair by pair.
#include "pipeline/splat/native/native_raster_back.h"

#include <cmath>
#include <limits>

#include "base/worst.h"
#include "pipeline/splat/draw/reference_host.h"
#include "shared/splat_frame.h"
#include "splat/native/native_pictures.h"

namespace macula::splat {
namespace {

using Host = reference::HostTwofold;
constexpr std::size_t kValues = shared::kPairValues;

std::vector<glm::vec4> randomGradient(std::size_t pixels) {
    Dice dice(3);
    std::vector<glm::vec4> gradient(pixels);
    for (glm::vec4& g : gradient) g = glm::vec4(dice.vec3(-1, 1), dice.uniform(-1, 1));
    return gradient;
}

// The splats of the scene, in double.
struct Exact {
    Host::ScreenSplat screen;
    glm::dvec3 colour;
};
Exact exactOf(const NativeScene& scene, std::uint32_t splat) {
    const glm::vec4* texels = &scene.screen[std::size_t(splat) * shared::kScreenTexels];
    return {.screen = {.mean = texels[0],
                       .conic = {texels[0].z, texels[0].w, texels[1].x},
                       .opacity = texels[1].y,
                       .depthMm = texels[1].z,
                       .extent = {texels[1].w, texels[2].w}},
            .colour = texels[2]};
}

// The sums of all pairs and slots: of a tile's pixels, one after the other.
std::vector<double> exactPairs(const NativeScene& scene, const RasterView& view, const Blending& blending,
                               const std::vector<glm::vec4>& gradient, const BackSlots& slots) {
    Host host(view, blending);
    std::vector<double> sums(scene.lists.entries.size() * std::size_t(slots.slots) * kValues);
    const int tileRows = scene.frame.front().tileRows;
    for (int y = 0; y < view.sizePx.y; ++y) {
        for (int x = 0; x < view.sizePx.x; ++x) {
            const std::size_t pixel = std::size_t(y) * std::size_t(view.sizePx.x) + std::size_t(x);
            const auto slot = std::size_t(y % tileRows / slots.rowsOfSlot);
            const Host::PixelGradient g{gradient[pixel], 0.0};
            double transmittance = 1.0;
            double remaining = glm::dot(glm::dvec4(scene.picture[pixel]), g.rgba);
            const auto tile = std::size_t(y / tileRows * scene.lists.tiles.x + x / shared::kTileColumns);
            for (std::uint32_t e = scene.lists.ranges[tile].x; e < scene.lists.ranges[tile].y; ++e) {
                const glm::uvec2 entry = scene.lists.entries[e];
                const Exact exact = exactOf(scene, entry.x);
                const double before = transmittance;
                Host::ScreenGradient sum = host.noGradient();
                host.addPixelGradient(exact.screen, exact.colour, {x + 0.5, y + 0.5}, g, host.frame,
                                      transmittance, remaining, sum);
                double* to = &sums[(std::size_t(entry.y) * std::size_t(slots.slots) + slot) * kValues];
                const std::array<double, kValues> values{sum.mean.x,
                                                         sum.mean.y,
                                                         sum.conic.x,
                                                         sum.conic.y,
                                                         sum.conic.z,
                                                         sum.opacity,
                                                         sum.colour.x,
                                                         sum.colour.y,
                                                         sum.colour.z,
                                                         before - transmittance,
                                                         std::abs(sum.mean.x) + std::abs(sum.mean.y)};
                for (std::size_t k = 0; k < kValues; ++k) to[k] += values[k];
            }
        }
    }
    return sums;
}

void expectLikeReference(const Splats& splats, const RasterView& view, const Blending& blending, int tileRows,
                         const BackSlots& slots) {
    NativeScene scene(splats, view, blending, tileRows);
    scene.draw();
    std::vector<glm::vec4> gradient = randomGradient(scene.picture.size());
    const std::vector<double> exact = exactPairs(scene, view, blending, gradient, slots);
    std::array<double, kValues> most{};
    for (std::size_t n = 0; n < exact.size(); ++n)
        most[n % kValues] = std::max(most[n % kValues], std::abs(exact[n]));
    onEachInstructionSet([&] {
        const std::vector<float> pairs = scene.drawBack(gradient, slots);
        ASSERT_EQ(pairs.size(), exact.size());
        std::array<double, kValues> worst{};
        for (std::size_t n = 0; n < exact.size(); ++n) {
            const std::size_t k = n % kValues;
            worst[k] = test::worse(worst[k], std::abs(double(pairs[n]) - exact[n]) /
                                                 (1e-3 * std::abs(exact[n]) + 1e-4 * most[k] + 1e-30));
        }
        for (std::size_t k = 0; k < kValues; ++k) EXPECT_LT(worst[k], 1.0) << "value " << k;
    });
}

TEST(NativeRasterBack, DerivativesAreThoseOfTheReference) {
    for (const NativeCase& c : kNativeCases) {
        const Splats splats = singleOf(randomModel(5, c.splats, 1));
        for (const BackSlots& slots :
             {BackSlots{1, c.tileRows}, BackSlots{(c.tileRows + 3) / 4, 4}, BackSlots{c.tileRows, 1}}) {
            expectLikeReference(splats, nativeViewOf(c), {}, c.tileRows, slots);
            expectLikeReference(splats, nativeViewOf(c), blendingOf(LowPass::classic), c.tileRows, slots);
        }
    }
}

TEST(NativeRasterBack, SplatsOfAnySize) {
    for (const float logScale : {-100.0f, -6.0f, -1.0f, 2.0f, 6.0f, 20.0f, 100.0f}) {
        for (const float logit : {-5.0f, 2.2f, 80.0f}) {
            Splats splats = singleOf(randomModel(3, 20, 1));
            for (std::size_t i = 0; i < splats.size(); ++i) {
                splats.logScale[i].y = logScale;
                splats.opacityLogit[i] = logit;
            }
            expectLikeReference(splats, frontView({75, 33}), {}, 16, {});
        }
    }
}

TEST(NativeRasterBack, BehindFinishedPixelsThereIsNothing) {
    Splats splats = singleOf(randomModel(5, 400, 1));
    for (std::size_t i = 0; i < splats.size(); i += 2) {
        splats.logScale[i] = glm::vec3(3.0f);
        splats.opacityLogit[i] = 9.0f;
    }
    const RasterView view = frontView({61, 47}, 14.0);
    expectLikeReference(splats, view, {}, 16, {});
    expectLikeReference(splats, view, {.minTransmittance = 0.1}, 16, {});
    expectLikeReference(splats, view, {.minTransmittance = 0.0}, 16, {});
    NativeScene scene(splats, view, {});
    scene.draw();
    std::vector<glm::vec4> gradient = randomGradient(scene.picture.size());
    const std::vector<float> pairs = scene.drawBack(gradient, {});
    const glm::uvec2 last = scene.lists.entries[scene.lists.ranges[9].y - 1];
    for (std::size_t k = 0; k < kValues; ++k) EXPECT_EQ(pairs[last.y * kValues + k], 0.0f);
    EXPECT_EQ(scene.drawBack(gradient, {}), pairs);  // each time
}

TEST(NativeRasterBack, AGradientThatIsNotFiniteStaysInItsTile) {
    NativeScene scene(singleOf(randomModel(9, 100, 1)), frontView({64, 32}, 14.0), {});
    scene.draw();
    std::vector<glm::vec4> gradient = randomGradient(scene.picture.size());
    const std::vector<float> good = scene.drawBack(gradient, {});
    gradient[17 * 64 + 20].y = std::numeric_limits<float>::quiet_NaN();
    const std::size_t tile = 8 + 2;
    onEachInstructionSet([&] {
        const std::vector<float> pairs = scene.drawBack(gradient, {});
        for (std::size_t t = 0; t < scene.lists.ranges.size(); ++t) {
            if (t == tile) continue;
            for (std::uint32_t e = scene.lists.ranges[t].x; e < scene.lists.ranges[t].y; ++e) {
                for (std::size_t k = 0; k < kValues; ++k) {
                    const std::size_t n = scene.lists.entries[e].y * kValues + k;
                    ASSERT_NEAR(pairs[n], good[n], 1e-4 * std::abs(good[n]) + 1e-2);
                }
            }
        }
    });
}

}  // namespace
}  // namespace macula::splat
