// The native kernel of pictures is the reference in double.
#include "pipeline/splat/native/native_raster.h"

#include <cmath>
#include <limits>

#include "base/worst.h"
#include "splat/native/native_pictures.h"

namespace macula::splat {
namespace {

// To 1e-4 by pixel, as the device.
void expectLikeReference(const Splats& splats, const RasterView& view, const Blending& blending,
                         int tileRows = 16) {
    NativeScene scene(splats, view, blending, tileRows);
    const RasterImage exact = rasterize(ReferenceSplats(splats), view, blending, Precision::twofold);
    double deepest = 500.0;
    for (const double depth : exact.depth) deepest = std::max(deepest, depth);
    onEachInstructionSet([&] {
        std::fill(scene.picture.begin(), scene.picture.end(), glm::vec4(7.0f));
        scene.draw();
        double worst = 0.0;
        double worstDepth = 0.0;
        for (std::size_t i = 0; i < exact.rgba.size(); ++i) {
            for (int k = 0; k < 4; ++k)
                worst = test::worse(worst, std::abs(double(scene.picture[i][k]) - exact.rgba[i][k]) /
                                               std::max(1.0, exact.rgba[i][k]));
            worstDepth =
                test::worse(worstDepth, std::abs(double(scene.depths[i]) - exact.depth[i]) / deepest);
        }
        EXPECT_LT(worst, 1e-4);
        EXPECT_LT(worstDepth, 1e-4);
    });
}

TEST(NativeRaster, PicturesAreThoseOfTheReference) {
    for (const NativeCase& c : kNativeCases) {
        const Splats splats = singleOf(randomModel(17, c.splats, 1));
        expectLikeReference(splats, nativeViewOf(c), {}, c.tileRows);
        expectLikeReference(splats, nativeViewOf(c), blendingOf(LowPass::classic), c.tileRows);
        expectLikeReference(splats, nativeViewOf(c), {.minAlpha = 1e-9}, c.tileRows);
    }
}

TEST(NativeRaster, SplatsOfAnySize) {
    for (const float logScale : {-100.0f, -6.0f, -1.0f, 2.0f, 6.0f, 20.0f, 100.0f}) {
        for (const float logit : {-5.0f, 2.2f, 80.0f}) {
            Splats splats = singleOf(randomModel(3, 20, 1));
            for (std::size_t i = 0; i < splats.size(); ++i) {
                splats.logScale[i].y = logScale;
                splats.opacityLogit[i] = logit;
            }
            expectLikeReference(splats, frontView({75, 33}), {});
        }
    }
}

// Opaque splats in front of many others: tiles end early.
TEST(NativeRaster, FinishedPixelsStayAsTheyAre) {
    Splats splats = singleOf(randomModel(5, 400, 1));
    for (std::size_t i = 0; i < splats.size(); i += 2) {
        splats.logScale[i] = glm::vec3(3.0f);
        splats.opacityLogit[i] = 9.0f;
    }
    expectLikeReference(splats, frontView({61, 47}, 14.0), {});
    expectLikeReference(splats, frontView({61, 47}, 14.0), {.minTransmittance = 0.1});
    expectLikeReference(splats, frontView({61, 47}, 14.0), {.minTransmittance = 0.0});
}

TEST(NativeRaster, ResultsAreTheSameEachTime) {
    NativeScene scene(singleOf(randomModel(7, 300, 1)), frontView({133, 71}, 14.0), {});
    scene.draw();
    const std::vector<glm::vec4> first = scene.picture;
    scene.draw();
    EXPECT_EQ(scene.picture, first);
}

// Numbers of splats that no projection writes: as in the kernel, no pixel beside theirs changes.
TEST(NativeRaster, NumbersThatAreNotFiniteStayInTheirTiles) {
    const RasterView view = frontView({64, 32}, 14.0);
    NativeScene scene(singleOf(randomModel(9, 100, 1)), view, {});
    scene.draw();
    const std::vector<glm::vec4> good = scene.picture;
    const glm::uvec2 range = scene.lists.ranges[3];
    ASSERT_LT(range.x, range.y);
    const std::vector<glm::vec4> screen = scene.screen;
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e-40f, 3e38f}) {
        for (glm::length_t number = 0; number < 12; ++number) {
            scene.screen = screen;
            const std::uint32_t splat = scene.lists.entries[range.x].x;
            scene.screen[std::size_t(splat) * 3 + std::size_t(number / 4)][number % 4] = bad;
            onEachInstructionSet([&] {
                scene.draw();
                for (std::size_t i = 0; i < good.size(); ++i) {
                    const std::size_t tile = i / 64 / 16 * 8 + i % 64 / 8;
                    bool shows = false;
                    for (std::uint32_t e = scene.lists.ranges[tile].x; e < scene.lists.ranges[tile].y; ++e)
                        shows = shows || scene.lists.entries[e].x == splat;
                    if (!shows) {
                        ASSERT_NEAR(scene.picture[i].x, good[i].x, 1e-5);
                    }
                }
            });
        }
    }
}

}  // namespace
}  // namespace macula::splat
