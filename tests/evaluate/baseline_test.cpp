#include "evaluate/baseline.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/paths.h"
#include "evaluate/benchmark_reports.h"
#include "support.h"

namespace macula::evaluate {
namespace {

using Json = nlohmann::ordered_json;

class BaselineTest : public testing::Test {
  protected:
    Result<Baseline> read(const std::string& text, std::string_view benchmark) const {
        std::ofstream(folder_ / "baseline.json") << text;
        return Baseline::read(folder_ / "baseline.json", benchmark);
    }
    Baseline of(const Json& report) const {
        auto baseline = read(report.dump(), report["benchmark"].get<std::string>());
        EXPECT_TRUE(baseline);
        return *std::move(baseline);
    }

    dicom::test::TemporaryFolder folder_;
};

TEST_F(BaselineTest, OfTracingIsComparedByFilter) {
    const Json before = {
        {"benchmark", "trace"},
        {"results",
         {{{"filter", "stochastic"}, {"cpuRatio", 0.5}}, {{"filter", "trilinear"}, {"cpuRatio", 2.0}}}}};
    Json results = {{{"filter", "trilinear"}, {"cpuRatio", 1.0}, {"wallRatio", 7.0}},
                    {{"filter", "stochastic"}, {"cpuRatio", 1.0}},
                    {{"filter", "novel"}, {"cpuRatio", 1.0}}};
    of(before).compare(kTraceRatios, results);
    EXPECT_EQ(results[0]["cpuRatioOverBaseline"], 0.5);
    EXPECT_EQ(results[1]["cpuRatioOverBaseline"], 2.0);
    EXPECT_FALSE(results[2].contains("cpuRatioOverBaseline"));
    EXPECT_FALSE(results[0].contains("wallRatioOverBaseline"));
}

TEST_F(BaselineTest, OfTrainingIsComparedByPictureAndStage) {
    const auto result = [](int side, double loss, const Json& lists) {
        return Json{{"picture", {side, side}},
                    {"stages", {{"loss", {{"cpuRatio", loss}}}, {"lists", {{"cpuRatio", lists}}}}}};
    };
    const Json before = {{"benchmark", "train"},
                         {"results", Json::array({result(64, 0.1, Json()), result(32, 0.2, 0.0)})}};
    Json results = Json::array({result(32, 0.1, 1.0), result(64, 0.1, 1.0)});
    const std::string_view ratio = "cpuRatio";
    of(before).compare(std::span(&ratio, 1), results);
    EXPECT_EQ(results[0]["stages"]["loss"]["cpuRatioOverBaseline"], 0.5);
    EXPECT_EQ(results[1]["stages"]["loss"]["cpuRatioOverBaseline"], 1.0);
    // Nothing to compare with: 0 there, null here.
    EXPECT_FALSE(results[0]["stages"]["lists"].contains("cpuRatioOverBaseline"));
    EXPECT_FALSE(results[1]["stages"]["lists"].contains("cpuRatioOverBaseline"));
}

TEST_F(BaselineTest, OfLoadingIsOneResult) {
    const Json before = {{"benchmark", "load"},
                         {"results", {{"itkOverOurs", 2.0}, {"dcmtkOverOurs", Json()}}}};
    Json results = {{"itkOverOurs", 3.0}, {"dcmtkOverOurs", 4.0}, {"headersOverDcmtk", 5.0}};
    of(before).compare(kLoadRatios, results);
    EXPECT_EQ(results["itkOverOursOverBaseline"], 1.5);
    EXPECT_EQ(results.size(), 4u);
}

TEST_F(BaselineTest, OfSomethingElseIsRefused) {
    for (const char* text :
         {"", "[]", "{}", "7", R"({"benchmark": "train"})", R"({"benchmark": "load", "results": {}})",
          R"({"benchmark": "train", "results": [{"picture": [1, 1], "stages": [1]}]})"}) {
        const auto refused = read(text, "train");
        ASSERT_FALSE(refused) << text;
        EXPECT_EQ(refused.error().code, ErrorCode::inputNotUsable) << text;
        EXPECT_EQ(refused.error().message, "The baseline is no output of macula-bench train.") << text;
    }
    EXPECT_EQ(Baseline::read("/nowhere", "trace").error().code, ErrorCode::inputNotUsable);
}

TEST_F(BaselineTest, OfAnotherModelIsNotComparable) {
    const Json report = {
        {"benchmark", "train"}, {"study", "phantom"}, {"splats", 50}, {"results", Json::array()}};
    const Baseline baseline = of(report);
    EXPECT_TRUE(baseline.checkSame(report));
    EXPECT_TRUE(baseline.checkSame({{"study", "phantom"}}));  // splats are not known yet
    const auto other = baseline.checkSame({{"study", "phantom"}, {"splats", 51}});
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().message, "The baseline is of another number of splats.");
}

// Those that are stored are of these shapes.
TEST_F(BaselineTest, IsWhatIsStored) {
    const std::filesystem::path folder = macula::test::projectFolder() / "tests/bench";
    EXPECT_TRUE(Baseline::read(folder / "trace-phantom.json", "trace"));
    EXPECT_TRUE(Baseline::read(folder / "train-phantom.json", "train"));
    EXPECT_TRUE(Baseline::read(folder / "load-ct_chest_ricord.json", "load"));
    EXPECT_FALSE(Baseline::read(folder / "foveal-phantom.json", "trace"));
}

}  // namespace
}  // namespace macula::evaluate
