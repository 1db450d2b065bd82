// macula hybrid: the live picture without a window.
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli/run_command.h"
#include "image/image_file.h"

namespace macula::cli {
namespace {

using Hybrid = CommandTest;
using nlohmann::json;

std::vector<json> framesOf(const std::string& folder) {
    std::vector<json> frames;
    std::istringstream lines(readAll(folder + "/frames.jsonl"));
    for (std::string line; std::getline(lines, line);) frames.push_back(json::parse(line));
    return frames;
}

constexpr const char* kPath = R"([
    {"atS": 0, "camera": {"positionMm": [0, -600, 0], "targetMm": [0, 0, 0], "up": [0, 0, 1], "verticalFovDeg": 10}},
    {"atS": 1, "camera": {"positionMm": [30, -600, 0], "targetMm": [0, 0, 0], "up": [0, 0, 1], "verticalFovDeg": 10}}
])";

TEST_F(Hybrid, RecordsWhatIsShownFromOpeningToRest) {
    const std::string folder = at("frames");
    const Ran ran = runMacula({"hybrid", writeBall(), "-o", folder, "--size", "64x48", "--path",
                               write("path.json", kPath), "--learn", "0", "--rest", "1", "--pictures", "4"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.out.find("frames on "), std::string::npos) << ran.out;
    const std::vector<json> frames = framesOf(folder);
    ASSERT_FALSE(frames.empty());
    double lastS = 0.0;
    std::set<std::string> phases;
    std::set<std::string> files;
    for (const json& frame : frames) {
        EXPECT_GE(frame["atS"].get<double>(), lastS);
        lastS = frame["atS"];
        phases.insert(frame["phase"]);
        EXPECT_GE(frame["latencyMs"].get<double>(), 0.0);
        EXPECT_GE(frame["tracedShare"].get<double>(), 0.0);
        EXPECT_LE(frame["tracedShare"].get<double>(), 1.0);
        EXPECT_TRUE(frame["fidelity"] == "final" || frame["fidelity"] == "preliminary");
        if (!frame.contains("file")) continue;
        EXPECT_TRUE(files.insert(frame["file"]).second);
        EXPECT_TRUE(std::filesystem::exists(folder + "/" + frame["file"].get<std::string>()));
    }
    EXPECT_TRUE(phases.contains("opening"));
    EXPECT_TRUE(phases.contains("resting"));
    // The last frame is of where the camera has stopped, and its picture is there.
    EXPECT_EQ(frames.back()["camera"]["positionMm"], json({30.0, -600.0, 0.0}));
    ASSERT_TRUE(frames.back().contains("file"));
    const auto picture = image::readImage(folder + "/" + frames.back()["file"].get<std::string>());
    ASSERT_TRUE(picture.ok());
    // The ball in the middle, nothing in the corner.
    const auto at = [&](int x, int y) {
        return picture->pixels[std::size_t(picture->channels) *
                               (std::size_t(y) * std::size_t(picture->width) + std::size_t(x))];
    };
    EXPECT_GT(at(picture->width / 2, picture->height / 2), 0.2f);
    EXPECT_LT(at(0, 0), 0.1f);
}

// What was learnt in one run of the program is shown from the first hybrid frame on in the next.
TEST_F(Hybrid, GoesOnFromTheModelOfAnEarlierRun) {
    const std::string ball = writeBall();
    const auto record = [&](const std::string& folder, const std::vector<std::string>& more) {
        // A model with its first steps is there when the time to learn begins.
        std::vector<std::string> arguments{"hybrid",    ball,      "-o",         at(folder), "--size",
                                           "64x48",     "--learn", "1",          "--rest",   "0",
                                           "--seconds", "1",       "--pictures", "0"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return framesOf(at(folder));
    };
    const std::vector<std::string> kept{"--sessions", at("sessions")};
    const auto first = record("first", kept);
    ASSERT_FALSE(first.empty());
    EXPECT_EQ(first.back()["model"]["origin"], "fresh");
    EXPECT_EQ(first.back()["model"]["why"], "no model of this is stored");
    const std::uint64_t steps = first.back()["model"]["steps"];
    ASSERT_GE(steps, 40u);
    const auto second = record("second", kept);
    for (const json& frame : second) {
        if (frame["model"]["splats"] > 0) {
            EXPECT_EQ(frame["model"]["origin"], "resumed");
        }
    }
    EXPECT_EQ(second.back()["model"]["origin"], "resumed");
    EXPECT_GE(second.back()["model"]["steps"].get<std::uint64_t>(), steps);
    const auto none = record("third", {"--no-session"});
    EXPECT_EQ(none.back()["model"]["origin"], "fresh");
    EXPECT_FALSE(runMacula({"hybrid", ball, "-o", at("x"), "--no-session", "--sessions", at("s")}).exitCode ==
                 0);
}

TEST_F(Hybrid, RefusesWhatItCannotRecord) {
    const std::string ball = writeBall();
    const auto expectRefusal = [&](const std::vector<std::string>& more, int exitCode, const char* message) {
        std::vector<std::string> arguments{"hybrid", ball};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_NE(ran.err.find(message), std::string::npos) << ran.err;
    };
    expectRefusal({}, 2, "--output");
    expectRefusal({"-o", at(".")}, 2, "The folder is not empty.");
    expectRefusal({"-o", at("none/deeper")}, 2, "does not exist");
    expectRefusal({"-o", at("f"), "--path", write("bad.json", "[]")}, 3, "bad.json");
    expectRefusal({"-o", at("f"), "--size", "0x10"}, 2, "size");
    expectRefusal({"-o", at("f"), "--turn", "nan"}, 2, "--turn");
    expectRefusal({"-o", at("f"), "--lights", "nobody"}, 2, "lights");
    EXPECT_FALSE(std::filesystem::exists(at("f"))) << "no folder is made for what cannot be recorded";
}

}  // namespace
}  // namespace macula::cli
