#include "evaluate/view_scores.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "evaluate/evaluation_report.h"

namespace macula::evaluate {
namespace {

constexpr glm::ivec2 kSize{24, 16};

std::vector<glm::vec4> ball(float light) {
    std::vector<glm::vec4> rgba;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x) {
            const bool inside = std::hypot(x - 12.0, y - 8.0) < 6.0;
            rgba.push_back(inside ? glm::vec4(light * float(x) / 24.0f, 0.5f * light, 0.2f * light, 1.0f)
                                  : glm::vec4(0.0f));
        }
    }
    return rgba;
}

hybrid::TruthPicture truthOf(std::vector<glm::vec4> first, std::vector<glm::vec4> second) {
    hybrid::TruthPicture truth;
    truth.halves[0].sizePx = truth.halves[1].sizePx = kSize;
    truth.halves[0].rgba = std::move(first);
    truth.halves[1].rgba = std::move(second);
    return truth;
}

TEST(ViewScores, OfTheTruthItselfAreWithoutError) {
    const auto scores = scoresOf(truthOf(ball(0.5f), ball(0.5f)), ball(0.5f));
    ASSERT_TRUE(scores) << scores.error().message;
    EXPECT_FALSE(scores->psnrDb);  // not finite
    EXPECT_FALSE(scores->maskedPsnrDb);
    EXPECT_NEAR(scores->flip.value(), 0.0, 1e-6);
    EXPECT_NEAR(scores->maskedSsim.value(), 1.0, 1e-6);
    EXPECT_NEAR(scores->luminanceRatio.value(), 1.0, 1e-6);
    EXPECT_NEAR(scores->coverageError.value(), 0.0, 1e-6);
    EXPECT_NEAR(scores->truthNoise.value(), 0.0, 1e-6);
}

// The whole picture holds empty pixels that are right: it is better by the share that the ball has of it.
TEST(ViewScores, MaskedOnesLookAtTheBallAlone) {
    const auto scores = scoresOf(truthOf(ball(0.5f), ball(0.5f)), ball(0.4f));
    ASSERT_TRUE(scores);
    const std::vector<glm::vec4> pixels = ball(1.0f);
    const auto inside =
        std::count_if(pixels.begin(), pixels.end(), [](const glm::vec4& p) { return p.w > 0.0f; });
    const double share = double(inside) / double(pixels.size());
    EXPECT_NEAR(scores->psnrDb.value() - scores->maskedPsnrDb.value(), -10.0 * std::log10(share), 1e-6);
    EXPECT_NEAR(scores->maskedPsnrDb.value(), scores->coveredPsnrDb.value(), 1e-9);
    EXPECT_LT(scores->luminanceRatio.value(), 1.0);
    const auto nothing = scoresOf(truthOf(ball(0.5f), ball(0.5f)), std::vector<glm::vec4>(pixels.size()));
    ASSERT_TRUE(nothing);
    EXPECT_NEAR(nothing->coverageError.value(), 1.0, 1e-6);
    EXPECT_LT(nothing->maskedPsnrDb.value(), scores->maskedPsnrDb.value());
}

// Noise of the truth is no error of the model: on average over many truths nothing of it remains.
TEST(ViewScores, LessNoiseAreThoseOfWhatTheTruthConvergesTo) {
    std::mt19937 random(1);
    std::normal_distribution<float> noise(0.0f, 0.02f);
    const auto noisy = [&] {
        std::vector<glm::vec4> rgba = ball(0.5f);
        for (glm::vec4& pixel : rgba) {
            if (pixel.w > 0.0f) pixel += glm::vec4(noise(random), noise(random), noise(random), 0.0f);
        }
        return rgba;
    };
    std::vector<ViewScores> views;
    for (int i = 0; i < 40; ++i) {
        const auto scores = scoresOf(truthOf(noisy(), noisy()), ball(0.5f));
        ASSERT_TRUE(scores);
        EXPECT_GT(scores->truthNoise.value(), 0.0);
        EXPECT_TRUE(scores->maskedPsnrDb);  // is of the noise
        views.push_back(*scores);
    }
    const auto error = squareErrorOver(views);
    ASSERT_TRUE(error);
    EXPECT_LT(std::abs(error->mean), 5.0 * error->standardError);
    const double noiseMse = std::pow(10.0, -0.1 * spreadOf(views, &ViewScores::maskedPsnrDb)->mean);
    EXPECT_LT(std::abs(error->mean), 0.3 * noiseMse);
}

