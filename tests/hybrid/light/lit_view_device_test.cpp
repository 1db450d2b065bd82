// Views that are lit with what others have found, against those that are traced.
#include "pipeline/hybrid/light/lit_view.h"

#include <cmath>

#include "hybrid/coloured_ball.h"
#include "pipeline/hybrid/light/pixel_coverage.h"
#include "pipeline/hybrid/light/reference_lit_view.h"
#include "pipeline/hybrid/views/pose_sampling.h"
#include "pipeline/hybrid/views/traced_scene.h"
#include "pipeline/hybrid/views/view_tracing.h"
#include "pipeline/trace/device_scene.h"
#include "trace/gpu_scene.h"

namespace macula::hybrid {
namespace {

using coloured_ball::ball;
using coloured_ball::fromLeft;
using coloured_ball::kPicture;
using coloured_ball::matter;

constexpr int kBounces = 4;

class LitViews : public trace::DeviceTest {
  protected:
    struct Compared {
        // Mean difference of light, over the mean of light, in squares of four pixels: what is less is chance
        double off = 0.0;
        double mirrored = 0.0;  // likewise, of the traced view left for right
        double light = 0.0;     // over that of the traced view
        double known = 0.0;     // part of the covered pixels
        double coverage = 0.0;  // mean difference in these
    };
    // `tracer` has the view that `lit` was made of.
    static void expectAsTheReference(const TracedView& lit, trace::PathTracer& tracer, const Camera& camera,
                                     const LightInSpace& light) {
        const auto expected =
            referenceLitView(tracer.readLayers().value(), camera, kPicture, raysAside(kPicture), light);
        ASSERT_TRUE(expected.ok());
        ASSERT_EQ(lit.rgba.size(), expected->rgba.size());
        std::size_t differ = 0;  // where a ray just comes near what was seen, or just does not
        for (std::size_t i = 0; i < lit.rgba.size(); ++i) {
            for (int c = 0; c < 4; ++c) {
                const float ours = lit.rgba[i][c];
                const float right = expected->rgba[i][c];
                if (!(std::abs(ours - right) <= 1e-3f * (1.0f + std::abs(right))) &&
                    !(std::isnan(ours) && std::isnan(right)))
                    ++differ;
            }
        }
        EXPECT_LE(differ, lit.rgba.size() / 500);
    }
    Compared compare(double opacity, const Clip& clip = {}) const {
        const auto volume = ball(350, 650);
        const trace::Environment lights = fromLeft();
        const TransferFunction function = matter(opacity);
        trace::PathTracer tracer =
            trace::DeviceTest::tracer(volume, function, lights, scenes::lookAt(*volume), {});
        EXPECT_TRUE(tracer.scene().setClip(clip).ok());
        const Box seenMm = TracedScene::create(volume, function, clip, lights)->seenMm();
        std::vector<Camera> cameras;
        const auto views = samplePoses(seenMm, initialTraining(13));
        for (const SampledPose& view : *views) cameras.push_back(view.camera);
        Progress progress;
        LightInSpace light(0.7);
        ViewTracing tracing{.sizePx = kPicture, .samplesPerPixel = 30};
        tracing.settings.bounces = kBounces;
        tracing.light = &light;
        EXPECT_TRUE(traceViews(tracer, std::span(cameras).first(12), tracing, progress).ok());
        light.finish();
        auto table = LightTable::create(tracer.device(), light);
        const auto lit = table->lit(tracer, cameras.back(), kPicture);
        expectAsTheReference(*lit, tracer, cameras.back(), light);
        const auto truth =
            traceView(tracer, {.camera = cameras.back(), .width = kPicture.x, .height = kPicture.y},
                      {.bounces = kBounces, .seed = 1234}, 512, progress);
        EXPECT_TRUE(lit.ok() && truth.ok());
        const TracedView& view = *lit;
        EXPECT_EQ(view.sizePx, kPicture);
        EXPECT_EQ(view.camera.positionMm, cameras.back().positionMm);
        EXPECT_EQ(view.samplesPerPixel, 0.0);
        const auto coverage = pixelCoverage(tracer.readGuides().value(), kPicture);
        Compared compared;
        double sum = 0.0;
        double right = 0.0;
        double covered = 0.0;
        constexpr int kSquare = 4;
        for (int y = 0; y < kPicture.y; y += kSquare) {
            for (int x = 0; x < kPicture.x; x += kSquare) {
                glm::dvec3 off(0.0);
                glm::dvec3 mirrored(0.0);
                for (int n = 0; n < kSquare * kSquare; ++n) {
                    const int column = x + n % kSquare;
                    const int row = (y + n / kSquare) * kPicture.x;
                    const auto i = std::size_t(row + column);
                    if (coverage[i] > 0.0f) covered += 1.0;
                    if (!std::isfinite(view.rgba[i].a)) continue;
                    if (coverage[i] > 0.0f) compared.known += 1.0;
                    compared.coverage += std::abs(double(view.rgba[i].a) - double(truth->rgba[i].a));
                    const glm::dvec3 ours(view.rgba[i]);
                    const glm::dvec3 theirs(truth->rgba[i]);
                    off += ours - theirs;
                    mirrored += ours - glm::dvec3(truth->rgba[std::size_t(row + kPicture.x - 1 - column)]);
                    sum += ours.x + ours.y + ours.z;
                    right += theirs.x + theirs.y + theirs.z;
                }
                for (int c = 0; c < 3; ++c) {
                    compared.off += std::abs(off[c]);
                    compared.mirrored += std::abs(mirrored[c]);
                }
            }
        }
        compared.off /= right;
        compared.mirrored /= right;
        compared.light = sum / right;
        compared.known /= covered;
        compared.coverage /= covered;
        return compared;
    }
};

TEST_F(LitViews, OfOpaqueMatterAreWhatIsTraced) {
    const Compared compared = compare(0.9);
    EXPECT_LT(compared.off, 0.15);
    EXPECT_GT(compared.mirrored, 1.0);
    EXPECT_LT(compared.coverage, 0.03);
    EXPECT_NEAR(compared.light, 1.0, 0.03);
    EXPECT_GT(compared.known, 0.98);
}

// Without a depth that is one.
TEST_F(LitViews, OfHazeAreWhatIsTraced) {
    const Compared compared = compare(0.04);
    EXPECT_LT(compared.off, 0.12);
    EXPECT_GT(compared.mirrored, 1.0);
    EXPECT_LT(compared.coverage, 0.03);
    EXPECT_NEAR(compared.light, 1.0, 0.03);
    EXPECT_GT(compared.known, 0.98);
}

TEST_F(LitViews, OfAClipShowItsFaces) {
    Clip clip;
    clip.planes = {{.normal = {0, 0, -1}, .offsetMm = -2.0}};
    clip.greyFaces = DisplayWindow{.center = 500, .width = 600};
    const Compared compared = compare(0.9, clip);
    EXPECT_LT(compared.off, 0.06);
    EXPECT_GT(compared.mirrored, 1.0);
    EXPECT_NEAR(compared.light, 1.0, 0.03);
    EXPECT_GT(compared.known, 0.98);
}

TEST_F(LitViews, AreNotKnownWhereNothingWasFound) {
    const auto volume = ball(350, 650);
    trace::PathTracer tracer =
        trace::DeviceTest::tracer(volume, matter(0.9), fromLeft(), scenes::lookAt(*volume), {});
    LightInSpace nothing(1.0);
    nothing.finish();
    const Camera camera = scenes::lookAt(*volume).camera;
    const auto lit = LightTable::create(tracer.device(), nothing)->lit(tracer, camera, kPicture);
    ASSERT_TRUE(lit.ok());
    ASSERT_TRUE(tracer.setView({.camera = camera, .width = kPicture.x, .height = kPicture.y}).ok());
    const auto coverage = pixelCoverage(tracer.readGuides().value(), kPicture);
    std::size_t covered = 0;
    std::size_t black = 0;
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        const glm::vec4& pixel = lit->rgba[i];
        if (coverage[i] == 0.0f && !std::isnan(pixel.a)) {
            EXPECT_EQ(pixel, glm::vec4(0.0f));
            ++black;
        }
        if (coverage[i] < 0.98f) continue;
        EXPECT_TRUE(std::isnan(pixel.r) && std::isnan(pixel.a));
        ++covered;
    }
    EXPECT_GT(covered, 100u);
    EXPECT_GT(black, 100u);
}

}  // namespace
}  // namespace macula::hybrid
