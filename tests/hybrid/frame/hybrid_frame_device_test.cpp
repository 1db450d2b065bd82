// The frame: traced where the eye looks, what is drawn for the eye elsewhere, for one eye or two.
#include "pipeline/hybrid/frame/hybrid_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "gpu/lose_device.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/device_scene.h"
#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"

namespace macula::hybrid {
namespace {

using macula::test::loseDeviceAt;
using macula::test::VulkanCall;

constexpr glm::ivec3 kVoxels{48, 48, 48};
constexpr glm::ivec2 kSize{96, 72};
constexpr double kMarkerMm = 3.0;

bool always() {
    return true;
}
bool never() {
    return false;
}

class HybridFrameTest : public trace::DeviceTest {
  protected:
    // A ball to the patient's left of the middle, above it and in front of it.
    const glm::dvec3 markerVoxel_{29.0, 19.0, 27.0};
    const std::shared_ptr<const Volume> volume_ = scenes::volumeOf(
        kVoxels, scenes::grid(glm::dvec3(1.0), kVoxels), [this](int i, int j, int k) -> std::uint16_t {
            const double outside = glm::length(glm::dvec3(i, j, k) - markerVoxel_) - kMarkerMm;
            return static_cast<std::uint16_t>(1000.0 * std::clamp(0.5 - outside, 0.0, 1.0));
        });
    const TransferFunction function_ = scenes::ramp(400, 600, 0.99, 1.0);
    const trace::Environment lights_ = trace::Environment::constant(glm::vec3(1.0f));

    trace::View view() const {
        trace::View view = scenes::lookAt(*volume_);
        view.width = kSize.x;
        view.height = kSize.y;
        return view;
    }
    trace::PathTracer onScreen() { return tracer(volume_, function_, lights_, view(), {}); }
    // With its scene set.
    HybridFrame beside(trace::PathTracer& screen) {
        HybridFrame frame = std::move(HybridFrame::create(device(), screen)).value();
        EXPECT_TRUE(frame.setScene(trace::Settings{}).ok());
        return frame;
    }
    // The whole view, as fine as the frame.
    FoveaAim wholeView(std::uint32_t samples) const {
        return {.whole = view(),
                .fieldDeg =
                    2.0 * glm::degrees(std::atan(std::tan(glm::radians(0.5 * view().camera.verticalFovDeg)) *
                                                 kSize.x / kSize.y)),
                .sidePx = kSize.x,
                .samplesPerPixel = samples};
    }
    static void traceFovea(HybridFrame& frame) {
        for (int i = 0; i < 10000 && frame.isTracing(); ++i) ASSERT_TRUE(frame.traceFovea(always).ok());
        ASSERT_FALSE(frame.isTracing());
    }
    // One colour everywhere, and no depths.
    Periphery plain(const glm::vec4& colour) {
        return {.draw = [this, colour](const Camera&, const glm::ivec2& sizePx) -> Result<DrawnSplats> {
            const std::vector<glm::vec4> pixels(std::size_t(sizePx.x) * std::size_t(sizePx.y), colour);
            MACULA_TRY(splats_, splat::DevicePicture::upload(device(), "plain", sizePx.x, sizePx.y, pixels));
            return DrawnSplats{&*splats_, nullptr};
        }};
    }
    static std::vector<glm::u8vec4> pictureOf(const Frame& frame, std::size_t eye = 0) {
        return gpu::read<glm::u8vec4>(*frame.pictures.at(eye)).value();
    }
    static std::size_t at(int x, int y) { return std::size_t(y) * kSize.x + std::size_t(x); }

