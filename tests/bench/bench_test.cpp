// macula-bench: that the benchmarks run to their end and say what they promise. How fast
// anything is, is not tested.
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/run_command.h"

namespace macula::bench {
namespace {

using Bench = cli::CommandTest;
using cli::Ran;
using cli::runBench;
using nlohmann::json;

TEST_F(Bench, CastMeasuresEveryLook) {
    const Ran ran = runBench({"cast", "--size", "96", "--repetitions", "1", "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["benchmark"], "cast");
    ASSERT_EQ(report["results"].size(), 6u);
    for (const json& result : report["results"]) {
        EXPECT_GT(result["ours"]["secondsPerPicture"], 0.0) << result["look"];
        EXPECT_LT(result["ours"]["flipToConverged"], 0.15) << result["look"];
        // VTK is there or it is not; what it is compared by is there with it.
        EXPECT_EQ(result["vtk"].is_null(), !result.contains("oursOverVtk")) << result["look"];
    }
    EXPECT_NE(report["results"][0]["vtk"].is_null(), ran.err.find("Without VTK") == std::string::npos)
        << ran.err;
}

TEST_F(Bench, TraceTellsTheTimesOfSamplesAndOfWholePictures) {
    const std::vector<std::string> command{"trace", "--size", "16", "--spp", "2", "--repetitions", "1"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), command.begin(), command.end());
        return more;
    };
    const Ran both = runBench(command);
    ASSERT_EQ(both.exitCode, 0) << both.err;
    EXPECT_EQ(json::parse(both.out)["results"].size(), 2u);

    const std::string camera = R"({"positionMm": [0, -750, 0], "targetMm": [0, 0, 0], "up": [0, 0, 1],)"
                               R"( "verticalFovDeg": 5.8})";
    std::ofstream(at("camera.json")) << camera;
    const Ran one = runBench(with({"--camera", at("camera.json"), "--filter", "stochastic"}));
    ASSERT_EQ(one.exitCode, 0) << one.err;
    const json report = json::parse(one.out);
    EXPECT_EQ(report["camera"]["verticalFovDeg"], 5.8);
    ASSERT_EQ(report["results"].size(), 1u);
    const json& result = report["results"][0];
    EXPECT_EQ(result["filter"], "stochastic");
    for (const char* part : {"device", "call", "reference"})
        EXPECT_GT(result[part]["secondsPerSample"].get<double>(), 0.0) << part;
    EXPECT_GT(result["callOverDevice"].get<double>(), 0.0);

    EXPECT_EQ(runBench(with({"--filter", "cubic"})).exitCode, 2);
    EXPECT_EQ(runBench(with({"--camera", at("missing.json")})).exitCode, 2);
    std::ofstream(at("camera.json")) << "{}";
    EXPECT_EQ(runBench(with({"--camera", at("camera.json")})).exitCode, 3);
}

TEST_F(Bench, FovealTellsTheTimesAndTheWayToAnError) {
    const Ran ran =
        runBench({"foveal", "--size", "16", "--repetitions", "1", "--converged-spp", "32", "--flip", "0.2"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_TRUE(report["sideBySide"].is_null()) << "as the device likes";
    EXPECT_EQ(report["benchmark"], "foveal");
    EXPECT_EQ(report["picture"], json::array({16, 16}));
    const json& times = report["times"];
    for (const char* part :
         {"traceMs", "traceDispatches", "guidesMs", "denoiseAndDisplayMs", "referenceTraceMs"})
        EXPECT_GT(times[part].get<double>(), 0.0) << part;
    // One turn: its median is itself.
    EXPECT_NEAR(times["totalMs"].get<double>(),
                times["traceMs"].get<double>() + times["guidesMs"].get<double>() +
                    times["denoiseAndDisplayMs"].get<double>(),
                1e-6);
    const json& way = report["timeToError"];
    ASSERT_TRUE(way["plain"]["reached"].get<bool>()) << ran.out;
    ASSERT_TRUE(way["denoised"]["reached"].get<bool>()) << ran.out;
    EXPECT_LE(way["plain"]["flip"].get<double>(), 0.2);
    EXPECT_LE(way["denoised"]["samples"].get<double>(), way["plain"]["samples"].get<double>());
    EXPECT_TRUE(way["adaptiveDenoised"]["reached"].get<bool>()) << ran.out;
}

TEST_F(Bench, FovealSaysWhenAnErrorIsOutOfReach) {
    const Ran ran =
        runBench({"foveal", "--size", "16", "--repetitions", "1", "--converged-spp", "2", "--flip", "0.001"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json way = json::parse(ran.out)["timeToError"];
    EXPECT_FALSE(way["plain"]["reached"].get<bool>());
    EXPECT_FALSE(way.contains("denoisedOverPlain"));
}

TEST_F(Bench, TradeoffTellsWhatItMeasuredAlsoWhenThePlotCannotBeWritten) {
    const std::string tooLong = at(std::string(300, 'p') + ".svg");  // which only who writes is told
    const Ran ran =
        runBench({"trace-tradeoff", "--size", "16", "--converged-spp", "64", "--json", "--plot", tooLong});
    EXPECT_NE(ran.exitCode, 0);
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["converged"]["lost"], 0);
    ASSERT_EQ(report["results"].size(), 2u * 2u * 5u * 6u);  // filters, denoising, bounces, samples
    // Of one setting, with 1 to 32 samples.
    EXPECT_EQ(report["results"][5]["samples"], 32);
    // Over all settings: one of them may have been held up.
    std::array<double, 6> traceMs{};
    for (std::size_t i = 0; i < report["results"].size(); ++i)
        traceMs[i % 6] += report["results"][i]["traceMs"].get<double>();
    EXPECT_LT(traceMs[0], traceMs[5]);
    EXPECT_GT(report["results"][5]["psnrDb"].get<double>(),
              report["results"][0]["psnrDb"].get<double>() + 3.0);
}

TEST_F(Bench, TrainTellsEachStageBesideTheReference) {
    const std::vector<std::string> command{"train", "--size",        "32", "--splats",
                                           "300",   "--repetitions", "1",  "--from-volume"};
    std::vector<std::string> asJson = command;
    asJson.emplace_back("--json");
    const Ran ran = runBench(asJson);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["benchmark"], "train");
    EXPECT_EQ(report["splats"], 300);
    ASSERT_EQ(report["results"].size(), 2u);
    EXPECT_EQ(report["results"][1]["picture"], json::array({16, 16}));
    for (const json& result : report["results"]) {
        EXPECT_GT(result["pairs"], 10);
        const json& stages = result["stages"];
        double sum = 0.0;
        for (const char* name : {"project", "raster", "loss", "backward", "adam"}) {
            EXPECT_GT(stages[name]["device"]["wallMs"], 0.0) << name;
            sum += stages[name]["reference"]["wallMs"].get<double>();
        }
        EXPECT_GT(stages["lists"]["device"]["wallMs"], 0.0);
        EXPECT_GT(stages["deviceLists"]["device"]["wallMs"], 0.0);
        EXPECT_TRUE(stages["lists"]["reference"].is_null());
        // One turn: medians are itself.
        const json& step = stages["step"];
        EXPECT_NEAR(step["reference"]["wallMs"].get<double>(), sum, 1e-6);
        EXPECT_NEAR(step["wallRatio"].get<double>(), step["device"]["wallMs"].get<double>() / sum, 1e-6);
        EXPECT_NEAR(result["stepsPerSecond"].get<double>() * step["device"]["wallMs"].get<double>(), 1000.0,
                    1e-6);
    }
    const json& fromVolume = report["fromVolume"];
    for (const char* what : {"firstSplatsMs", "firstPictureMs", "tracedViewMs"})
        EXPECT_GT(fromVolume[what], 0.0) << what;

    // Beside itself as a baseline: what it had of each stage.
    std::ofstream(at("baseline.json")) << ran.out;
    const std::vector<std::string> again{"train",         "--size", "32",         "--splats",         "300",
                                         "--repetitions", "1",      "--baseline", at("baseline.json")};
    const Ran second = runBench(again);
    ASSERT_EQ(second.exitCode, 0) << second.err;
    const json loss = json::parse(second.out)["results"][0]["stages"]["loss"];
    EXPECT_NEAR(loss["cpuRatioOverBaseline"].get<double>() *
                    report["results"][0]["stages"]["loss"]["cpuRatio"].get<double>(),
                loss["cpuRatio"].get<double>(), 1e-9);
}

TEST_F(Bench, TrainRefusesABaselineOfSomethingElse) {
    const std::vector<std::string> command{"train",    writeBall(), "--size",        "16",
                                           "--splats", "50",        "--repetitions", "1"};
    std::vector<std::string> asJson = command;
    asJson.emplace_back("--json");
    const Ran ran = runBench(asJson);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["deviceKind"], "CPU");  // of lavapipe, which tests run on
    const auto expectRefused = [&](const char* what, const json& baseline, const char* reason) {
        std::vector<std::string> beside = command;
        beside.insert(beside.end(), {"--baseline", write("baseline.json", baseline.dump())});
        const Ran refused = runBench(beside);
        EXPECT_EQ(refused.exitCode, 3) << what << refused.err;
        EXPECT_NE(refused.err.find(reason), std::string::npos) << what << refused.err;
        EXPECT_EQ(refused.errorLines(), 1u) << what << refused.err;
    };
    const auto with = [&](const char* pointer, const json& value) {
        json changed = report;
        changed[json::json_pointer(pointer)] = value;
        return changed;
    };
    expectRefused("study", with("/study", "another"), "another series");
    expectRefused("preset", with("/preset", "another"), "another preset");
    expectRefused("kind of device", with("/deviceKind", "discrete GPU"), "another kind of device");
    expectRefused("degree", with("/shDegree", 0), "another degree");
    expectRefused("splats", with("/splats", 51), "another number of splats");
    for (const char* pointer : {"/results", "/results/0", "/results/1/stages", "/results/0/stages/loss"}) {
        expectRefused(pointer, with(pointer, json::array({1, 2})), "no output of macula-bench train");
        expectRefused(pointer, with(pointer, "text"), "no output of macula-bench train");
    }
}

// What is compared was kept on the disk in between: a fault of saving or reading is seen here.
TEST_F(Bench, SessionGoesOnWithTheModelThatItSaved) {
    std::filesystem::create_directory(at("tmp"));
    const Ran ran = runBench({"session", "--size", "48", "--learn", "0", "--frames", "20", "--blocks", "1"},
                             {"TMPDIR=" + at("tmp")});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(fileCount("tmp"), 0u) << "what was saved stayed";
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["benchmark"], "session");
    const json& learnt = report["learnt"];
    EXPECT_GT(learnt["steps"], 0);
    EXPECT_GT(learnt["splats"], 100);
    EXPECT_GE(learnt["heldOutViews"], 2);
    EXPECT_GT(learnt["shownError"], 0.0);

    const json& saving = report["saving"];
    EXPECT_EQ(saving["calls"], 2) << "at every tenth frame";
    EXPECT_EQ(saving["framesWithout"]["frames"], 20);
    EXPECT_GE(saving["framesBeside"]["frames"], 2);
    EXPECT_EQ(saving["framesBeside"]["frames"].get<int>() + saving["framesBetween"].get<int>(), 20);
    int inBuckets = 0;
    for (const json& bucket : saving["framesWithout"]["histogram"]) inBuckets += bucket["frames"].get<int>();
    EXPECT_EQ(inBuckets, 20);
    EXPECT_LE(saving["framesWithout"]["medianMs"], saving["framesWithout"]["maxMs"]);
    // The pixels of six pictures do not fit into less.
    EXPECT_GT(saving["firstBlobBytes"], 10'000);
    EXPECT_EQ(saving["laterBlobBytes"], saving["firstBlobBytes"]) << "nothing was learnt in between";
    EXPECT_LE(report["closing"]["hideMs"], report["closing"]["savedMs"]);

    ASSERT_EQ(report["reopenings"].size(), 2u);
    for (const bool ready : {false, true}) {
        const json& reopening = report["reopenings"][ready ? 1 : 0];
        EXPECT_EQ(reopening["keeperReady"], ready);
        EXPECT_EQ(reopening["steps"], learnt["steps"]);
        EXPECT_EQ(reopening["shownErrorDifference"], 0.0) << reopening;
        EXPECT_EQ(reopening["sameToTheBit"], true);
        EXPECT_LE(reopening["drawableMs"], reopening["firstPictureMs"]);
        EXPECT_LE(reopening["drawableMs"], reopening["wholeMs"]);
        EXPECT_LE(reopening["wholeMs"], reopening["learningMs"]);
    }
    EXPECT_FALSE(report.contains("store")) << "nobody asked for it";
}

TEST_F(Bench, SessionNeedsLightsThatAModelCanHold) {
    const Ran ran = runBench({"session", "--lights", "headlight"});
    EXPECT_EQ(ran.exitCode, 2) << ran.err;
    EXPECT_NE(ran.err.find("hang on the camera"), std::string::npos) << ran.err;
}

TEST_F(Bench, SessionTakesNoFolderThatHoldsAnything) {
    write("other.txt", "what was there");
    const Ran ran = runBench({"session", "--sessions", at(".")});
    EXPECT_EQ(ran.exitCode, 2) << ran.err;
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    EXPECT_NE(ran.err.find("--sessions"), std::string::npos) << ran.err;
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(Bench, BadNumbersAreUsageErrors) {
    EXPECT_EQ(runBench({"session", "--frames", "9"}).exitCode, 2);
    EXPECT_EQ(runBench({"session", "--learn", "nan"}).exitCode, 2);
    EXPECT_EQ(runBench({"train", "--splats", "0"}).exitCode, 2);
    EXPECT_EQ(runBench({"train", "--degree", "2"}).exitCode, 2);
    EXPECT_EQ(runBench({"foveal", "--flip", "0"}).exitCode, 2);
    EXPECT_EQ(runBench({"foveal", "--size", "0"}).exitCode, 2);
    EXPECT_EQ(runBench({"trace", "--preset", "no-such-preset"}).exitCode, 2);
}

TEST_F(Bench, LoadMeasuresAgainstItkAndDcmtk) {
    ASSERT_EQ(cli::runMacula({"phantom", at("study")}).exitCode, 0);
    const Ran ran = runBench({"load", at("study"), "--json", "--repetitions", "1"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["benchmark"], "load");
    EXPECT_EQ(report["headers"]["files"], 160);
    EXPECT_EQ(report["voxels"], 256 * 224 * 160);
    EXPECT_EQ(report["loading"]["voxelsWhereItkDiffers"], 0);
    for (const char* name : {"headersOverDcmtk", "itkOverOurs", "dcmtkOverOurs"})
        EXPECT_GT(report["results"][name].get<double>(), 0.0) << name;
    for (const char* name : {"ours", "itk", "dcmtk"}) {
        EXPECT_GT(report["loading"][name]["seconds"].get<double>(), 0.0);
        // Its own voxels, at the least.
        EXPECT_GT(report["loading"][name]["peakBytes"].get<double>(), 2.0 * 256 * 224 * 160) << name;
    }
    write("before.json", ran.out);
    const Ran again = runBench({"load", at("study"), "--baseline", at("before.json"), "--repetitions", "1"});
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_GT(json::parse(again.out)["results"]["itkOverOursOverBaseline"].get<double>(), 0.0);
    const Ran text = runBench({"load", at("study"), "--repetitions", "1"});
    EXPECT_NE(text.out.find("ITK: "), std::string::npos) << text.out;
    write("other.json", "{}");
    EXPECT_EQ(runBench({"load", at("study"), "--baseline", at("other.json"), "--repetitions", "1"}).exitCode,
              3);
}

}  // namespace
}  // namespace macula::bench