TEST(Spread, HasThePercentilesOfNumPy) {
    const std::vector<std::optional<double>> values{4.0, std::nullopt, 1.0, 2.0, 3.0, 10.0};
    const auto spread = spreadOf(values);
    ASSERT_TRUE(spread);
    EXPECT_EQ(spread->count, 5u);
    EXPECT_DOUBLE_EQ(spread->mean, 4.0);
    EXPECT_DOUBLE_EQ(spread->p10, 1.4);  // numpy.percentile([1, 2, 3, 4, 10], 10)
    EXPECT_DOUBLE_EQ(spread->p50, 3.0);
    EXPECT_DOUBLE_EQ(spread->p90, 7.6);
    EXPECT_FALSE(spreadOf(std::vector<std::optional<double>>{std::nullopt}));
}

// The mean over the views of a scene first: a scene with more views counts no more.
TEST(Spread, OverScenesIsOfTheirMeans) {
    EvaluationReport report;
    for (const auto& values : {std::vector<double>{30.0, 32.0}, {20.0}, {}}) {
        EvaluatedStudy& scene = report.scenes.emplace_back();
        Snapshot& snapshot = scene.evaluation.snapshots.emplace_back();
        for (const double value : values) snapshot.scores.push_back({.psnrDb = value});
        if (values.empty()) snapshot.scores.emplace_back();  // no number
    }
    const auto spread = spreadOverScenes(report, &ViewScores::psnrDb);
    ASSERT_TRUE(spread);
    EXPECT_EQ(spread->count, 2u);
    EXPECT_DOUBLE_EQ(spread->mean, 25.5);
    EXPECT_FALSE(spreadOverScenes(report, &ViewScores::flip));
}

TEST(EvaluationReport, TellsTheGreatestFallBetweenSnapshots) {
    std::vector<Snapshot> snapshots;
    for (const double psnr : {30.0, 31.0, 30.25, 32.0, 31.9}) {
        snapshots.emplace_back().scores = {{.maskedPsnrDb = psnr}, {.maskedPsnrDb = psnr + 2.0}};
    }
    EXPECT_DOUBLE_EQ(greatestFall(snapshots).meanDb, 0.75);
    EXPECT_DOUBLE_EQ(greatestFall(snapshots).medianDb, 0.75);
    snapshots.resize(2);
    EXPECT_EQ(greatestFall(snapshots).meanDb, 0.0);
}

TEST(EvaluationReport, NamesNoNumberThatIsNone) {
    EvaluationReport report{.device = "d", .lights = "l", .clip = "none", .options = {}, .scenes = {}};
    EvaluatedStudy& scene = report.scenes.emplace_back();
    scene.studyDigest = "digest";
    scene.evaluation.seenMm = {.low = glm::dvec3(-1.0), .high = glm::dvec3(1.0)};
    scene.evaluation.truthCameras = {{.positionMm = {0.0, -2.0 * std::sqrt(3.0), 0.0}}};
    scene.evaluation.snapshots.emplace_back().scores = {{.flip = 0.25}};
    const auto json = toJson(report);
    EXPECT_EQ(json["evaluation"], "init");
    EXPECT_EQ(json["scenes"][0]["views"][0]["flip"], 0.25);
    EXPECT_NEAR(json["scenes"][0]["views"][0]["distance"].get<double>(), 2.0, 1e-12);
    EXPECT_TRUE(json["scenes"][0]["views"][0]["psnrDb"].is_null());
    EXPECT_EQ(json["overScenes"]["flip"]["mean"], 0.25);
    EXPECT_TRUE(json["overScenes"]["psnrDb"].is_null());
    EXPECT_FALSE(tableOf(report).empty());
}

}  // namespace
}  // namespace macula::evaluate