    std::optional<splat::DevicePicture> splats_;
};

TEST_F(HybridFrameTest, TheFoveaLiesInTheMiddleOverTheSplats) {
    trace::PathTracer screen = onScreen();
    HybridFrame frame = beside(screen);
    const glm::vec4 green(0.0f, 0.5f, 0.0f, 1.0f);
    const FrameRequest request{.eyes = {view().camera}, .sizePx = kSize, .display = {}};
    const Frame without = frame.draw(request, plain(green)).value();
    EXPECT_FALSE(without.foveaAgeMs.has_value());
    EXPECT_EQ(without.foveaWeights, nullptr);
    EXPECT_TRUE(frame.wouldGrow(view().camera, 0.0)) << "there is none";
    const std::vector<glm::u8vec4> onlySplats = pictureOf(without);
    const glm::u8vec4 shownGreen = onlySplats[0];
    EXPECT_GT(shownGreen.y, 150);
    for (const glm::u8vec4& pixel : onlySplats) ASSERT_EQ(pixel, shownGreen);

    ASSERT_TRUE(frame.aim({.whole = view(), .fieldDeg = 10.0, .sidePx = 40, .samplesPerPixel = 8}).ok());
    EXPECT_FALSE(frame.isFoveaOf(view().camera));
    traceFovea(frame);
    EXPECT_TRUE(frame.isFoveaOf(view().camera));
    EXPECT_GT(frame.foveaMsPerSample().value(), 0.0);
    const Frame with = frame.draw(request, plain(green)).value();
    EXPECT_GE(with.foveaAgeMs.value(), 0.0);
    EXPECT_EQ(with.foveaSamples, 8u);
    const auto weights = gpu::read<float>(*with.foveaWeights).value();
    EXPECT_EQ(weights[at(kSize.x / 2, kSize.y / 2)], 1.0f);
    EXPECT_EQ(weights[at(2, 2)], 0.0f);
    EXPECT_TRUE(frame.wouldGrow(view().camera, 1e9)) << "it has half of its field";
    EXPECT_FALSE(frame.wouldGrow(view().camera, 0.0));
    const std::vector<glm::u8vec4> picture = pictureOf(with);
    // Nothing is in the middle of the scene: there it is black, and known to be.
    EXPECT_LT(picture[at(kSize.x / 2, kSize.y / 2)].y, 5);
    for (const auto& [x, y] : {std::pair{2, 2}, std::pair{93, 2}, std::pair{2, 69}, std::pair{93, 69}})
        EXPECT_EQ(picture[at(x, y)], shownGreen) << x << " " << y;
    frame.forgetFovea();
    EXPECT_EQ(pictureOf(frame.draw(request, plain(green)).value()), onlySplats);
}

// Where each eye sees the marker, to half a pixel, reprojected from between them: and the patient's left is
// on the right.
TEST_F(HybridFrameTest, BothEyesSeeTheMarkerWhereItIs) {
    trace::PathTracer screen = onScreen();
    HybridFrame frame = beside(screen);
    ASSERT_TRUE(frame.aim(wholeView(16)).ok());
    traceFovea(frame);
    const Camera middle = view().camera;
    const CameraBasis axes = *basis(middle);
    FrameRequest request{.eyes = {}, .sizePx = kSize, .display = {}};
    for (const double aside : {-3.2, 3.2}) {
        Camera eye = middle;
        eye.positionMm += axes.right * aside;
        eye.targetMm += axes.right * aside;
        request.eyes.push_back(eye);
    }
    const Frame drawn = frame.draw(request, plain(glm::vec4(0.0f))).value();
    ASSERT_EQ(drawn.pictures.size(), 2u);
    std::array<double, 2> column{};
    for (std::size_t eye = 0; eye < 2; ++eye) {
        const std::vector<glm::u8vec4> picture = pictureOf(drawn, eye);
        glm::dvec2 sum(0.0);
        double weight = 0.0;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const double light = picture[at(x, y)].y;
                sum += light * glm::dvec2(x + 0.5, y + 0.5);
                weight += light;
            }
        }
        ASSERT_GT(weight, 0.0);
        const glm::dvec2 found = sum / weight;
        const glm::dvec3 marker = transformPoint(volume_->worldFromVoxel(), markerVoxel_);
        const glm::dvec3 towards = marker - request.eyes[eye].positionMm;
        const double focalPx = 0.5 * kSize.y / std::tan(0.5 * glm::radians(request.eyes[eye].verticalFovDeg));
        const double along = glm::dot(towards, axes.forward);
        const glm::dvec2 right(0.5 * kSize.x + focalPx * glm::dot(towards, axes.right) / along,
                               0.5 * kSize.y - focalPx * glm::dot(towards, axes.up) / along);
        EXPECT_NEAR(found.x, right.x, 0.5) << eye;
        EXPECT_NEAR(found.y, right.y, 0.5) << eye;
        EXPECT_GT(found.x, 0.5 * kSize.x) << eye;
        column[eye] = found.x - right.x;
    }
    EXPECT_NEAR(column[0], column[1], 0.5);  // of the disparity
}

