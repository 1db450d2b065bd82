// The guides that the device makes, against the same maths in double.
#include <cmath>

#include "base/phantom.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

using GuidesOnDevice = DeviceTest;

TEST_F(GuidesOnDevice, AreThoseOfTheReference) {
    const auto volume = std::make_shared<const Volume>(
        phantom::make({.size = {128, 112, 80}, .spacingMm = {2.4, 2.4, 3.75}}));
    TransferFunction tissue = scenes::homogeneous(1.0, 0.8);
    tissue.opacity = {{-100, 0.0}, {100, 0.02}, {150, 0.03}, {400, 0.8}};
    tissue.colour = {{-100, {1, 0.2, 0.1}}, {400, {0.9, 0.9, 0.8}}};
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const View before{
        .camera = frameBox(volume->worldBox(), ViewDirection::anterior, 30, 1.0), .width = 72, .height = 60};
    View now = before;
    now.camera.positionMm += glm::dvec3(30, 10, -20);
    PathTracer t = tracer(volume, tissue, sky, before, {});
    ASSERT_TRUE(*t.trace(1));
    ASSERT_TRUE(t.setView(now).ok());
    const auto pixels = t.readGuides();
    ASSERT_TRUE(pixels.ok());

    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), fitted(tissue, *volume));
    const auto expected = ReferenceTracer(*volume, medium, sky)
                              .guides(*makeTraceParams(*volume, medium, sky, now, {}),
                                      *guidePush(now, before), Precision::twofold);
    ASSERT_EQ(pixels->size(), expected.size());
    int different = 0;  // where a rounding decides whether there is a depth, or which step meets matter first
    int hits = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const GuidePixel& d = (*pixels)[i];
        const GuideOf<double>& r = expected[i];
        const double off = std::abs(d.depthMm - r.depthMm) / 1.0 + std::abs(d.confidence - r.confidence) +
                           std::abs(d.coverage - r.coverage) + std::abs(d.beforeMm - r.beforeMm) / 1.0 +
                           glm::distance(glm::dvec3(d.albedo), r.albedo) +
                           glm::distance(glm::dvec3(d.normal), r.normal) +
                           glm::distance(glm::dvec2(d.motion), r.motion);
        EXPECT_TRUE(std::isfinite(off)) << i;
        if (!(off < 0.05)) ++different;
        if (r.depthMm > 0) ++hits;
    }
    EXPECT_GT(hits, 300);
    EXPECT_LT(different, int(expected.size() / 100));
}

TEST_F(GuidesOnDevice, DepthIsWhereTransmittanceFallsToOneHalf) {
    const auto [volume, view] = scenes::slab(10.0, 8);
    PathTracer t = tracer(volume, scenes::homogeneous(0.2), Environment::constant(glm::vec3(1.0f)), view, {});
    const auto image = t.readback();
    ASSERT_TRUE(image.ok());
    for (const float mm : image->depthMm) EXPECT_NEAR(mm, 3000 - 5 + std::log(2.0) / 0.2, 0.01);
    ASSERT_TRUE(t.setTransferFunction(scenes::homogeneous(0.05)).ok());
    const auto thin = t.readback();
    for (const float mm : thin->depthMm) EXPECT_TRUE(std::isinf(mm));
}

TEST_F(GuidesOnDevice, OfPicturesOfAnyShapeAreFinite) {
    const auto [volume, view] = scenes::slab(10.0, 8);
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 37), std::pair(41, 1)}) {
        View odd = view;
        odd.width = width;
        odd.height = height;
        odd.camera.positionMm.y = -500;
        PathTracer t =
            tracer(volume, scenes::homogeneous(0.2), Environment::constant(glm::vec3(1.0f)), odd, {});
        const auto pixels = t.readGuides();
        ASSERT_TRUE(pixels.ok());
        ASSERT_EQ(pixels->size(), std::size_t(width * height));
        for (const GuidePixel& pixel : *pixels) {
            EXPECT_GT(pixel.coverage, 0.8f);
            EXPECT_TRUE(std::isfinite(pixel.motion.x + pixel.motion.y + pixel.normal.x + pixel.depthMm));
        }
    }
}

}  // namespace
}  // namespace macula::trace
