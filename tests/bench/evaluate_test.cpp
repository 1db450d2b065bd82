// macula-bench evaluate: that the protocol runs to its end, says what was measured, and goes on from what it
// kept.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/run_command.h"

namespace macula::bench {
namespace {

using Evaluate = cli::CommandTest;
using cli::Ran;
using cli::readAll;
using cli::runBench;
using nlohmann::json;

// So small that it takes a second; numbers of such pictures mean little. What is given later counts.
std::vector<std::string> small(const std::vector<std::string>& more, const std::string& verb = "init") {
    std::map<std::string, std::string> once{{"--size", "32"},
                                            {"--points", "300"},
                                            {"--point-paths", "8"},
                                            {"--views", "1"},
                                            {"--preset", "cinematic-bone"},
                                            {"--spp", "1"},
                                            {"--truth-views", "2"},
                                            {"--truth-spp", "64"},
                                            {"--iterations", "0"}};
    for (const std::string& given : more) once.erase(given);
    std::vector<std::string> arguments{"evaluate", verb, "phantom:"};
    for (const auto& [option, value] : once) arguments.insert(arguments.end(), {option, value});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

// Nothing of the phantom is so dense.
constexpr const char* kShowsNothing = R"({"volumeProperties": [{"components": [{
    "rgbTransferFunction": {"type": "colorTransferFunction", "points": [{"x": 0, "color": [1, 1, 1]}]},
    "scalarOpacity": {"type": "piecewiseLinearFunction", "points": [{"x": 20000, "y": 0}, {"x": 30000, "y": 1}]}}]}]})";

TEST_F(Evaluate, TellsHowNearTheModelComesAndGoesOnFromWhatItKept) {
    const std::string cache = at("cache");
    std::filesystem::create_directory(at("pictures"));
    const Ran ran = runBench(small({"--cache", cache, "--json", "-", "--pictures", at("pictures")}));
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["truth"]["samplesPerPixel"], 64);
    EXPECT_EQ(report["model"]["iterations"], 0);
    ASSERT_EQ(report["scenes"].size(), 1u);
    const json& scene = report["scenes"][0];
    EXPECT_EQ(scene["study"], "phantom");
    EXPECT_GT(scene["splats"].get<int>(), 100);
    EXPECT_LE(scene["splats"].get<int>(), 300);
    EXPECT_EQ(scene["truthFromCache"], 0);
    ASSERT_EQ(scene["views"].size(), 2u);
    // Two of the protocol's 32: its first, 3 R away, and one that has come nearer by 0.8 R and wanders.
    EXPECT_NEAR(scene["views"][0]["distance"].get<double>(), 3.0, 1e-6);
    EXPECT_NEAR(scene["views"][1]["distance"].get<double>(), 2.2, 0.33);
    // What is drawn is where it is and as bright as it is: of no model at all all coverage would be missing.
    const json& scores = scene["scores"];
    EXPECT_LT(scores["coverageError"]["p50"].get<double>(), 0.2) << ran.out;
    EXPECT_NEAR(scores["luminanceRatio"]["p50"].get<double>(), 1.0, 0.35) << ran.out;
    const json& psnr = scores["psnrDb"];
    EXPECT_LE(psnr["p10"].get<double>(), psnr["p50"].get<double>());
    EXPECT_LE(psnr["p50"].get<double>(), psnr["p90"].get<double>());
    EXPECT_EQ(report["overScenes"]["psnrDb"]["p50"], psnr["mean"]);
    EXPECT_EQ(fileCount("cache"), 4u) << "two halves of each view";
    EXPECT_EQ(fileCount("pictures"), 2u);

    // Of all views as one: the mean of squares that may be of either sign.
    const json& less = scene["overViewsLessNoise"];
    double mse = 0.0;
    double wrongBy = 0.0;
    for (const json& view : scene["views"]) {
        mse += view["maskedMseLessNoise"].get<double>() / 2;
        wrongBy = std::hypot(wrongBy, view["maskedMseLessNoiseError"].get<double>() / 2);
    }
    EXPECT_NEAR(less["mse"].get<double>(), mse, 1e-12);
    EXPECT_NEAR(less["mseStandardError"].get<double>(), wrongBy, 1e-12);
    EXPECT_NEAR(less["psnrDb"].get<double>(), -10 * std::log10(mse), 1e-9);
    // Such a model is so wrong that the noise of 64 samples does not matter: both are about the same.
    EXPECT_NEAR(less["psnrDb"].get<double>(), scores["maskedPsnrDb"]["mean"].get<double>(), 1.0);

    // The same truth, and a model that has learnt.
    const Ran again = runBench(small({"--cache", cache, "--json", at("report.json"), "--iterations", "150",
                                      "--views", "16", "--spp", "8", "--directions", "24"}));
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_NE(again.out.find("masked PSNR"), std::string::npos) << "a table";
    EXPECT_NE(again.out.find("The protocol has a truth of 32 views of 1024 samples."), std::string::npos);
    const json trained = json::parse(readAll(at("report.json")))["scenes"][0];
    EXPECT_EQ(trained["truthFromCache"], 2);
    EXPECT_EQ(trained["truthNoise"], scene["truthNoise"]);
    EXPECT_LE(trained["splats"].get<int>(), 330);
    EXPECT_GT(trained["scores"]["maskedPsnrDb"]["mean"].get<double>(),
              scores["maskedPsnrDb"]["mean"].get<double>() + 0.5);
}

