#include "evaluate/benchmark_reports.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace macula::evaluate {
namespace {

TEST(BenchmarkReports, OfLoadingHoldRatiosAndNothingOfWhoCannotRead) {
    const HeaderBenchmark headers{.headersPerSecond = 6000.0, .bareDcmtkPerSecond = 1500.0};
    const LoadBenchmark loading{.ours = {.seconds = 0.5, .secondsOverOurs = 1.0},
                                .dcmtk = Loading{.seconds = 2.0, .secondsOverOurs = 4.0}};
    const auto json = reportOf("digest", headers, {.files = {"/doe-john/1.dcm"}, .load = {}}, loading);
    EXPECT_EQ(json["study"], "digest");
    EXPECT_EQ(json["results"]["headersOverDcmtk"], 4.0);
    EXPECT_EQ(json["results"]["dcmtkOverOurs"], 4.0);
    EXPECT_TRUE(json["results"]["itkOverOurs"].is_null());
    EXPECT_TRUE(json["loading"]["itk"].is_null());
    EXPECT_TRUE(json["loading"]["voxelsWhereItkDiffers"].is_null());
    EXPECT_EQ(json.dump().find("doe"), std::string::npos);
}

TEST(BenchmarkReports, OfTrainingHoldEachStage) {
    SizedTrainingBenchmark sized{.sizePx = {64, 32}, .training = {.pairs = 9}};
    sized.training.loss = {.device = {1.0, 2.0}, .reference = Spent{10.0, 10.0}, .ratio = {0.1, 0.2}};
    sized.training.lists = {.device = {3.0, 4.0}, .reference = {}};
    sized.training.step.device.wallMs = 20.0;
    const auto json = toJson(StudyTrainingReport{.splats = 7, .results = {sized}, .fromVolume = {}});
    EXPECT_EQ(json["splats"], 7);
    EXPECT_FALSE(json.contains("fromVolume"));
    const auto& result = json["results"][0];
    EXPECT_EQ(result["picture"], (nlohmann::ordered_json{64, 32}));
    EXPECT_EQ(result["stepsPerSecond"], 50.0);
    EXPECT_EQ(result["stages"].size(), 8u);
    EXPECT_EQ(result["stages"]["loss"]["device"]["cpuMs"], 2.0);
    EXPECT_EQ(result["stages"]["loss"]["cpuRatio"], 0.2);
    EXPECT_TRUE(result["stages"]["lists"]["reference"].is_null());
    EXPECT_TRUE(result["stages"]["lists"]["cpuRatio"].is_null());
}

// A curve for each number of bounces, with and without denoising, in plots of both errors by filter.
TEST(TradeoffPlots, HoldEachPointOnce) {
    const TradeoffOptions options{.samples = {1, 2}, .bounces = {1, 4}};
    Tradeoff tradeoff;
    for (const trace::Filter filter : {trace::Filter::stochastic, trace::Filter::trilinear}) {
        for (const trace::Denoising denoising : {trace::Denoising::off, trace::Denoising::on}) {
            for (const int bounces : options.bounces) {
                for (const std::uint32_t samples : options.samples)
                    tradeoff.points.push_back({.filter = filter,
                                               .denoising = denoising,
                                               .bounces = bounces,
                                               .samples = samples,
                                               .traceMs = 10.0 * samples,
                                               .displayMs = 1.0,
                                               .psnrDb = 30.0 + bounces,
                                               .flip = 0.01 * bounces});
            }
        }
    }
    const std::vector<Plot> plots = plotsOf(tradeoff, options);
    ASSERT_EQ(plots.size(), 4u);
    for (std::size_t i = 0; i < plots.size(); ++i) {
        ASSERT_EQ(plots[i].curves.size(), 4u);
        EXPECT_TRUE(plots[i].logarithmicX);
        for (const Curve& curve : plots[i].curves) {
            EXPECT_EQ(curve.x, (std::vector<double>{11.0, 21.0}));
            EXPECT_EQ(curve.dashed, curve.name.ends_with(", denoised"));
            const double bounces = curve.name.starts_with("1 bounce") ? 1.0 : 4.0;
            EXPECT_DOUBLE_EQ(curve.y.front(), i % 2 == 0 ? 0.01 * bounces : 30.0 + bounces) << curve.name;
        }
    }
}

}  // namespace
}  // namespace macula::evaluate
