#include "live/model/training_record.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "live/model/model_output.h"

namespace macula::live {
namespace {

Trained trained() {
    Trained trained{.device = "a device",
                    .firstStep = 100,
                    .pointsSeconds = 1.0,
                    .viewsSeconds = 2.0,
                    .viewTimes = {.paths = 0.5, .waiting = 0.25},
                    .trainSeconds = 3.0,
                    .viewsTraced = 5,
                    .viewsGivenUp = 1};
    trained.report.steps = 130;
    trained.report.splats = 1234;
    trained.state.options.optimizer.positionSteps = 200;
    return trained;
}

TEST(TrainingRecord, SaysHowFarATrainingCame) {
    const TrainingRecord record{.seriesDigest = "phantom",
                                .preset = "p",
                                .lights = "l",
                                .clip = "none",
                                .budgetSeconds = 60.0,
                                .stepsBefore = 100};
    const auto json = toJson(record, trained());
    EXPECT_EQ(json["iterationsBefore"], 100);
    EXPECT_EQ(json["iterations"], 130);
    EXPECT_EQ(json["plannedIterations"], 200);
    EXPECT_EQ(json["splats"], 1234);
    EXPECT_EQ(json["budgetSeconds"], 60.0);
    EXPECT_EQ(json["seconds"], (nlohmann::ordered_json{{"points", 1.0}, {"views", 2.0}, {"training", 3.0}}));
    EXPECT_FALSE(json.contains("viewSeconds"));
    EXPECT_FALSE(json.contains("views"));  // what it began with, a saved one does not say
}

TEST(TrainingRecord, SaysWhatOneBeganWith) {
    const TrainingRecord record{.begun = hybrid::FirstModelOptions{.views = 7, .sizePx = 99}};
    const auto json = toJson(record, trained());
    EXPECT_EQ(json["views"], 7);
    EXPECT_EQ(json["size"], 99);
    EXPECT_EQ(json["viewsTraced"], 5);
    EXPECT_EQ(json["viewsGivenUp"], 1);
    EXPECT_EQ(json["viewSeconds"]["paths"], 0.5);
    EXPECT_EQ(json["viewSeconds"]["waiting"], 0.25);
    EXPECT_EQ(json["viewSeconds"].size(), 8u);
    EXPECT_FALSE(json.contains("budgetSeconds"));
}

TEST(TrainingRecord, SaysWhatIsWrittenOfOneThatStopped) {
    const std::string goesOn = whatIsWritten(trained(), 50, "m.macula");
    EXPECT_TRUE(goesOn.starts_with("Stopped after 30 of 50 steps;")) << goesOn;
    EXPECT_NE(goesOn.find("--resume"), std::string::npos);
    EXPECT_EQ(whatIsWritten(trained(), 50, "m.ply").find("--resume"), std::string::npos);
}

TEST(ModelOutput, IsKnownByItsName) {
    EXPECT_TRUE(checkModelName("m.ply"));
    EXPECT_TRUE(checkModelName("m.spz"));
    EXPECT_TRUE(checkModelName("m.glb"));
    EXPECT_TRUE(checkModelName("m.macula"));
    EXPECT_TRUE(checkSplatsName("m.glb"));
    EXPECT_EQ(checkSplatsName("m.macula").error().code, ErrorCode::usage);
    EXPECT_EQ(checkModelName("m.obj").error().code, ErrorCode::usage);
    EXPECT_EQ(checkModelName("ply").error().code, ErrorCode::usage);
    EXPECT_TRUE(holdsTraining("m.macula"));
    EXPECT_FALSE(holdsTraining("m.ply"));
}

}  // namespace
}  // namespace macula::live