TEST_F(Evaluate, TellsHowAModelGoesOn) {
    std::vector<std::string> arguments =
        small({"--iterations", "10", "--more-views", "12", "--more-spp", "4", "--more-iterations", "250",
               "--snapshot-every", "125", "--splats", "350", "--cache", at("cache"), "--keep-views", "--json",
               at("report.json")},
              "refine");
    const Ran ran = runBench(arguments);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.out.find("greatest fall"), std::string::npos) << "a table";
    const json report = json::parse(readAll(at("report.json")));
    EXPECT_EQ(report["evaluation"], "refine");
    EXPECT_EQ(report["refinement"]["views"], 12);
    const json& scene = report["scenes"][0];
    const json& snapshots = scene["snapshots"];
    ASSERT_EQ(snapshots.size(), 3u);
    std::vector<double> db;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(snapshots[i]["iterations"], 10 + 125 * i);
        EXPECT_LE(snapshots[i]["splats"].get<int>(), 350);
        db.push_back(snapshots[i]["scores"]["maskedPsnrDb"]["mean"].get<double>());
    }
    // Views from all around teach what one did not.
    EXPECT_GT(db[2], db[0] + 0.5);
    EXPECT_LT(snapshots[0]["trainSeconds"], snapshots[1]["trainSeconds"]);
    EXPECT_EQ(scene["scores"], snapshots[2]["scores"]);
    EXPECT_EQ(scene["splats"], snapshots[2]["splats"]);
    EXPECT_GT(scene["splats"].get<int>(), 300);
    EXPECT_NEAR(scene["greatestFallDb"]["mean"].get<double>(), std::max({0.0, db[0] - db[1], db[1] - db[2]}),
                1e-9);

    // Once more, with what was kept: the first one and 47 sides that it lights, the twelve, and the truth.
    EXPECT_EQ(scene["viewsFromCache"], 0);
    arguments.emplace_back("--overwrite");
    const Ran again = runBench(arguments);
    ASSERT_EQ(again.exitCode, 0) << again.err;
    const json kept = json::parse(readAll(at("report.json")))["scenes"][0];
    EXPECT_EQ(kept["viewsFromCache"], 60);
    EXPECT_EQ(kept["truthFromCache"], 2);
    EXPECT_EQ(kept["scores"], scene["scores"]);
    EXPECT_NE(again.out.find("60 views were in the cache"), std::string::npos) << again.out;
}

