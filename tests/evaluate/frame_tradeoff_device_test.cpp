// Error against time of frames of the phantom, so small that numbers mean little: what must hold of them all.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "evaluate/frame_tradeoff.h"
#include "gpu/shared_device.h"
#include "scene/choice/lights_choice.h"

namespace macula::evaluate {
namespace {

constexpr int kSidePx = 48;

class FrameTradeoffOnDevice : public gpu::SharedDeviceTest {
  protected:
    static BenchStudy phantom() {
        Progress progress;
        BenchStudy study =
            std::move(
                openBenchStudy({.preset = "cinematic-bone", .lights = scene::kDefaultLights, .size = kSidePx},
                               progress))
                .value();
        study.device = device();
        return study;
    }
    static FrameTradeoffOptions few() {
        FrameTradeoffOptions options{.sizePx = glm::ivec2(kSidePx), .truthSamples = 32};
        options.model = {.points = {.count = 300},
                         .views = 4,
                         .samplesPerPixel = 1,
                         .directions = 6,
                         .iterations = 20,
                         .capacity = 330};
        options.models = {.views = {2}, .iterations = {0.5}, .splats = {2.0}};
        options.frames = {
            .fieldsDeg = {20.0, 25.0}, .samplesPerPixel = {16, 32}, .bounces = {8}, .framesPerFovea = {1, 2}};
        return options;
    }
};

void expectMonotonic(std::vector<CostAndError> front) {
    ASSERT_FALSE(front.empty());
    std::sort(front.begin(), front.end(),
              [](const CostAndError& a, const CostAndError& b) { return a.cost < b.cost; });
    for (std::size_t i = 1; i < front.size(); ++i) {
        EXPECT_GT(front[i].cost, front[i - 1].cost);
        EXPECT_LT(front[i].error, front[i - 1].error);
    }
}

TEST_F(FrameTradeoffOnDevice, TellsWhatTimeBuys) {
    const BenchStudy study = phantom();
    const FrameTradeoffOptions options = few();
    Progress progress;
    const auto measured = measureFrameTradeoff(study, options, progress);
    ASSERT_TRUE(measured) << measured.error().message;
    const std::vector<FramePoint>& frames = measured->frames;
    ASSERT_EQ(measured->models.size(), 4u);
    ASSERT_EQ(frames.size(), 1u + 8u * 4u);
    for (const ModelPoint& model : measured->models) {
        EXPECT_GT(model.splats, 0u);
        EXPECT_GT(model.preparationSeconds, 0.0);
        EXPECT_GT(model.drawMs, 0.0);
        EXPECT_GT(model.errors.flip, 0.0);
    }
    EXPECT_FALSE(frames[0].recipe);
    EXPECT_EQ(frames[0].errors.flip, measured->models.front().errors.flip);
    double best = 1.0;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        EXPECT_GT(frames[i].ms(), frames[0].ms()) << i;
        EXPECT_GT(frames[i].foveaMs, 0.0) << i;
        best = std::min(best, frames[i].errors.fovealFlip);
        if (frames[i].recipe->framesPerFovea > 1 || !frames[i].recipe->isWarped) continue;
        // Of a fovea that was traced from here: the one before it is the same, left where it was.
        ASSERT_FALSE(frames[i - 1].recipe->isWarped);
        EXPECT_NEAR(frames[i].errors.flip, frames[i - 1].errors.flip, 1e-3) << i;
        EXPECT_NEAR(frames[i].errors.fovealFlip, frames[i - 1].errors.fovealFlip, 1e-3) << i;
    }
    EXPECT_LT(best, frames[0].errors.fovealFlip) << "a fovea is better than splats of so few steps";
    EXPECT_TRUE(frames[0].onFront && frames[0].onFovealFront) << "nothing is as cheap";

    std::vector<CostAndError> front;
    std::vector<CostAndError> fovealFront;
    for (const FramePoint& frame : frames) {
        if (frame.onFront) front.push_back({frame.ms(), frame.errors.flip});
        if (frame.onFovealFront) fovealFront.push_back({frame.ms(), frame.errors.fovealFlip});
    }
    expectMonotonic(front);
    expectMonotonic(fovealFront);

    const auto report = reportOf(study, options, *measured);
    EXPECT_EQ(report["benchmark"], "tradeoff");
    EXPECT_EQ(report["picture"], (nlohmann::ordered_json{kSidePx, kSidePx}));
    for (const char* key : {"verticalFovDeg", "foveaFieldDeg", "degreesPerFrame", "truthSamplesPerPixel",
                            "truthBounces", "modelBounces"})
        EXPECT_TRUE(report.at(key).is_number()) << key;
    EXPECT_EQ(report["models"].size(), measured->models.size());
    EXPECT_EQ(report["frames"].size(), frames.size());
}

TEST_F(FrameTradeoffOnDevice, WhatCannotBeIsAnError) {
    const BenchStudy study = phantom();
    FrameTradeoffOptions options = few();
    options.truthSamples = 3;
    Progress progress;
    EXPECT_EQ(measureFrameTradeoff(study, options, progress).error().code, ErrorCode::usage);
    CancelToken stop;
    stop.cancel();
    Progress stopped({}, stop);
    EXPECT_EQ(measureFrameTradeoff(study, few(), stopped).error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::evaluate