// From where the screen was traced frames show what the screen shows, whether all of it was taken or the
// middle; and no other is wanted until the eye has gone around by some degrees.
TEST_F(HybridFrameTest, WhatWasTracedAtRestIsShownInMotion) {
    trace::PathTracer screen = onScreen();
    ASSERT_TRUE(*screen.trace(8));
    const gpu::Image* shown = screen.display(glm::vec3(0.0f)).value();
    const std::vector<glm::u8vec4> traced = gpu::read<glm::u8vec4>(*shown).value();
    HybridFrame frame = beside(screen);
    const FrameRequest request{.eyes = {view().camera}, .sizePx = kSize, .display = {}};
    EXPECT_TRUE(frame.wantsFovea(view().camera));
    const double wholeDeg = wholeView(8).fieldDeg;
    for (const double fieldDeg : {wholeDeg, 0.6 * view().camera.verticalFovDeg}) {
        ASSERT_TRUE(frame.adopt(screen, {.whole = view(), .fieldDeg = fieldDeg, .samplesPerPixel = 8}).ok());
        const Frame drawn = frame.draw(request, plain(glm::vec4(0.0f, 0.5f, 0.0f, 1.0f))).value();
        EXPECT_EQ(drawn.foveaSamples, 8u);
        EXPECT_FALSE(frame.wouldGrow(view().camera, 1e9)) << "it is of all pixels";
        EXPECT_GT(drawn.foveaShare, 0.1);
        EXPECT_LE(drawn.foveaShare, 1.0);
        const std::vector<glm::u8vec4> picture = pictureOf(drawn);
        for (int y = 30; y < 42; ++y) {
            for (int x = 40; x < 56; ++x) {
                for (int k = 0; k < 3; ++k)
                    ASSERT_NEAR(picture[at(x, y)][k], traced[at(x, y)][k], 2) << x << " " << y;
            }
        }
    }
    EXPECT_GT(pictureOf(frame.draw(request, plain(glm::vec4(0.0f, 0.5f, 0.0f, 1.0f))).value())[0].y, 150)
        << "of the middle alone the corners are splats";
    EXPECT_TRUE(frame.isFoveaOf(view().camera));
    EXPECT_FALSE(frame.wantsFovea(view().camera));
    const auto eyeAt = [&](double degrees) {
        Camera eye = view().camera;
        const glm::dvec3 middle = screen.seenMm()->centre();
        const glm::dvec3 from = eye.positionMm - middle;
        const double angle = glm::radians(degrees);
        eye.positionMm = middle + glm::dvec3(std::cos(angle) * from.x - std::sin(angle) * from.y,
                                             std::sin(angle) * from.x + std::cos(angle) * from.y, from.z);
        return eye;
    };
    EXPECT_FALSE(frame.wantsFovea(eyeAt(0.5 * HybridFrame::kGoodForDeg)));
    EXPECT_TRUE(frame.wantsFovea(eyeAt(1.5 * HybridFrame::kGoodForDeg)));
    // It is of the middle, and an eye that looks aside sees its end; and of one distance.
    EXPECT_FALSE(frame.wantsFovea(view().camera, {0.1, -0.1}));
    EXPECT_TRUE(frame.wantsFovea(view().camera, {0.9, 0.0}));
    EXPECT_TRUE(frame.wouldGrow(view().camera, 0.0, {0.0, 0.9}));
    const auto nearer = [&](double share) {
        Camera eye = view().camera;
        const glm::dvec3 middle = screen.seenMm()->centre();
        eye.positionMm = middle + (eye.positionMm - middle) * share;
        return eye;
    };
    EXPECT_FALSE(frame.wantsFovea(nearer(0.9)));
    EXPECT_TRUE(frame.wantsFovea(nearer(0.7)));
    EXPECT_FALSE(frame.wantsFovea(nearer(1.5))) << "smaller is as sharp";
    Camera zoomed = view().camera;
    zoomed.verticalFovDeg *= 0.5;
    EXPECT_TRUE(frame.wantsFovea(zoomed));
    // One that was traced for motion is coarse: another place, another one.
    ASSERT_TRUE(frame.aim(wholeView(1)).ok());
    traceFovea(frame);
    EXPECT_FALSE(frame.wantsFovea(view().camera));
    EXPECT_TRUE(frame.wantsFovea(eyeAt(0.1)));
    ASSERT_TRUE(frame.setScene(trace::Settings{}).ok());
    EXPECT_TRUE(frame.wantsFovea(view().camera)) << "another scene, another fovea";
}

