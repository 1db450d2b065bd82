// A thin lens on the device: paths and guides against the reference, and what the filter makes of the blur.
#include <algorithm>
#include <cmath>

#include "base/phantom.h"
#include "pipeline/trace/reference_tracer.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

using LensOnDevice = DeviceTest;

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

// Sharp is the front of the body, so that most of it is blurred.
View blurred(bool isParallel) {
    View view{.camera = frameBox(smallPhantom()->worldBox(), ViewDirection::anterior, 30, 1.2),
              .width = 72,
              .height = 60,
              .lens = {.diameterMm = 40.0, .focusMm = 500.0}};
    if (isParallel) {
        view.camera = standingBefore(inParallel(view.camera), smallPhantom()->worldBox());
        view.lens.focusMm = glm::length(view.camera.targetMm - view.camera.positionMm) - 60.0;
    }
    return view;
}

TEST_F(LensOnDevice, PathsAreThoseOfTheReference) {
    const auto volume = smallPhantom();
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), tissue());
    for (const bool isParallel : {false, true}) {
        const View view = blurred(isParallel);
        PathTracer t = tracer(volume, tissue(), kSky, view, {.seed = 9});
        ASSERT_TRUE(*t.trace(4));
        const auto image = t.readback();
        ASSERT_TRUE(image.ok());
        const auto sums = ReferenceTracer(*volume, medium, kSky)
                              .trace(*makeTraceParams(*volume, medium, kSky, view, {.seed = 9}),
                                     Filter::trilinear, Precision::single, 0, 4);
        int different = 0;
        int covered = 0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            different += glm::length(glm::dvec4(image->radiance[i]) - 0.25 * sums[i]) > 3e-3 ? 1 : 0;
            covered += sums[i].w > 0.0 ? 1 : 0;
        }
        EXPECT_LT(different, int(sums.size() / 50)) << isParallel;
        EXPECT_GT(covered, 1000) << isParallel;
        // And no picture without a lens.
        View sharp = view;
        sharp.lens = {};
        ASSERT_TRUE(t.setView(sharp).ok());
        ASSERT_TRUE(*t.trace(4));
        EXPECT_NE(t.readback()->radiance, image->radiance);
    }
}

TEST_F(LensOnDevice, GuidesAreThoseOfTheReference) {
    const auto volume = smallPhantom();
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), tissue());
    for (const bool isParallel : {false, true}) {
        const View view = blurred(isParallel);
        PathTracer t = tracer(volume, tissue(), kSky, view, {});
        const auto pixels = t.readGuides();
        ASSERT_TRUE(pixels.ok());
        const auto expected = ReferenceTracer(*volume, medium, kSky)
                                  .guides(*makeTraceParams(*volume, medium, kSky, view, {}),
                                          *guidePush(view, view), Precision::twofold);
        int different = 0;
        int hits = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const GuidePixel& d = (*pixels)[i];
            const GuideOf<double>& r = expected[i];
            const double off = std::abs(d.depthMm - r.depthMm) + std::abs(d.confidence - r.confidence) +
                               std::abs(d.coverage - r.coverage) + std::abs(d.beforeMm - r.beforeMm) +
                               glm::distance(glm::dvec3(d.albedo), r.albedo) +
                               glm::distance(glm::dvec3(d.normal), r.normal);
            EXPECT_TRUE(std::isfinite(off)) << i;
            different += off < 0.1 ? 0 : 1;
            hits += r.depthMm > 0 ? 1 : 0;
        }
        EXPECT_GT(hits, 300) << isParallel;
        // Of 16 rays of a pixel one may be on either side of a border, where a rounding decides.
        EXPECT_LT(different, int(expected.size() / 15)) << isParallel;
    }
}

// 16 marches of a ray are the longest loops that lavapipe is given: through a deep haze none of them may end
// early. All rays of a lens of no width are one.
TEST_F(LensOnDevice, GuidesThroughManyVoxelsAreWhole) {
    constexpr int kDeep = 1500;  // voxels
    const auto volume =
        scenes::volumeOf({16, kDeep, 16}, affine({4, 0, 0}, {0, 1, 0}, {0, 0, 4}, {-30, 0, -30}),
                         [](int, int, int) { return std::uint16_t(1); });
    const TransferFunction haze = scenes::homogeneous(5.0 / kDeep);
    View view{.camera = {.positionMm = {3, -3000, 2}, .targetMm = {0, 750, 0}, .verticalFovDeg = 0.5},
              .width = 16,
              .height = 16};
    PathTracer t = tracer(volume, haze, kSky, view, {});
    const auto sharp = t.readGuides();
    ASSERT_TRUE(sharp.ok());
    view.lens = {.diameterMm = 1e-6, .focusMm = 3500.0};
    ASSERT_TRUE(t.setView(view).ok());
    const auto through = t.readGuides();
    ASSERT_TRUE(through.ok());
    for (std::size_t i = 0; i < sharp->size(); ++i) {
        EXPECT_GT((*sharp)[i].coverage, 0.9f) << i;
        EXPECT_NEAR((*through)[i].coverage, (*sharp)[i].coverage, 1e-3) << i;
        EXPECT_NEAR((*through)[i].depthMm, (*sharp)[i].depthMm, 1.0) << i;
    }
}

// A wall far behind the focus that covers the left half: across its border brightness falls slowly, and the
// filter must neither steepen that nor blur it more.
TEST_F(LensOnDevice, TheFilterLeavesTheBlurAsItIs) {
    const auto volume =
        scenes::volumeOf({32, 4, 32}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-31.5, 0, -15.5}),
                         [](int, int, int) { return std::uint16_t(1); });
    const View view{.camera = {.positionMm = {0, -300, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 4.0},
                    .width = 64,
                    .height = 64,
                    .lens = {.diameterMm = 16.0, .focusMm = 200.0}};
    const TransferFunction wall = scenes::homogeneous(20.0, 0.8);
    const auto profileOf = [&](const Settings& settings, std::uint32_t samples) {
        PathTracer t = tracer(volume, wall, kSky, view, settings);
        EXPECT_TRUE(*t.trace(samples));
        const auto image = t.readback();
        std::vector<double> columns(64);
        for (int y = 16; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                columns[std::size_t(x)] += image->radiance[std::size_t(y * 64 + x)].x / 32.0;
        return columns;
    };
    // Of the border: how far apart the columns are that have a quarter and three quarters of the brightness.
    const auto widthPx = [](const std::vector<double>& columns) {
        const double bright = columns[4];
        double from = 0.0;
        double to = 0.0;
        for (std::size_t x = 1; x < columns.size(); ++x) {
            const auto crossing = [&](double level) {
                return double(x) - (level * bright - columns[x]) / (columns[x - 1] - columns[x]);
            };
            if (columns[x - 1] > 0.75 * bright && columns[x] <= 0.75 * bright) from = crossing(0.75);
            if (columns[x - 1] > 0.25 * bright && columns[x] <= 0.25 * bright) to = crossing(0.25);
        }
        return to - from;
    };
    const double truth = widthPx(profileOf({.bounces = 1, .seed = 1}, 1024));
    // Of a disc of 8 mm in 21 mm, whose shadow has half of its light within 0.404 of its diameter.
    EXPECT_NEAR(truth, 0.404 * 8.0 / (2.0 * 300.0 * std::tan(glm::radians(2.0))) * 64.0, 0.8);
    const double filtered = widthPx(profileOf({.bounces = 1, .seed = 2, .denoising = Denoising::on}, 8));
    EXPECT_NEAR(filtered, truth, 0.12 * truth);
}

}  // namespace
}  // namespace macula::trace
