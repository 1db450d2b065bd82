// The guides that the device makes, against the same maths in double.
#include <cmath>

#include "base/phantom.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/gpu_scene.h"
#include "trace/instruction_sets.h"
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
        .camera = frameBox(volume->worldBox(), ViewDirection::anterior, 30, 1.0), .width = 71, .height = 59};
    View now = before;
    now.camera.positionMm += glm::dvec3(30, 10, -20);
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), fitted(tissue, *volume));
    const auto expected = ReferenceTracer(*volume, medium, sky)
                              .guides(*makeTraceParams(*volume, medium, sky, now, {}),
                                      *guidePush(now, before), Precision::twofold);
    onEachInstructionSet(device()->runsNatively(), [&] {
        PathTracer t = tracer(volume, tissue, sky, before, {});
        ASSERT_TRUE(*t.trace(1));
        ASSERT_TRUE(t.setView(now).ok());
        const auto pixels = t.readGuides();
        ASSERT_TRUE(pixels.ok());
        ASSERT_EQ(pixels->size(), expected.size());
        // Where a rounding decides whether there is a depth, or which step meets matter first.
        int different = 0;
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
    });
}

TEST_F(GuidesOnDevice, DepthIsWhereTransmittanceFallsToOneHalf) {
    const auto [volume, view] = scenes::slab(10.0, 8);
    PathTracer t = tracer(volume, scenes::homogeneous(0.2), Environment::constant(glm::vec3(1.0f)), view, {});
    const auto image = t.readback();
    ASSERT_TRUE(image.ok());
    for (const float mm : image->depthMm) EXPECT_NEAR(mm, 3000 - 5 + std::log(2.0) / 0.2, 0.01);
    ASSERT_TRUE(t.scene().setTransferFunction(scenes::homogeneous(0.05)).ok());
    const auto thin = t.readback();
    for (const float mm : thin->depthMm) EXPECT_TRUE(std::isinf(mm));
}

// Values that fall along `outwards`, 5000 in the middle of the volume, 100 less for each mm.
std::shared_ptr<const Volume> tilted(const glm::dvec3& outwards) {
    const glm::ivec3 size(48);
    return scenes::volumeOf(size, glm::dmat4(1.0), [&](int i, int j, int k) {
        const double mm = glm::dot(glm::dvec3(i, j, k) - 0.5 * glm::dvec3(size), outwards);
        return static_cast<std::uint16_t>(std::lround(5000.0 - 100.0 * mm));
    });
}

// Not where the volume ends, beyond which its outer voxels go on.
void expectNormals(const std::vector<GuidePixel>& pixels, const glm::dvec3& normal, const std::string& what) {
    int hits = 0;
    for (int y = 8; y < 40; ++y) {
        for (int x = 8; x < 40; ++x) {
            const GuidePixel& pixel = pixels[std::size_t(y * 48 + x)];
            if (pixel.depthMm < 0.0f) continue;
            ++hits;
            EXPECT_LT(glm::distance(glm::dvec3(pixel.normal), normal), 0.02) << what << " " << x << " " << y;
        }
    }
    EXPECT_GT(hits, 600) << what;
}

// A gradient takes voxels of bricks in which nothing is visible: beyond a surface, and beyond a face of a
// clip that shows grey values.
TEST_F(GuidesOnDevice, NormalsAreRightBesideBricksThatShowNothing) {
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    TransferFunction dense = scenes::homogeneous(50.0);
    dense.opacity = {{5000, 0.0}, {5000, 0.5}};
    TransferFunction nothing = dense;
    nothing.opacity = {{60000, 0.0}, {60000, 0.5}};
    for (const double side : {1.0, -1.0}) {
        const glm::dvec3 outwards = side * glm::normalize(glm::dvec3(0.2, 1.0, 0.3));
        const auto volume = tilted(outwards);
        const View view{
            .camera = frameBox(volume->worldBox(),
                               side > 0 ? ViewDirection::posterior : ViewDirection::anterior, 30, 1.0),
            .width = 48,
            .height = 48};
        PathTracer t = tracer(volume, dense, sky, view, {});
        // Depths alone need no gradients, and the guides that they are read from are not taken for those with
        // normals.
        ASSERT_TRUE(*t.trace(1));
        const std::uint64_t before = t.statistics()->voxels.shownBlocks;
        ASSERT_TRUE(t.readback().ok());
        EXPECT_EQ(t.statistics()->voxels.shownBlocks, before);
        expectNormals(*t.readGuides(), outwards, "surface");
        EXPECT_EQ(t.statistics()->samplesPerPixel, 1u) << "what was traced stays";

        const glm::dvec3 kept = -side * glm::normalize(glm::dvec3(0.1, 1.0, 0.05));
        const Clip clip{
            .planes = {{kept, glm::dot(kept, glm::dvec3(24.0))}},
            .greyFaces = DisplayWindow{.center = 5000, .width = 10000, .function = "LINEAR_EXACT"}};
        PathTracer face = tracer(volume, nothing, sky, view, {});
        ASSERT_TRUE(face.scene().setClip(clip).ok());
        expectNormals(*face.readGuides(), outwards, "face");
    }
}

// The filter is steered by normals, whenever it is asked for.
TEST_F(GuidesOnDevice, DenoisingBringsTheVoxelsOfGradients) {
    const auto volume = tilted(glm::normalize(glm::dvec3(0.2, 1.0, 0.3)));
    TransferFunction dense = scenes::homogeneous(50.0);
    dense.opacity = {{5000, 0.0}, {5000, 0.5}};
    const View view{
        .camera = frameBox(volume->worldBox(), ViewDirection::posterior, 30, 1.0), .width = 48, .height = 48};
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    PathTracer always = tracer(volume, dense, sky, view, {.denoising = Denoising::on});
    ASSERT_TRUE(*always.trace(2));
    PathTracer later = tracer(volume, dense, sky, view, {});
    ASSERT_TRUE(*later.trace(2));
    const auto plain = later.readback()->radiance;
    const std::uint64_t few = later.statistics()->voxels.shownBlocks;
    ASSERT_TRUE(later.setSettings({.denoising = Denoising::on}).ok());
    EXPECT_EQ(later.statistics()->samplesPerPixel, 2u);
    EXPECT_GT(later.statistics()->voxels.shownBlocks, few);
    EXPECT_EQ(later.statistics()->voxels.shownBlocks, always.statistics()->voxels.shownBlocks);
    const auto filtered = later.readback()->radiance;
    EXPECT_NE(filtered, plain);
    EXPECT_EQ(filtered, always.readback()->radiance);
    ASSERT_TRUE(later.setSettings({}).ok());
    EXPECT_EQ(later.readback()->radiance, plain);
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