// The same samples, because each frame's first fovea has the same noise.
TEST_F(HybridFrameTest, AFoveaIsDenoisedAsItsAimSays) {
    trace::PathTracer screen = onScreen();
    const auto shown = [&](trace::Denoising denoising) {
        HybridFrame frame = beside(screen);
        FoveaAim aim = wholeView(1);
        aim.denoising = denoising;
        EXPECT_TRUE(frame.aim(aim).ok());
        traceFovea(frame);
        return pictureOf(
            frame.draw({.eyes = {view().camera}, .sizePx = kSize, .display = {}}, plain(glm::vec4(0.0f)))
                .value());
    };
    const auto roughness = [](const std::vector<glm::u8vec4>& picture) {
        int sum = 0;
        for (std::size_t i = 1; i < picture.size(); ++i)
            sum += std::abs(int(picture[i].y) - int(picture[i - 1].y));
        return sum;
    };
    const std::vector<glm::u8vec4> noisy = shown(trace::Denoising::off);
    EXPECT_GT(roughness(noisy), 0);
    EXPECT_LT(roughness(shown(trace::Denoising::on)), roughness(noisy));
    EXPECT_EQ(shown(trace::Denoising::off), noisy);
}

// Over what it shows itself a fovea of few samples has no weight; over splats that show something else it has
// all that its place gives it, and so it has where they know nothing.
TEST_F(HybridFrameTest, AFoveaWeighsAsMuchAsItIsBetterThanTheSplats) {
    trace::PathTracer screen = onScreen();
    ASSERT_TRUE(*screen.trace(2));
    const std::vector<glm::vec4> traced = screen.readback()->radiance;
    const std::vector<glm::vec4> bright(traced.size(), glm::vec4(9.0f, 9.0f, 9.0f, 1.0f));
    const gpu::Buffer depthSums =
        std::move(*gpu::Buffer::create(device(), {.bytes = traced.size() * sizeof(float)}));
    ASSERT_TRUE(gpu::uploadTo<float>(depthSums, std::vector<float>(traced.size())).ok());
    const auto showing = [&](const std::vector<glm::vec4>& pixels, bool isLikeness = true) {
        return Periphery{.draw = [&](const Camera&, const glm::ivec2& sizePx) -> Result<DrawnSplats> {
                             EXPECT_EQ(sizePx, kSize);
                             MACULA_TRY(splats_, splat::DevicePicture::upload(device(), "known", sizePx.x,
                                                                              sizePx.y, pixels));
                             return DrawnSplats{&*splats_, &depthSums};
                         },
                         .isLikeness = isLikeness};
    };
    HybridFrame frame = beside(screen);
    const FrameRequest request{.eyes = {view().camera}, .sizePx = kSize, .display = {}};
    const auto weightOfMarker = [&](const Periphery& periphery) {
        const Frame drawn = frame.draw(request, periphery).value();
        const auto weights = gpu::read<float>(*drawn.foveaWeights).value();
        double most = 0.0;
        for (std::size_t i = 0; i < traced.size(); ++i)
            if (traced[i].w > 0.5f) most = std::max(most, double(weights[i]));
        return most;
    };
    ASSERT_TRUE(frame.adopt(screen, wholeView(2)).ok());
    EXPECT_GT(weightOfMarker(showing(traced, false)), 0.95) << "they are no likeness yet";
    EXPECT_LT(weightOfMarker(showing(traced)), 0.01);
    EXPECT_LT(weightOfMarker(showing(bright)), 0.01) << "it is weighed once";
    EXPECT_GT(weightOfMarker(showing(bright, false)), 0.95) << "the model was given up";
    EXPECT_GT(weightOfMarker(showing(bright)), 0.95) << "they are something else";
    ASSERT_TRUE(frame.adopt(screen, wholeView(1024)).ok());
    EXPECT_LT(weightOfMarker(showing(traced)), 0.01) << "noise counts, not what was asked for";
}

