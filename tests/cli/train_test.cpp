// macula train: that a model comes out of a series, and what it says about it.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/run_command.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::cli {
namespace {

using Train = CommandTest;
using nlohmann::json;

// So small that it takes a second.
std::vector<std::string> small(std::vector<std::string> more, const std::string& iterations = "12",
                               const std::string& views = "3") {
    std::vector<std::string> arguments{
        "train", "phantom:", "--size", "32",           "--views",  views,          "--spp",
        "1",     "--points", "300",    "--iterations", iterations, "--directions", "5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST_F(Train, WritesAModelAndTellsWhatWasDone) {
    const Ran ran = runMacula(small({"-o", at("model.ply"), "--splats", "320", "--json", "-"}));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["study"], "phantom");
    EXPECT_EQ(report["tableRemoved"], false);
    EXPECT_EQ(report["iterations"], 12);
    EXPECT_GT(report["loss"].get<double>(), 0.0);
    const auto model = splat::readModel(at("model.ply"));
    ASSERT_TRUE(model.ok());
    EXPECT_EQ(model->splats.size(), report["splats"].get<std::size_t>());
    EXPECT_LE(model->splats.size(), 320u);
    EXPECT_GT(model->splats.size(), 100u);
    EXPECT_EQ(model->splats.axes, splat::Axes::patientLps);
    EXPECT_EQ(model->splats.colourSpace, splat::ColourSpace::linear);

    // The same once more is the same.
    const Ran again = runMacula(small({"-o", at("again.ply"), "--splats", "320"}));
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(readAll(at("again.ply")), readAll(at("model.ply")));
}

TEST_F(Train, ABudgetEndsItEarly) {
    const Ran ran = runMacula(
        small({"-o", at("model.macula"), "--budget", "2", "--degree", "1", "--json", "-"}, "1000000"));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_GE(report["iterations"].get<int>(), 1);
    EXPECT_LT(report["iterations"].get<int>(), 100000);
    const auto state = splat::readTraining(at("model.macula"));
    ASSERT_TRUE(state.ok());
    EXPECT_EQ(state->splats.shDegree, 1);
    EXPECT_EQ(state->steps, report["iterations"].get<std::uint64_t>());
    // Points and views are paid from the same budget.
    EXPECT_EQ(report["budgetSeconds"], 2.0);
    const json& seconds = report["seconds"];
    const double training = seconds["training"].get<double>();
    EXPECT_GE(seconds["points"].get<double>() + seconds["views"].get<double>() + training, 1.9);
    EXPECT_LT(training, 2.0);
    EXPECT_GT(seconds["points"].get<double>(), 0.0);
    EXPECT_GT(seconds["views"].get<double>(), 0.0);
    EXPECT_NE(ran.err.find("Points took"), std::string::npos) << ran.err;
    const std::size_t traced = report["viewsTraced"].get<std::size_t>();
    EXPECT_GE(traced, 1u);
    EXPECT_LE(traced, 3u);
    EXPECT_GE(state->views.size(), traced);
}

// In another process, with nothing but the file: the same bytes as if it had not stopped.
TEST_F(Train, GoesOnFromWhereItWasSaved) {
    ASSERT_EQ(runMacula(small({"-o", at("whole.macula")}, "40")).exitCode, 0);
    ASSERT_EQ(runMacula(small({"-o", at("half.macula"), "--pause-after", "20"}, "40")).exitCode, 0);
    EXPECT_EQ(splat::readTraining(at("half.macula"))->steps, 20u);
    // By count, to another format.
    ASSERT_EQ(runMacula({"train", "phantom:", "--resume", at("half.macula"), "--iterations", "20", "-o",
                         at("rest.ply")})
                  .exitCode,
              0);
    const auto whole = splat::readModel(at("whole.macula"));
    const auto ply = splat::readModel(at("rest.ply"));
    ASSERT_TRUE(whole.ok() && ply.ok());
    EXPECT_TRUE(ply->splats.position == whole->splats.position);
    EXPECT_TRUE(ply->splats.dc == whole->splats.dc);
    // To the end that was planned, over the file that it came from.
    const Ran rest = runMacula(
        {"train", "phantom:", "--resume", at("half.macula"), "-o", at("half.macula"), "--json", "-"});
    ASSERT_EQ(rest.exitCode, 0) << rest.err;
    EXPECT_TRUE(readAll(at("half.macula")) == readAll(at("whole.macula")));
    const json report = json::parse(rest.out);
    EXPECT_EQ(report["iterationsBefore"], 20);
    EXPECT_EQ(report["iterations"], 40);
    EXPECT_EQ(report["interrupted"], false);

    // What it is not of.
    const auto refused = [&](const std::vector<std::string>& given, int exitCode, const std::string& words) {
        std::vector<std::string> arguments{"train", "phantom:", "-o", at("refused.macula")};
        arguments.insert(arguments.end(), given.begin(), given.end());
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_FALSE(std::filesystem::exists(at("refused.macula")));
    };
    const std::string saved = at("whole.macula");
    refused({"--resume", saved, "--iterations", "5", "--preset", "cinematic-bone", "--lights", "even"}, 3,
            "of another preset and other lights.");
    refused({"--resume", saved}, 2, "all of its 40 steps");
    refused({"--resume", saved, "--views", "4"}, 2, "--views excludes --resume");
    refused({"--resume", at("rest.ply")}, 3, "no training");
    auto state = splat::readTraining(saved);
    ASSERT_TRUE(state.ok());
    state->options.key.clear();
    ASSERT_TRUE(splat::writeTraining(at("without.macula"), *state).ok());
    refused({"--resume", at("without.macula"), "--iterations", "5"}, 3,
            "does not say what its pictures show");
}

TEST_F(Train, CtrlCBeforeTheFirstStepWritesNothing) {
    const auto isAtWork = [](const std::string& err) { return err.find(" %") != std::string::npos; };
    // So many views that whoever presses has time.
    const Ran ran = runMaculaInterrupted(small({"-o", at("model.macula")}, "12", "300"), isAtWork);
    EXPECT_EQ(ran.exitCode, 130) << ran.err;
    EXPECT_EQ(fileCount(), 0u);
}

TEST_F(Train, CtrlCKeepsTheModelAsItIsThen) {
    // The stage is shown when it begins, perhaps after its first step, and then after later ones.
    const auto hasMadeSteps = [](const std::string& err) {
        std::size_t shown = 0;
        for (std::size_t at = 0; (at = err.find("Training [", at)) != std::string::npos; ++at) ++shown;
        return shown >= 3;
    };
    const Ran ran = runMaculaInterrupted(
        small({"-o", at("model.macula"), "--json", at("report.json"), "--budget", "100"}, "1000000"),
        hasMadeSteps);
    ASSERT_EQ(ran.exitCode, 130) << ran.err;
    EXPECT_NE(ran.err.find("macula: Stopped after"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("model.macula"), std::string::npos) << ran.err;
    const json report = json::parse(readAll(at("report.json")));
    EXPECT_EQ(report["interrupted"], true);
    EXPECT_GE(report["iterations"].get<int>(), 2);
    EXPECT_LT(report["iterations"].get<int>(), 1000000);
    const Ran rest = runMacula(
        {"train", "phantom:", "--resume", at("model.macula"), "--iterations", "1", "-o", at("more.macula")});
    ASSERT_EQ(rest.exitCode, 0) << rest.err;
    EXPECT_EQ(splat::readTraining(at("more.macula"))->steps, report["iterations"].get<std::uint64_t>() + 1);
}

TEST_F(Train, CtrlCLeavesAFinishedModelThatIsThere) {
    write("model.ply", "a finished one");
    const auto hasMadeSteps = [](const std::string& err) {
        return err.find("Training [=") != std::string::npos;
    };
    const Ran ran = runMaculaInterrupted(
        small({"-o", at("model.ply"), "--overwrite", "--budget", "100"}, "3000"), hasMadeSteps);
    ASSERT_EQ(ran.exitCode, 130) << ran.err;
    EXPECT_EQ(readAll(at("model.ply")), "a finished one");
    EXPECT_NE(ran.err.find("model-unfinished.ply"), std::string::npos) << ran.err;
    EXPECT_TRUE(splat::readModel(at("model-unfinished.ply")).ok());
}

// As far as it had come, on another device: the same bytes as if none had been lost.
TEST_F(Train, ALostDeviceTakesNothingOfTheTrainingAlong) {
    const Ran whole = runMacula(small({"-o", at("whole.macula")}, "40"));
    ASSERT_EQ(whole.exitCode, 0) << whole.err;
    const auto losing = [&](const std::string& name, const std::string& losses) {
        return runMacula(small({"-o", at(name), "--json", at("report.json"), "--overwrite"}, "40"),
                         {"LD_PRELOAD=" MACULA_LOSE_DEVICE, "MACULA_TEST_LOSE=" + losses,
                          "ASAN_OPTIONS=verify_asan_link_order=0"});
    };
    // Where in the work the nth call falls is the work's business: some are in the training.
    int inTraining = 0;
    for (int nth = 40; nth <= 640; nth *= 2) {
        const Ran lost = losing("lost.macula", fmt::format("submit:{}:1", nth));
        ASSERT_EQ(lost.exitCode, 0) << lost.err;
        EXPECT_TRUE(readAll(at("lost.macula")) == readAll(at("whole.macula"))) << nth;
        const std::size_t said = lost.err.find("stopped responding");
        inTraining +=
            said != std::string::npos && lost.err.find("Tracing", said) == std::string::npos ? 1 : 0;
    }
    EXPECT_GT(inTraining, 0);
}

TEST_F(Train, WhatFailsAfterTheFirstStepLeavesTheModel) {
    // Lost again and again: after the third within a minute there is no other device.
    int written = 0;
    for (int nth = 150; nth <= 1200 && written == 0; nth *= 2) {
        const Ran ran =
            runMacula(small({"-o", at("left.macula")}, "1000000"),
                      {"LD_PRELOAD=" MACULA_LOSE_DEVICE, fmt::format("MACULA_TEST_LOSE=submit:{}:3", nth),
                       "ASAN_OPTIONS=verify_asan_link_order=0"});
        ASSERT_EQ(ran.exitCode, 4) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        if (!std::filesystem::exists(at("left.macula"))) continue;
        ++written;
        EXPECT_NE(ran.err.find("of 1000000 steps; the model is written"), std::string::npos) << ran.err;
        const auto state = splat::readTraining(at("left.macula"));
        ASSERT_TRUE(state.ok()) << state.error().message;
        EXPECT_EQ(state->views.size(), 5u);
    }
    EXPECT_EQ(written, 1);
}

TEST_F(Train, WhatCannotBeIsAnErrorAndWritesNothing) {
    EXPECT_EQ(runMacula({"train", "phantom:"}).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.obj")})).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("nowhere/model.ply")})).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.ply"), "--lights", "headlight"})).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.ply"), "--preset", "no-such-preset"})).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.ply")}, "12", "0")).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.ply"), "--budget", "nan"})).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.ply"), "--json", at("./model.ply")})).exitCode, 2);
    std::filesystem::create_directory(at("folder.ply"));
    const Ran folder = runMacula(small({"-o", at("folder.ply")}));
    EXPECT_EQ(folder.exitCode, 2);
    EXPECT_NE(folder.err.find("folder of that name"), std::string::npos) << folder.err;
    EXPECT_FALSE(std::filesystem::exists(at("model.ply")));
}

TEST_F(Train, ExtensionsMayBeInCapitals) {
    const Ran ran = runMacula(small({"-o", at("MODEL.PLY")}, "1"));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_TRUE(splat::readModel(at("MODEL.PLY")).ok());
}

TEST_F(Train, ColoursMayBeThoseOfTheDisplay) {
    const Ran ran = runMacula(small({"-o", at("shown.ply"), "--display-colours"}, "1"));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(splat::readModel(at("shown.ply"))->splats.colourSpace, splat::ColourSpace::display);
    EXPECT_EQ(runMacula(small({"-o", at("shown.macula"), "--display-colours"}, "1")).exitCode, 2);
}

TEST_F(Train, WithoutViewsNothingGoesOn) {
    ASSERT_EQ(runMacula({"train", "phantom:", "-o", at("points.macula"), "--points", "300", "--views", "0",
                         "--directions", "0", "--iterations", "0"})
                  .exitCode,
              0);
    const Ran ran = runMacula(
        {"train", "phantom:", "--resume", at("points.macula"), "--iterations", "4", "-o", at("x.ply")});
    EXPECT_EQ(ran.exitCode, 3);
    EXPECT_NE(ran.err.find("--views above 0"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace macula::cli
