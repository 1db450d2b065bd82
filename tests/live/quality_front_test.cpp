// The trades of time for error, as they were measured and as they are on this machine.
#include "live/quality/quality_front.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace macula::live {
namespace {

QualityFront builtIn() {
    auto front = builtInQualityFront();
    EXPECT_TRUE(front.ok()) << front.error().message << " " << front.error().hint;
    return *std::move(front);
}

const WindowView kWindow{.sizePx = {1280, 720}, .verticalFovDeg = 30.0};

WindowView asMeasured(const QualityFront& front) {
    return {.sizePx = front.sizePx, .verticalFovDeg = front.verticalFovDeg};
}

TEST(QualityFront, StopsGoFromFastToAccurate) {
    const QualityFront front = builtIn();
    ASSERT_GE(front.stops.size(), 4u);
    EXPECT_FALSE(front.stops.front().fovea) << "splats alone are the fastest";
    for (std::size_t i = 1; i < front.stops.size(); ++i) {
        EXPECT_GT(front.stops[i].ms, front.stops[i - 1].ms);
        EXPECT_LT(front.stops[i].fovealFlip, front.stops[i - 1].fovealFlip);
    }
    // Whatever is no stop is beaten by one of them.
    for (const FrontPoint& point : front.points) {
        bool isStopOrBeaten = false;
        for (const FrontPoint& stop : front.stops)
            isStopOrBeaten |= point == stop || (stop.ms <= point.ms && stop.fovealFlip <= point.fovealFlip);
        EXPECT_TRUE(isStopOrBeaten) << point.ms;
    }
}

TEST(QualityFront, OnTheMachineThatMeasuredCostsAreThoseThatWereMeasured) {
    const QualityFront front = builtIn();
    for (const FrontPoint& stop : front.stops)
        EXPECT_NEAR(costOf(front, stop, asMeasured(front), 1.0).ms(), stop.ms, 0.01 * stop.ms) << stop.ms;
}

TEST(QualityFront, CostsGoWithTheMachineAndTheWindow) {
    const QualityFront front = builtIn();
    for (const FrontPoint& stop : front.stops) {
        const FrameCost here = costOf(front, stop, kWindow, 1.0);
        const FrameCost slower = costOf(front, stop, kWindow, 3.0);
        EXPECT_NEAR(slower.drawMs, 3.0 * here.drawMs, 1e-9);
        EXPECT_NEAR(slower.foveaMs, 3.0 * here.foveaMs, 1e-6 * slower.foveaMs);
        EXPECT_GT(here.drawMs, costOf(front, stop, asMeasured(front), 1.0).drawMs) << "more pixels";
        EXPECT_LE(here.betweenMs, kMostBetweenFramesMs);
    }
    // A fovea of 20 degrees has as many more pixels as the window has to the degree.
    const auto& stop = front.stops.at(2);
    ASSERT_TRUE(stop.fovea);
    ASSERT_EQ(stop.fovea->request.fieldDeg, 20.0);
    const double finer = (720.0 / std::tan(glm::radians(15.0))) / (128.0 / std::tan(glm::radians(20.0)));
    EXPECT_NEAR(
        costOf(front, stop, kWindow, 1.0).foveaMs / costOf(front, stop, asMeasured(front), 1.0).foveaMs,
        finer * finer, 0.05 * finer * finer);
}

TEST(QualityFront, ExtremeWindowsAndMachinesHaveACost) {
    const QualityFront front = builtIn();
    for (const WindowView& view : {WindowView{{1, 1}, 30.0}, WindowView{{16384, 1}, 0.1},
                                   WindowView{{0, 0}, 170.0}, WindowView{{16384, 16384}, 30.0}}) {
        for (const double slowness : {1e-6, 1.0, 1e6}) {
            for (const FrontPoint& stop : front.stops) {
                const FrameCost cost = costOf(front, stop, view, slowness);
                EXPECT_TRUE(std::isfinite(cost.ms()));
                EXPECT_GT(cost.ms(), 0.0);
                const LiveQuality quality = liveQualityOf(stop, cost);
                EXPECT_EQ(quality.hasFovea, stop.fovea.has_value());
                EXPECT_GE(quality.foveaMs, hybrid::kFoveaBudgetMs);
                EXPECT_GT(quality.betweenFramesMs, 0.0);
                EXPECT_GE(quality.fovea.samplesPerPixel, 1u);
            }
        }
    }
}

// Noise and sharpness, and nothing that light does.
TEST(QualityFront, AStopIsWhatWasMeasuredThere) {
    const QualityFront front = builtIn();
    for (const FrontPoint& stop : front.stops) {
        const LiveQuality quality = liveQualityOf(stop, costOf(front, stop, kWindow, 1.0));
        if (!stop.fovea) continue;
        EXPECT_EQ(quality.fovea, stop.fovea->request);
    }
    EXPECT_EQ(stopOf(front, asMeasured(front), 1.0, 1e9), front.stops.size() - 1);
    EXPECT_EQ(stopOf(front, asMeasured(front), 1.0, 0.0), 0u);
    EXPECT_EQ(stopOf(front, asMeasured(front), 1.0, front.stops[2].ms * 1.05), 2u);
}

TEST(QualityFront, WhatIsWrongIsSaid) {
    const std::string good =
        R"({"version":1,"name":"a","title":"A","source":"S","sizePx":[128,128],"verticalFovDeg":40,"bounces":16,
        "calibrationMs":100,"drawing":[{"pixels":100,"ms":1},{"pixels":200,"ms":2}],
        "points":[{"ms":9,"flip":0.1,"fovealFlip":0.1},{"ms":12,"flip":0.09,"fovealFlip":0.09}]})";
    const auto read = qualityFrontFromJson(good, "a.json");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->stops.size(), 2u);
    const auto refused = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        const auto bad = qualityFrontFromJson(text, "a.json");
        ASSERT_FALSE(bad.ok()) << to;
        EXPECT_EQ(bad.error().code, ErrorCode::inputNotUsable);
    };
    refused("\"version\":1", "\"version\":2");
    refused("\"bounces\":16", "\"bounces\":1.5");
    refused("\"calibrationMs\":100", "\"calibrationMs\":0");
    refused("\"pixels\":200", "\"pixels\":100");
    refused("\"fovealFlip\":0.09", "\"fovealFlip\":0.11");  // slower and worse
    refused("\"fovealFlip\":0.09", "\"fovealFlip\":1e400");
    refused("\"ms\":12", "\"ms\":-1");
    refused("\"title\":\"A\"", "\"title\":\"A\",\"more\":1");
    refused("]}", "]");
}

}  // namespace
}  // namespace macula::live
