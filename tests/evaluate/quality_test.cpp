// The parts of macula-bench evaluate quality that need no device: time, pictures, scores, and what is told of
// them.
#include "evaluate/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "evaluate/benchmark_reports.h"
#include "evaluate/frame_makers.h"
#include "evaluate/shown_picture.h"

namespace macula::evaluate {
namespace {

constexpr glm::ivec2 kSize{64, 64};
constexpr TracingCost kCost{.fixedMs = 10.0, .perSampleMs = 5.0};

image::Image pictureOf(const glm::ivec2& size, std::vector<float> pixels, int channels = 1) {
    return {.width = size.x,
            .height = size.y,
            .channels = channels,
            .encoding = image::Encoding::display,
            .pixels = std::move(pixels)};
}

TEST(EqualTime, HasAsManySamplesAsThereIsTimeFor) {
    EXPECT_EQ(affordable(kCost, 27.0, kSize), (TracingBudget{.sizePx = kSize, .samplesPerPixel = 3}));
    EXPECT_EQ(affordable(kCost, 15.0, kSize), (TracingBudget{.sizePx = kSize, .samplesPerPixel = 1}));
    EXPECT_EQ(resolutionShareOf(affordable(kCost, 27.0, kSize), kSize), 1.0);
}

TEST(EqualTime, TracesFewerPixelsWhereNotOneSampleFits) {
    const TracingBudget quarter = affordable(kCost, 15.0 / 4.0, kSize);
    EXPECT_EQ(quarter, (TracingBudget{.sizePx = {32, 32}, .samplesPerPixel = 1}));
    EXPECT_DOUBLE_EQ(resolutionShareOf(quarter, kSize), 0.5);
    for (const double budgetMs : {14.9, 7.0, 2.0}) {
        const TracingBudget budget = affordable(kCost, budgetMs, kSize);
        const double share = resolutionShareOf(budget, kSize);
        EXPECT_LT(share, 1.0) << budgetMs;
        EXPECT_LE(share * share * (kCost.fixedMs + kCost.perSampleMs), budgetMs);
    }
    EXPECT_EQ(affordable(kCost, 0.0, kSize).sizePx, glm::ivec2(kLeastSidePx));
    EXPECT_EQ(affordable(kCost, 0.0, {4, 4}).sizePx, glm::ivec2(4));
}

TEST(EqualTime, KnowsTheWholeByAPart) {
    const TracingBudget part{.sizePx = {32, 32}, .samplesPerPixel = 2};
    const TracingCost whole = costOfWhole(2.5, 2.5, part, kSize);
    EXPECT_DOUBLE_EQ(whole.fixedMs, kCost.fixedMs);
    EXPECT_DOUBLE_EQ(whole.perSampleMs, kCost.perSampleMs);
}

TEST(ShownPicture, IsScaledBetweenTheCentresOfItsPixels) {
    EXPECT_EQ(scaledTo(pictureOf({2, 1}, {0.0f, 1.0f}), {4, 1}).pixels,
              (std::vector<float>{0.0f, 0.25f, 0.75f, 1.0f}));
    EXPECT_EQ(scaledTo(pictureOf({1, 2}, {0.0f, 1.0f}), {1, 4}).pixels,
              (std::vector<float>{0.0f, 0.25f, 0.75f, 1.0f}));
    const image::Image colours = pictureOf({2, 1}, {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f}, 3);
    EXPECT_EQ(scaledTo(colours, {2, 1}).pixels, colours.pixels);
    for (const float value : scaledTo(pictureOf({3, 2}, std::vector<float>(6, 0.5f)), {7, 5}).pixels)
        EXPECT_FLOAT_EQ(value, 0.5f);
}

TEST(ShownPicture, HasAFoveaAsFineAsItself) {
    constexpr glm::ivec2 size{200, 150};
    const double radiusPx = 75.0 * std::tan(glm::radians(10.0)) / std::tan(glm::radians(35.0));
    EXPECT_EQ(foveaSidePx(size, 70.0), std::lround(2.0 * radiusPx));
    EXPECT_EQ(foveaSidePx(size, trace::kFovealFieldDeg), 150);
}

// A corner that is wrong is outside of the middle.
TEST(FrameScores, TellTheMiddleFromTheWhole) {
    constexpr glm::ivec2 size{48, 48};
    hybrid::TruthPicture picture;
    for (hybrid::TracedView& half : picture.halves) {
        half.sizePx = size;
        half.rgba.assign(48 * 48, glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
    }
    const FrameTruth truth = frameTruthOf(picture);
    EXPECT_EQ(truth.covered, image::Mask(48 * 48, 1));
    EXPECT_EQ(truth.coveredInMiddle, truth.middle);
    const auto same = frameScoresOf(truth, truth.shown);
    ASSERT_TRUE(same);
    EXPECT_FALSE(same->full.maskedPsnrDb) << "not finite";
    EXPECT_NEAR(same->full.maskedSsim.value(), 1.0, 1e-6);
    image::Image wrong = truth.shown;
    for (std::size_t c = 0; c < 3; ++c) wrong.pixels[c] -= 0.1f;
    const auto scores = frameScoresOf(truth, wrong);
    ASSERT_TRUE(scores);
    EXPECT_NEAR(scores->full.maskedPsnrDb.value(), -10.0 * std::log10(0.01 / (48.0 * 48.0)), 1e-3);
    EXPECT_GT(scores->full.flip.value(), 0.0);
    EXPECT_LT(scores->full.maskedSsim.value(), 1.0);
    EXPECT_FALSE(scores->fovea.maskedPsnrDb);
    EXPECT_NEAR(scores->fovea.flip.value(), 0.0, 1e-6);
    EXPECT_NEAR(scores->fovea.maskedSsim.value(), 1.0, 1e-6);
}

QualityRow rowOf(std::string way, const std::vector<std::optional<double>>& db, double foveaOffsetDb) {
    QualityRow row{.way = std::move(way), .model = "fresh", .splats = 7, .preparationSeconds = 1.5};
    for (const auto& value : db) {
        QualityView view{.frameMs = 10.0 + double(row.views.size()), .resolutionShare = 0.5};
        view.scores.full.maskedPsnrDb = value;
        if (value) view.scores.fovea.maskedPsnrDb = *value + foveaOffsetDb;
        row.views.push_back(view);
    }
    return row;
}

TEST(Quality, GainsAreOfEachViewByItself) {
    const QualityRow hybrid = rowOf("hybrid", {20.0, 22.0, 24.0, std::nullopt}, 3.0);
    QualityRow equal = rowOf("pt-equal", {19.0, 25.0, 24.0, 20.0}, 0.0);
    for (QualityView& view : equal.views) view.frameMs *= 0.75;
    const QualityRow splats = rowOf("splats", {18.0, 21.0, 24.0, 20.0}, 0.0);
    const QualityGain gain = gainOf(hybrid, equal, splats);
    EXPECT_EQ(gain.way, "hybrid");
    EXPECT_EQ(gain.model, "fresh");
    ASSERT_TRUE(gain.foveaDb && gain.fullOverSplatsDb);
    EXPECT_EQ(gain.foveaDb->count, 3u);  // of 4, 0 and 3
    EXPECT_DOUBLE_EQ(gain.foveaDb->p50, 3.0);
    EXPECT_DOUBLE_EQ(gain.foveaDb->p10, 0.6);
    EXPECT_DOUBLE_EQ(gain.foveaDb->p90, 3.8);
    EXPECT_DOUBLE_EQ(gain.equalTimeShare->p90, 0.75);
    EXPECT_DOUBLE_EQ(gain.fullOverSplatsDb->p50, 1.0);  // of 2, 1 and 0
}

TEST(Quality, ARowIsToldWithItsSpread) {
    const auto json = toJson(rowOf("hybrid-hq", {20.0, std::nullopt, 22.0}, 1.0));
    EXPECT_EQ(json["way"], "hybrid-hq");
    EXPECT_EQ(json["model"], "fresh");
    EXPECT_EQ(json["splats"], 7);
    EXPECT_EQ(json["preparationSeconds"], 1.5);
    EXPECT_EQ(json["frameMs"]["median"], 11.0);
    EXPECT_DOUBLE_EQ(json["frameMs"]["p10"].get<double>(), 10.2);
    EXPECT_DOUBLE_EQ(json["frameMs"]["p90"].get<double>(), 11.8);
    EXPECT_EQ(json["resolutionShare"]["median"], 0.5);
    EXPECT_TRUE(json["samplesPerPixel"].is_null()) << "nothing was traced";
    EXPECT_EQ(json["full"]["maskedPsnrDb"]["median"], 21.0);
    EXPECT_EQ(json["fovea"]["maskedPsnrDb"]["median"], 22.0);
    EXPECT_TRUE(json["fovea"]["flip"].is_null());
    EXPECT_TRUE(json["stagesMs"]["trace"].is_null()) << "none of them has a fovea";
    QualityRow foveal = rowOf("hybrid", {20.0, 21.0, 22.0}, 1.0);  // in 10, 11 and 12 ms
    for (QualityView& view : foveal.views)
        view.foveaTimes = hybrid::FoveaTimes{.traceMs = 4.0, .developMs = 2.0, .captureMs = 0.5};
    const auto stages = toJson(foveal)["stagesMs"];
    EXPECT_EQ(stages["trace"]["median"], 4.0);
    EXPECT_EQ(stages["guidesAndFilter"]["median"], 2.0);
    EXPECT_EQ(stages["capture"]["median"], 0.5);
    EXPECT_EQ(stages["rest"]["median"], 4.5);
    const auto traced = toJson(QualityRow{.way = "pt"});
    EXPECT_TRUE(traced["model"].is_null());
    EXPECT_TRUE(traced["splats"].is_null());
    EXPECT_TRUE(traced["preparationSeconds"].is_null());
}

TEST(Quality, HighHasMoreOfEverything) {
    for (const std::uint32_t samples : {1u, 4u}) {
        const QualityOptions options{.foveaSamples = samples, .iterations = 20};
        const GradePlan normal = planOf(options, Grade::normal);
        const GradePlan high = planOf(options, Grade::high);
        EXPECT_EQ(normal.foveaSamples, samples);
        EXPECT_EQ(normal.model.iterations, 20u);
        EXPECT_GE(normal.wholeSamples, 1u);
        EXPECT_GT(high.foveaSamples, normal.foveaSamples);
        EXPECT_GT(high.wholeSamples, normal.wholeSamples);
        EXPECT_GT(high.model.views, normal.model.views);
        EXPECT_GT(high.model.samplesPerPixel, normal.model.samplesPerPixel);
        EXPECT_GT(high.model.iterations, normal.model.iterations);
        EXPECT_GE(high.model.capacity, high.model.points.count);
        for (const GradePlan& plan : {normal, high}) {
            EXPECT_EQ(plan.model.bounces, options.bounces);
            EXPECT_EQ(plan.refinement.bounces, options.bounces);
            EXPECT_GT(plan.refinement.capacity, plan.model.capacity);
        }
    }
    const QualityOptions small{.sizePx = {48, 48}};
    EXPECT_EQ(planOf(small, Grade::high).model.sizePx, 48) << "no finer than what is compared";
    EXPECT_EQ(planOf(small, Grade::high).refinement.sizePx, 48);
}

}  // namespace
}  // namespace macula::evaluate
