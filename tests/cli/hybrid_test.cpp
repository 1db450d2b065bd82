// macula hybrid: the live picture without a window.
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli/run_command.h"
#include "dicom/synthetic.h"
#include "dicom/synthetic_segmentation.h"
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
    const auto record = [&](const std::string& folder, const std::vector<std::string>& more,
                            int learnSeconds = 1) {
        std::vector<std::string> arguments{"hybrid",     ball,    "-o",        at(folder),
                                           "--size",     "64x48", "--learn",   std::to_string(learnSeconds),
                                           "--rest",     "0",     "--seconds", "1",
                                           "--pictures", "0"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return framesOf(at(folder));
    };
    // Once more for longer where the machine was too slow for a model; each time with what was stored before,
    // since a model that was hardly begun is stored too. Returns the frames, and what is stored now.
    const auto recordFresh = [&](const std::string& folder, const std::string& storedBefore,
                                 const std::vector<std::string>& more) {
        std::vector<json> frames;
        std::string stored;
        for (int learnSeconds = 1; learnSeconds <= 64; learnSeconds *= 4) {
            const std::string name = folder + std::to_string(learnSeconds);
            stored = at(name + "-sessions");
            if (!storedBefore.empty())
                std::filesystem::copy(storedBefore, stored, std::filesystem::copy_options::recursive);
            std::vector<std::string> arguments{"--sessions", stored};
            arguments.insert(arguments.end(), more.begin(), more.end());
            frames = record(name, arguments, learnSeconds);
            if (!frames.empty() && frames.back()["model"]["steps"] >= 40) break;
        }
        return std::pair(frames, stored);
    };
    // For longer where it was too slow to show a model at all; the last frame is of that.
    const auto recordUntilShown = [&](const std::string& folder, const std::vector<std::string>& more) {
        std::vector<json> frames;
        for (int learnSeconds = 1; learnSeconds <= 64; learnSeconds *= 4) {
            frames = record(folder + std::to_string(learnSeconds), more, learnSeconds);
            if (!frames.empty() && frames.back()["model"]["splats"] > 0) break;
        }
        return frames;
    };
    const auto [first, stored] = recordFresh("first", {}, {});
    ASSERT_FALSE(first.empty());
    EXPECT_EQ(first.back()["model"]["origin"], "fresh");
    EXPECT_EQ(first.back()["model"]["why"], "no model of this is stored");
    const std::uint64_t steps = first.back()["model"]["steps"];
    ASSERT_GE(steps, 40u);
    const auto second = recordUntilShown("second", {"--sessions", stored});
    ASSERT_FALSE(second.empty());
    for (const json& frame : second) {
        if (frame["model"]["splats"] > 0) {
            EXPECT_EQ(frame["model"]["origin"], "resumed");
        }
    }
    EXPECT_EQ(second.back()["model"]["origin"], "resumed");
    EXPECT_GE(second.back()["model"]["steps"].get<std::uint64_t>(), steps);
    // With a second volume it is another scene: what was learnt of the one alone is not shown of both.
    const std::string other = writeBall("other.nrrd");
    const std::vector<std::string> both{"--second", other, "--second-preset", "ct-muscle"};
    const auto [mixed, storedOfBoth] = recordFresh("mixed", stored, both);
    ASSERT_FALSE(mixed.empty());
    for (const json& frame : mixed) EXPECT_NE(frame["model"]["origin"], "resumed");
    EXPECT_EQ(mixed.back()["model"]["origin"], "fresh");
    ASSERT_GT(mixed.back()["model"]["splats"], 0);
    std::vector<std::string> again{"--sessions", storedOfBoth};
    again.insert(again.end(), both.begin(), both.end());
    EXPECT_EQ(recordUntilShown("mixed again", again).back()["model"]["origin"], "resumed");
    const auto none = recordUntilShown("third", {"--no-session"});
    EXPECT_EQ(none.back()["model"]["origin"], "fresh");
    EXPECT_FALSE(runMacula({"hybrid", ball, "-o", at("x"), "--no-session", "--sessions", at("s")}).exitCode ==
                 0);
}

