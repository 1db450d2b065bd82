// Where the light of pixels comes from, against the same maths in double and against what is known of it.
#include <array>
#include <cmath>

#include "pipeline/trace/reference_tracer.h"
#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"
#include "trace/instruction_sets.h"
#include "trace/small_scenes.h"

namespace macula::trace {
namespace {

using shared::kPixelLayers;
using shared::PixelLayers;

using LayersOnDevice = DeviceTest;

std::array<double, kPixelLayers> middles(const PixelLayers& pixel) {
    std::array<double, kPixelLayers> mm{};
    for (int i = 0; i < 4; ++i) {
        mm[std::size_t(i)] = double(pixel.nearMm[i]);
        mm[std::size_t(i + 4)] = double(pixel.farMm[i]);
    }
    return mm;
}

TEST_F(LayersOnDevice, AreThoseOfTheReferenceInEachSmallScene) {
    for (const scenes::SmallScene& scene : scenes::smallScenes()) {
        SCOPED_TRACE(scene.name);
        const Settings settings = scene.settings(Look::cinematic, Filter::trilinear, 5);
        std::optional<MaskBits> mask;
        if (scene.clip.mask) mask = maskBits(*scene.clip.mask, *scene.volume);
        const Medium medium =
            makeMedium(*scene.volume, makeBrickGrid(*scene.volume), fitted(scene.function, *scene.volume),
                       scene.clip, mask ? &*mask : nullptr);
        const Environment sky = scene.environment();
        const auto expected =
            ReferenceTracer(*scene.volume, medium, sky, mask ? &*mask : nullptr)
                .layers(*makeTraceParams(*scene.volume, medium, sky, scene.view, settings, scene.clip),
                        Precision::twofold);
        onEachInstructionSet(device()->runsNatively(), [&] {
            PathTracer t = tracer(scene.volume, scene.function, scene.environment(), scene.view, settings);
            ASSERT_TRUE(t.scene().setClip(scene.clip).ok());
            const auto pixels = t.readLayers();
            ASSERT_TRUE(pixels.ok());
            ASSERT_EQ(pixels->size(), expected.size());
            std::size_t different = 0;  // where a rounding decides whether, or in which step, a depth is met
            std::size_t met = 0;
            for (std::size_t i = 0; i < expected.size(); ++i) {
                double off = std::abs(double((*pixels)[i].coverage) - expected[i].coverage) +
                             std::abs(double((*pixels)[i].meanMm) - expected[i].meanMm);
                const auto mm = middles((*pixels)[i]);
                for (std::size_t k = 0; k < mm.size(); ++k) {
                    off += std::abs(mm[k] - expected[i].middleMm[k]);
                    if (mm[k] >= 0.0) ++met;
                }
                ASSERT_TRUE(std::isfinite(off)) << i;
                if (off > 0.02) ++different;
            }
            EXPECT_GT(met, 100u);
            EXPECT_LE(different, expected.size() / 50);
        });
    }
}

// In evenly dense matter opacity rises with depth as it must.
TEST_F(LayersOnDevice, LieWhereOpacityIsAnEighthMore) {
    const auto [volume, view] = scenes::slab(10.0, 8);
    PathTracer t = tracer(volume, scenes::homogeneous(0.2), Environment::constant(glm::vec3(1.0f)), view, {});
    const auto pixels = t.readLayers();
    ASSERT_TRUE(pixels.ok());
    for (const PixelLayers& pixel : *pixels) {
        const auto mm = middles(pixel);
        // The slab hides 1 - exp(-2) = 0.865 of what is behind it: the last eighth is not reached.
        for (int k = 0; k < kPixelLayers - 1; ++k) {
            const double depth = -std::log(1.0 - (k + 0.5) / kPixelLayers) / 0.2;
            EXPECT_NEAR(mm[std::size_t(k)], 3000.0 - 5.0 + depth, 0.01) << k;
        }
        EXPECT_LT(mm.back(), 0.0);
        EXPECT_NEAR(pixel.coverage, 1.0 - std::exp(-2.0), 1e-3);
        EXPECT_GT(pixel.meanMm, 2995.0f);
        EXPECT_LT(pixel.meanMm, 3000.0f);
    }
}

TEST_F(LayersOnDevice, AreFiniteAtTheExtremes) {
    for (const scenes::ExtremeScene& scene : scenes::extremeScenes()) {
        SCOPED_TRACE(scene.name);
        PathTracer t = tracer(scene.volume, scene.function, scene.environment, scene.view, {});
        const auto pixels = t.readLayers();
        ASSERT_TRUE(pixels.ok());
        for (const PixelLayers& pixel : *pixels) {
            ASSERT_TRUE(pixel.coverage >= 0.0f && pixel.coverage <= 1.0f);
            double before = 0.0;
            for (const double mm : middles(pixel)) {
                ASSERT_TRUE(std::isfinite(mm));
                if (mm < 0.0) continue;
                ASSERT_GE(mm, before);
                before = mm;
            }
            ASSERT_TRUE(std::isfinite(pixel.meanMm));
            ASSERT_EQ(pixel.meanMm >= 0.0f, pixel.coverage > 0.0f);
        }
    }
}

TEST_F(LayersOnDevice, EndAtAFace) {
    const glm::ivec3 size(20, 20, 20);
    const auto volume =
        scenes::volumeOf(size, scenes::grid(glm::dvec3(1.0), size), [](int, int, int) { return 500; });
    const View view = scenes::lookAt(*volume);
    PathTracer t =
        tracer(volume, scenes::homogeneous(0.01), Environment::constant(glm::vec3(1.0f)), view, {});
    Clip clip;
    clip.planes = {{.normal = {0, 1, 0}, .offsetMm = 2.0}};
    clip.greyFaces = DisplayWindow{.center = 500, .width = 1000};
    ASSERT_TRUE(t.scene().setClip(clip).ok());
    const auto pixels = t.readLayers();
    ASSERT_TRUE(pixels.ok());
    const PixelLayers& middle = (*pixels)[8 * 16 + 8];
    EXPECT_GT(middle.coverage, 0.999f);
    for (const double mm : middles(middle)) EXPECT_NEAR(mm, 2.0 - view.camera.positionMm.y, 0.05);
}

}  // namespace
}  // namespace macula::trace
