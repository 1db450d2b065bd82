// macula train: that a model comes out of a series, and what it says about it.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/run_command.h"
#include "pipeline/splat/model_file.h"
#include "pipeline/splat/training_file.h"

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
        small({"-o", at("model.macula"), "--budget", "0.2", "--degree", "1", "--json", "-"}, "1000000"));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_GE(report["iterations"].get<int>(), 1);
    EXPECT_LT(report["iterations"].get<int>(), 100000);
    const auto state = splat::readTraining(at("model.macula"));
    ASSERT_TRUE(state.ok());
    EXPECT_EQ(state->splats.shDegree, 1);
    EXPECT_EQ(state->steps, report["iterations"].get<std::uint64_t>());
    ASSERT_EQ(state->views.size(), 5u);
    const auto isOutline = [](const splat::TrainingState::View& view) { return view.given->coverageOnly; };
    EXPECT_EQ(std::count_if(state->views.begin(), state->views.end(), isOutline), 2);
}

TEST_F(Train, WhatCannotBeIsAnErrorAndWritesNothing) {
    EXPECT_EQ(runMacula({"train", "phantom:"}).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.obj")})).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("nowhere/model.ply")})).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.ply"), "--lights", "headlight"})).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.ply"), "--preset", "no-such-preset"})).exitCode, 2);
    EXPECT_EQ(runMacula(small({"-o", at("model.ply")}, "12", "0")).exitCode, 2);
    EXPECT_FALSE(std::filesystem::exists(at("model.ply")));
}

}  // namespace
}  // namespace macula::cli
