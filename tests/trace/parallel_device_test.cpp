// Parallel rays on the device: paths, casts and guides against the reference.
#include <cmath>

#include "base/phantom.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

using ParallelOnDevice = DeviceTest;

const Environment kSky = Environment::constant(glm::vec3(1.0f));

std::shared_ptr<const Volume> smallPhantom() {
    static const auto volume =
        std::make_shared<const Volume>(phantom::make({.size = {80, 70, 50}, .spacingMm = {3.84, 3.84, 6.0}}));
    return volume;
}

TransferFunction tissue() {
    TransferFunction tissue = scenes::homogeneous(1.0, 0.8);
    tissue.opacity = {{-100, 0.0}, {100, 0.02}, {150, 0.03}, {400, 0.8}};
    tissue.colour = {{-100, {1, 0.2, 0.1}}, {400, {0.9, 0.9, 0.8}}};
    return tissue;
}

// From above, in front and the left, rolled.
View oblique() {
    Camera camera;
    camera.positionMm = {300, -500, 200};
    camera.targetMm = {10, -5, 20};
    camera.up = {0.2, 0.1, 1.0};
    camera.parallelHeightMm = 230;
    camera = standingBefore(camera, smallPhantom()->worldBox());
    return {.camera = camera, .width = 72, .height = 60};
}

int differentPixels(const TracedImage& image, const std::vector<glm::dvec4>& sums, double samples) {
    int different = 0;
    for (std::size_t i = 0; i < sums.size(); ++i)
        different += glm::length(glm::dvec4(image.radiance[i]) - sums[i] / samples) > 3e-3 ? 1 : 0;
    return different;
}

TEST_F(ParallelOnDevice, PathsAreThoseOfTheReference) {
    const auto volume = smallPhantom();
    PathTracer t = tracer(volume, tissue(), kSky, oblique(), {.seed = 9});
    ASSERT_TRUE(*t.trace(4));
    const auto image = t.readback();
    ASSERT_TRUE(image.ok());
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), tissue());
    const auto sums = ReferenceTracer(*volume, medium, kSky)
                          .trace(*makeTraceParams(*volume, medium, kSky, oblique(), {.seed = 9}),
                                 Filter::trilinear, Precision::single, 0, 4);
    EXPECT_LT(differentPixels(*image, sums, 4.0), int(sums.size() / 50));
    int covered = 0;
    for (const glm::dvec4& sum : sums) covered += sum.a > 0.0 ? 1 : 0;
    EXPECT_GT(covered, 1000);
}

TEST_F(ParallelOnDevice, CastsAreThoseOfTheReference) {
    const auto volume = smallPhantom();
    for (const Look look : {Look::dvr, Look::mip}) {
        const Settings settings{.look = look, .shading = Shading::headlight};
        PathTracer t = tracer(volume, tissue(), kSky, oblique(), settings);
        ASSERT_TRUE(*t.trace(2));
        const auto image = t.readback();
        ASSERT_TRUE(image.ok());
        const BrickGrid grid = makeBrickGrid(*volume);
        const Medium medium = look == Look::dvr ? makeMedium(*volume, grid, tissue())
                                                : makeMedium(*volume, grid, Projection::maximum);
        const ReferenceTracer::Cast what{
            .kind = look == Look::dvr ? shared::kCastMatter : shared::kCastMaximum,
            .shading = look == Look::dvr};
        const auto sums = ReferenceTracer(*volume, medium, kSky)
                              .cast(*makeTraceParams(*volume, medium, kSky, oblique(), settings), what,
                                    Precision::twofold, 0, 2);
        EXPECT_LE(differentPixels(*image, sums, 2.0), int(sums.size() / 100)) << nameOf(look);
    }
}

TEST_F(ParallelOnDevice, GuidesAreThoseOfTheReference) {
    const auto volume = smallPhantom();
    const View before = oblique();
    View now = before;
    now.camera.positionMm += glm::dvec3(30, 10, -20);
    now.camera.parallelHeightMm = 250;
    PathTracer t = tracer(volume, tissue(), kSky, before, {});
    ASSERT_TRUE(*t.trace(1));
    ASSERT_TRUE(t.setView(now).ok());
    const auto pixels = t.readGuides();
    ASSERT_TRUE(pixels.ok());
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), tissue());
    const auto expected = ReferenceTracer(*volume, medium, kSky)
                              .guides(*makeTraceParams(*volume, medium, kSky, now, {}),
                                      *guidePush(now, before), Precision::twofold);
    ASSERT_EQ(pixels->size(), expected.size());
    int different = 0;
    int hits = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const GuidePixel& d = (*pixels)[i];
        const GuideOf<double>& r = expected[i];
        const double off = std::abs(d.depthMm - r.depthMm) + std::abs(d.confidence - r.confidence) +
                           std::abs(d.coverage - r.coverage) + std::abs(d.beforeMm - r.beforeMm) +
                           glm::distance(glm::dvec3(d.normal), r.normal) +
                           glm::distance(glm::dvec2(d.motion), r.motion);
        different += off < 0.05 ? 0 : 1;
        hits += r.depthMm > 0 ? 1 : 0;
    }
    EXPECT_GT(hits, 300);
    EXPECT_LT(different, int(expected.size() / 50));
}

// Denoised, and with the history of the view before: it is a picture of the same matter.
TEST_F(ParallelOnDevice, AFilteredPictureIsNearTheTruth) {
    const auto volume = smallPhantom();
    View view = oblique();
    PathTracer t = tracer(volume, tissue(), kSky, view, {.seed = 3});
    ASSERT_TRUE(*t.trace(64));
    const auto truth = t.readback();
    ASSERT_TRUE(t.setSettings({.seed = 4, .denoising = Denoising::on}).ok());
    View before = view;
    before.camera.parallelHeightMm = 240;
    ASSERT_TRUE(t.setView(before).ok());
    ASSERT_TRUE(*t.trace(2));
    ASSERT_TRUE(t.readback().ok());  // leaves a history
    ASSERT_TRUE(t.setView(view).ok());
    ASSERT_TRUE(*t.trace(2));
    const auto filtered = t.readback();
    ASSERT_TRUE(truth.ok() && filtered.ok());
    double error = 0.0;
    double light = 0.0;
    for (std::size_t i = 0; i < truth->radiance.size(); ++i) {
        error += std::abs(filtered->radiance[i].g - truth->radiance[i].g);
        light += truth->radiance[i].g;
        ASSERT_TRUE(std::isfinite(filtered->radiance[i].g));
    }
    EXPECT_LT(error, 0.25 * light);
}

}  // namespace
}  // namespace macula::trace