// A folder of 12 x 12 x 12 voxels of 5 mm, most of them bone, with a segmentation of the middle.
void writeSegmented(const std::string& folder) {
    dicom::test::SyntheticSeries series;
    series.size = {12, 12, 12};
    series.worldFromVoxel = glm::dmat4(5.0);
    series.worldFromVoxel[3] = {-27.5, -27.5, -27.5, 1.0};
    series.ramp = dicom::test::Ramp{.value = 500.0, .throughMm = glm::dvec3(0.0), .perMm = {2.0, 3.0, 4.0}};
    dicom::test::writeFiles(folder + "/ct", series);
    dicom::test::SyntheticSegmentation segmentation;
    segmentation.size = series.size;
    segmentation.worldFromVoxel = series.worldFromVoxel;
    segmentation.parts = {{.number = 1, .label = "Liver", .share = [](const glm::dvec3& mm) {
                               return glm::length(mm) <= 15.0 ? 1.0 : 0.0;
                           }}};
    dicom::test::writeSegmentation(folder + "/seg/a", segmentation);
}

TEST_F(Hybrid, SegmentsAreColouredOrLeftOutAndEachFrameSaysSo) {
    writeSegmented(at("study"));
    const auto record = [&](const std::string& folder, const std::string& segments) {
        return runMacula({"hybrid", at("study"), "-o", at(folder), "--size", "32x24", "--seconds", "0",
                          "--rest", "0", "--learn", "0", "--no-session", "--segments", segments});
    };
    const auto expectParts = [&](const std::string& folder, const std::string& segments,
                                 const std::string& masked, const std::string& additions) {
        const Ran ran = record(folder, segments);
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        ASSERT_FALSE(framesOf(at(folder)).empty());
        for (const json& frame : framesOf(at(folder))) {
            EXPECT_EQ(frame["masked"], masked);
            EXPECT_EQ(frame["additions"], additions);
        }
    };
    expectParts("coloured", "colour:liver", "none", "coloured segments");
    expectParts("hidden", "hide:Liver", "a segment left out", "none");
    const Ran unknown = record("unknown", "keep:Spleen");
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.err.find("No segmentation of this volume has a segment of that label."),
              std::string::npos)
        << unknown.err;
    EXPECT_FALSE(std::filesystem::exists(at("unknown/frames.jsonl")));
}

TEST_F(Hybrid, ASecondVolumeInAnotherPlaceIsRefused) {
    const std::string ball = writeBall();
    std::string text = readAll(ball);
    const std::string origin = "space origin: (-46,-46,-46)";
    text.replace(text.find(origin), origin.size(), "space origin: (954,-46,-46)");
    const Ran ran = runMacula({"hybrid", ball, "-o", at("f"), "--size", "32x24", "--no-session", "--second",
                               write("far.nrrd", text)});
    EXPECT_EQ(ran.exitCode, 3) << ran.err;
    EXPECT_NE(ran.err.find("Nothing of the second volume lies in the study."), std::string::npos) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(at("f")));
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
    expectRefusal({"-o", at("f"), "--second-preset", "ct-bone"}, 2, "There is no second volume.");
    expectRefusal({"-o", at("f"), "--registration", "search"}, 2, "There is no second volume.");
    expectRefusal({"-o", at("f"), "--second", ball, "--registration", "guess"}, 2, "--registration");
    expectRefusal({"-o", at("f"), "--second", ball}, 3, "The second volume is the study itself.");
    const std::string other = writeBall("other.nrrd");
    expectRefusal({"-o", at("f"), "--second", other, "--second-preset", "nonsense"}, 2, "nonsense");
    std::filesystem::create_directory(at("nothing"));
    const Ran empty = runMacula({"hybrid", at("nothing"), "-o", at("f")});
    EXPECT_EQ(empty.exitCode, 3) << empty.err;
    expectRefusal({"-o", at("f"), "--segments", "drop:Liver"}, 2, "keep:LABEL");
    expectRefusal({"-o", at("f"), "--segments", "keep:Liver"}, 2, "Only a folder of DICOM files");
    EXPECT_FALSE(std::filesystem::exists(at("f"))) << "no folder is made for what cannot be recorded";
}

}  // namespace
}  // namespace macula::cli