TEST_F(Evaluate, TellsHowGoodFramesAreByTheWayTheyAreMade) {
    const Ran ran = runBench(
        {"evaluate", "quality", "--size", "48", "--views", "2", "--truth-spp", "8", "--iterations", "20"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["benchmark"], "quality");
    EXPECT_EQ(report["picture"], json({48, 48}));
    EXPECT_EQ(report["truthSamplesPerPixel"], 8);
    EXPECT_EQ(report["views"], 2);
    std::vector<std::string> rows;
    std::map<std::string, double> seconds;
    for (const json& row : report["rows"]) {
        const auto way = row["way"].get<std::string>();
        rows.push_back(way + (row["model"].is_null() ? "" : " " + row["model"].get<std::string>()));
        const bool isTraced = way.starts_with("pt");
        EXPECT_EQ(row["preparationSeconds"].is_null(), isTraced) << rows.back();
        EXPECT_EQ(row["splats"].is_null(), isTraced) << rows.back();
        EXPECT_EQ(row["samplesPerPixel"].is_null(), way.starts_with("splats")) << rows.back();
        EXPECT_EQ(row["seamRatio"].is_null(), !way.starts_with("hybrid")) << rows.back();
        EXPECT_TRUE(row.contains("silhouetteMeanRatio") && row.contains("silhouetteMostRatio"));
        if (!isTraced) seconds[rows.back()] = row["preparationSeconds"].get<double>();
        EXPECT_GT(row["frameMs"]["p10"].get<double>(), 0.0) << rows.back();
        EXPECT_GT(row["resolutionShare"]["p10"].get<double>(), 0.0) << rows.back();
        EXPECT_LE(row["resolutionShare"]["p90"].get<double>(), 1.0) << rows.back();
        for (const char* region : {"full", "fovea"}) {
            const json& db = row[region]["maskedPsnrDb"];
            EXPECT_GT(db["p10"].get<double>(), 3.0) << rows.back() << region;
            EXPECT_LE(db["p10"].get<double>(), db["median"].get<double>()) << rows.back();
            EXPECT_LE(db["median"].get<double>(), db["p90"].get<double>()) << rows.back();
            EXPECT_LE(row[region]["maskedSsim"]["p90"].get<double>(), 1.0) << rows.back();
            EXPECT_LE(row[region]["flip"]["p90"].get<double>(), 1.0) << rows.back();
        }
    }
    EXPECT_EQ(rows,
              (std::vector<std::string>{"pt", "pt-hq", "splats fresh", "hybrid fresh", "pt-equal fresh",
                                        "splats refined", "hybrid refined", "pt-equal refined",
                                        "splats-hq fresh", "hybrid-hq fresh", "pt-equal-hq fresh",
                                        "splats-hq refined", "hybrid-hq refined", "pt-equal-hq refined"}));
    EXPECT_GT(seconds["hybrid refined"], seconds["hybrid fresh"]);
    EXPECT_EQ(seconds["hybrid fresh"], seconds["splats fresh"]);
    ASSERT_EQ(report["gains"].size(), 4u);
    for (const json& gain : report["gains"]) {
        EXPECT_TRUE(gain["way"].get<std::string>().starts_with("hybrid"));
        EXPECT_TRUE(gain["foveaGainDb"]["median"].is_number()) << gain;
        EXPECT_TRUE(gain["fullGainOverSplatsDb"]["median"].is_number()) << gain;
    }
}

TEST_F(Evaluate, TellsWhatTheLivePictureIsWorthOverTime) {
    const auto isRough = [](const json& picture) {
        return picture["picture"] == "small, traced" || picture["picture"] == "estimate";
    };
    const Ran ran = runBench({"evaluate", "live-picture", "--size", "48", "--truth-spp", "32", "--seconds",
                              "0.5", "--learn", "0", "--rest", "2", "--pictures", "4", "--preset",
                              "cinematic-bone", "--then-preset", "cinematic-soft-tissue"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["benchmark"], "live-picture");
    EXPECT_EQ(report["picture"], json({48, 48}));
    EXPECT_EQ(report["preset"], "cinematic-bone");
    EXPECT_EQ(report["truthSamplesPerPixel"], 32);
    EXPECT_GE(report["motion"]["framesPerSecond"].get<double>(), 0.0);
    EXPECT_TRUE(report.contains("firstModelS"));
    const json& change = report["change"];
    EXPECT_EQ(change["preset"], "cinematic-soft-tissue");
    EXPECT_GT(change["firstNewS"].get<double>(), 0.0);
    EXPECT_GE(1e-3 * change["stale"]["longestMs"].get<double>(), change["firstNewS"].get<double>() - 1e-6);
    EXPECT_TRUE(change["stale"]["wasSaid"].is_boolean());
    EXPECT_EQ(change["rest"]["series"][0]["atS"], change["firstNewS"])
        << "whatever comes is compared with it";
    for (const json& rest : {report["rest"], change["rest"]}) {
        ASSERT_FALSE(rest["series"].empty());
        double lastS = 0.0;
        for (const json& picture : rest["series"]) {
            EXPECT_GT(picture["atS"].get<double>(), lastS);
            lastS = picture["atS"];
            // Reference and live picture are of the same thing, from the same place, over the same black, but
            // not of the same random numbers. On a slow machine all of them are small, or estimates.
            EXPECT_LT(picture["flip"].get<double>(), isRough(picture) ? 0.6 : 0.35) << ran.out;
        }
        EXPECT_EQ(rest["lastFlip"], rest["series"].back()["flip"]);
        if (!isRough(rest["series"].back())) {
            EXPECT_LT(rest["lastFlip"].get<double>(), 0.3) << ran.out;
        }
        EXPECT_GT(rest["lastFlip"].get<double>(), 0.0) << ran.out;
        EXPECT_GT(rest["referenceFlip"].get<double>(), 0.0);
        EXPECT_TRUE(rest.contains("toFlip002S"));
        EXPECT_TRUE(rest.contains("worstSetback"));
        EXPECT_TRUE(rest.contains("worstRise"));
    }
}

TEST_F(Evaluate, RefusesALivePictureThatCannotBe) {
    const auto expectRefusal = [&](const std::vector<std::string>& more, int exitCode, const char* message) {
        std::vector<std::string> arguments{"evaluate", "live-picture", "--size", "16"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = runBench(arguments);
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(message), std::string::npos) << ran.err;
    };
    // The study is not there: what is wrong with the rest is told before anything is read.
    expectRefusal({at("nowhere"), "--then-preset", "ct-unicorn"}, 2, "no such preset");
    expectRefusal({at("nowhere"), "--lights", "disco"}, 2, "no such lights");
    expectRefusal({at("nowhere"), "--truth-spp", "63"}, 2, "even");
    expectRefusal({"--seconds", "nan"}, 2, "--seconds");
    expectRefusal({"--then-preset", write("none.vp.json", kShowsNothing)}, 3,
                  "Nothing of the series can be seen");
}

TEST_F(Evaluate, TellsWhatEachInterpolationDoes) {
    const std::vector<std::string> arguments{"evaluate", "interpolation", "--size", "32", "--spp",
                                             "4",        "--pictures",    at(".")};
    const Ran ran = runBench(arguments);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const json report = json::parse(ran.out);
    EXPECT_EQ(report["benchmark"], "interpolation");
    std::map<std::string, double> ripples;
    for (const json& row : report["surfaces"]) {
        EXPECT_GT(row["luminance"].get<double>(), 0.0) << row;
        ripples[row["shape"].get<std::string>() + " " + row["by"].get<std::string>()] = row["ripple"];
    }
    for (const std::string shape : {"plane", "cylinder", "sphere"}) {
        for (const char* by :
             {"cinematic trilinear", "cinematic stochastic", "cinematic smooth", "cinematic sharp"})
            EXPECT_TRUE(ripples.contains(shape + " " + by)) << ran.out;
        // Without chance: the spline is smoother at any number of samples.
        EXPECT_LT(ripples.at(shape + " dvr smooth"), ripples.at(shape + " dvr trilinear")) << ran.out;
    }
    ASSERT_EQ(report["details"].size(), 12u);
    for (const json& row : report["details"]) EXPECT_GT(row["contrast"].get<double>(), 0.0) << row;
    EXPECT_EQ(runBench(arguments).exitCode, 2) << "the pictures are there";
    EXPECT_EQ(runBench({"evaluate", "interpolation", "--preset", "no-such-preset"}).exitCode, 2);
    EXPECT_EQ(runBench({"evaluate", "interpolation", "--lights", "disco"}).exitCode, 2);
}

TEST_F(Evaluate, WhatCannotBeIsAnError) {
    EXPECT_EQ(runBench({"evaluate"}).exitCode, 2);
    EXPECT_EQ(runBench({"evaluate", "init", "--views", "0"}).exitCode, 2);
    EXPECT_EQ(runBench(small({"--series", "1", "--series", "2"})).exitCode, 2);
    EXPECT_EQ(runBench(small({"--preset", "no-such-preset"})).exitCode, 2);
    const Ran odd = runBench(small({"--truth-spp", "63"}));
    EXPECT_EQ(odd.exitCode, 2);
    EXPECT_NE(odd.err.find("even"), std::string::npos) << odd.err;
    EXPECT_EQ(runBench(small({"--pictures", at("nowhere")})).exitCode, 2);
    EXPECT_EQ(runBench(small({"--json", at("nowhere/report.json")})).exitCode, 2);
    EXPECT_EQ(runBench({"evaluate", "refine", "--snapshot-every", "0"}).exitCode, 2);
    EXPECT_EQ(runBench(small({"--keep-views"})).exitCode, 2) << "where?";
    EXPECT_EQ(runBench({"evaluate", "init", "--more-views", "3"}).exitCode, 2);
    const Ran hanging = runBench(small({"--lights", "headlight"}));
    EXPECT_EQ(hanging.exitCode, 2);
    EXPECT_NE(hanging.err.find("camera"), std::string::npos) << hanging.err;
    EXPECT_EQ(runBench({"evaluate", "quality", "--views", "0"}).exitCode, 2);
    EXPECT_EQ(runBench({"evaluate", "quality", "--lights", "headlight"}).exitCode, 2);
    EXPECT_EQ(runBench({"evaluate", "tradeoff", "--iterations", "0"}).exitCode, 2);
    EXPECT_EQ(runBench({"evaluate", "tradeoff", "--plot", at("nowhere/a.svg")}).exitCode, 2);
    EXPECT_EQ(runBench({"evaluate", "tradeoff", "--lights", "headlight"}).exitCode, 2);
    const Ran oddTruth = runBench({"evaluate", "tradeoff", "--truth-spp", "63"});
    EXPECT_EQ(oddTruth.exitCode, 2);
    EXPECT_NE(oddTruth.err.find("even"), std::string::npos) << oddTruth.err;
    const std::string preset = write("none.vp.json", kShowsNothing);
    EXPECT_EQ(runBench({"evaluate", "tradeoff", "--preset", preset}).exitCode, 3);
    const Ran nothing = runBench(small({"--preset", preset}));
    EXPECT_EQ(nothing.exitCode, 3) << nothing.err;
    EXPECT_NE(nothing.err.find("Nothing of the series can be seen"), std::string::npos) << nothing.err;
}

TEST_F(Evaluate, WhatWasFinishedBeforeAnErrorIsTold) {
    const std::string preset = write("none.vp.json", kShowsNothing);
    const Ran ran =
        runBench(small({"--json", at("report.json"), "--preset", "cinematic-bone", "--preset", preset}));
    EXPECT_EQ(ran.exitCode, 3) << ran.err;
    const json report = json::parse(readAll(at("report.json")));
    EXPECT_EQ(report["scenes"].size(), 1u);
}

}  // namespace
}  // namespace macula::bench