// With all pixels, what is traced is shown as far as it is better, and the fovea of before is not.
TEST_F(HybridFrameTest, WhatFadesInIsWeighedAgainstTheSplats) {
    trace::PathTracer screen = onScreen();
    ASSERT_TRUE(*screen.trace(2));
    const std::vector<glm::vec4> traced = screen.readback()->radiance;
    HybridFrame frame = beside(screen);
    ASSERT_TRUE(frame.adopt(screen, wholeView(2)).ok());
    const glm::vec4 green(0.0f, 0.5f, 0.0f, 1.0f);
    const auto drawn = [&](const trace::TracedLight& light, float share) {
        const Frame made = frame
                               .draw({.eyes = {view().camera},
                                      .sizePx = kSize,
                                      .display = {},
                                      .fadingIn = FadingIn{.light = light, .share = share}},
                                     plain(green))
                               .value();
        EXPECT_EQ(made.foveaWeights == nullptr, share >= 1.0f);
        return pictureOf(made);
    };
    const auto displayed = gpu::read<glm::u8vec4>(*screen.display(glm::vec3(0.0f)).value()).value();
    const trace::TracedLight plainly = screen.light().value();
    EXPECT_EQ(plainly.variances, nullptr);
    const std::vector<glm::u8vec4> whole = drawn(plainly, 1.0f);
    for (std::size_t i = 0; i < whole.size(); ++i)
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(whole[i][k], displayed[i][k], 2) << i;
    // Green splats are wrong everywhere: nothing of them is left where there is no noise, and little beside
    // the marker, whose samples differ.
    const std::vector<glm::u8vec4> weighed = drawn(screen.noisyLight().value(), 1.0f);
    EXPECT_EQ(weighed[0], displayed[0]);
    EXPECT_NE(weighed, whole);
    for (std::size_t i = 0; i < weighed.size(); ++i) {
        if (traced[i].w == 0.0f) {
            ASSERT_NEAR(weighed[i].y, displayed[i].y, 120) << i;
        }
    }
    drawn(plainly, 0.5f);
}

TEST_F(HybridFrameTest, AFarEyeIsNotShownTheFovea) {
    trace::PathTracer screen = onScreen();
    HybridFrame frame = beside(screen);
    ASSERT_TRUE(frame.aim(wholeView(1)).ok());
    traceFovea(frame);
    Camera eye = view().camera;
    EXPECT_TRUE(frame.showsFoveaTo(eye));
    EXPECT_FALSE(frame.showsFoveaTo(inParallel(eye))) << "it is reprojected for an eye";
    eye.positionMm = screen.seenMm()->centre() + glm::dvec3(glm::length(eye.positionMm), 0.0, 0.0);
    EXPECT_FALSE(frame.showsFoveaTo(eye));
    const Frame drawn =
        frame.draw({.eyes = {eye}, .sizePx = kSize, .display = {}}, plain(glm::vec4(0.5f))).value();
    EXPECT_FALSE(drawn.foveaAgeMs.has_value());
}

TEST_F(HybridFrameTest, ABudgetShrinksWithSpeed) {
    trace::PathTracer screen = onScreen();
    HybridFrame frame = beside(screen);
    EXPECT_EQ(frame.foveaBudgetMs(250.0), 250.0);
    Camera eye = view().camera;
    const double distanceMm = glm::length(eye.positionMm);
    for (int degrees = 0; degrees < 90; degrees += 15) {
        const double angle = glm::radians(double(degrees));
        eye.positionMm = eye.targetMm + distanceMm * glm::dvec3(std::sin(angle), -std::cos(angle), 0.0);
        ASSERT_TRUE(
            frame.draw({.eyes = {eye}, .sizePx = {8, 8}, .display = {}}, plain(glm::vec4(0.0f))).ok());
    }
    EXPECT_LT(frame.foveaBudgetMs(250.0), 60.0);
    EXPECT_GT(frame.foveaBudgetMs(250.0), 0.0);
}

TEST_F(HybridFrameTest, AnInterruptedFoveaGoesOnAndAnotherSceneDropsIt) {
    trace::PathTracer screen = onScreen();
    HybridFrame frame = beside(screen);
    ASSERT_TRUE(frame.aim(wholeView(2)).ok());
    int calls = 0;
    while (frame.isTracing() && calls < 10000) {
        ASSERT_TRUE(frame.traceFovea(never).ok());
        ++calls;
    }
    EXPECT_FALSE(frame.isTracing());
    EXPECT_GT(calls, 1);
    EXPECT_TRUE(frame.isFoveaOf(view().camera));
    ASSERT_TRUE(frame.aim(wholeView(2)).ok());
    ASSERT_TRUE(frame.setScene({.exposure = 2.0}).ok());
    EXPECT_FALSE(frame.isTracing());
    EXPECT_FALSE(frame.isFoveaOf(view().camera));
    EXPECT_EQ(frame.exposure(), 2.0);
}

TEST_F(HybridFrameTest, BadInputIsAnErrorAndTheFrameGoesOn) {
    trace::PathTracer screen = onScreen();
    HybridFrame frame = beside(screen);
    ASSERT_TRUE(frame.aim(wholeView(1)).ok());
    traceFovea(frame);
    FoveaAim bad = wholeView(1);
    bad.whole.camera.positionMm.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(frame.aim(bad).error().code, ErrorCode::usage);
    bad = wholeView(1);
    bad.fieldDeg = 0.0;
    EXPECT_EQ(frame.aim(bad).error().code, ErrorCode::usage);
    bad = wholeView(1);
    bad.gaze = glm::dvec2(std::numeric_limits<double>::infinity());
    EXPECT_FALSE(frame.aim(bad).ok());
    EXPECT_FALSE(frame.isTracing());
    EXPECT_TRUE(frame.isFoveaOf(view().camera));
    for (const glm::ivec2& sizePx : {glm::ivec2(1), glm::ivec2(1, 300), glm::ivec2(3840, 2160)}) {
        const auto drawn =
            frame.draw({.eyes = {view().camera}, .sizePx = sizePx, .display = {}}, plain(glm::vec4(0.1f)));
        ASSERT_TRUE(drawn.ok());
        EXPECT_EQ(drawn->pictures[0]->extent().width, std::uint32_t(sizePx.x));
    }
    // The eye within the anatomy, and on the other side of it.
    Camera inside = view().camera;
    inside.positionMm = screen.seenMm()->centre();
    EXPECT_TRUE(frame.draw({.eyes = {inside}, .sizePx = kSize, .display = {}}, plain(glm::vec4(0.1f))).ok());
}

TEST_F(HybridFrameTest, ALostDeviceIsTold) {
    const std::shared_ptr<gpu::Device> own = *gpu::Device::create(instance());
    trace::PathTracer screen = *trace::PathTracer::create(own);
    ASSERT_TRUE(screen.scene().setVolume(volume_).ok());
    ASSERT_TRUE(screen.scene().setTransferFunction(function_).ok());
    ASSERT_TRUE(screen.scene().setEnvironment(lights_).ok());
    HybridFrame frame = *HybridFrame::create(own, screen);
    ASSERT_TRUE(frame.setScene(trace::Settings{}).ok());
    ASSERT_TRUE(frame.aim(wholeView(4)).ok());
    loseDeviceAt(VulkanCall::submit, 2, 1);
    Result<bool> traced = true;
    for (int i = 0; i < 100 && traced.ok() && frame.isTracing(); ++i) traced = frame.traceFovea(always);
    loseDeviceAt(VulkanCall::submit, 1, 0);
    ASSERT_FALSE(traced.ok());
    EXPECT_EQ(traced.error().code, ErrorCode::deviceLost);
}

}  // namespace
}  // namespace macula::hybrid
