// What was typed is done, or it is said that it is not; what does not exist is told with what does.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/paths.h"
#include "cli/run_command.h"
#include "image/image_file.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Words : public CommandTest {
  protected:
    Ran render(const std::vector<std::string>& more) const {
        std::vector<std::string> all{"render", writeBall(), "-o", at("a.png"),  "--size",
                                     "16x16",  "--spp",     "1",  "--overwrite"};
        all.insert(all.end(), more.begin(), more.end());
        return runMacula(all);
    }
    void expectRefused(const Ran& ran, const std::string& words) const {
        EXPECT_EQ(ran.exitCode, 2) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_FALSE(fs::exists(at("a.png")));
    }
};

TEST_F(Words, WhatIsNoNumberIsRefused) {
    for (const char* option : {"--fov", "--error", "--exposure", "--light-rotation", "--light-strength",
                               "--surface", "--surface-gradient", "--anisotropy", "--lens-mm", "--fog-mm"}) {
        for (const char* number : {"nan", "NAN", "-nan", "inf", "many", "1x"})
            expectRefused(render({option, number}), option);
    }
}

TEST_F(Words, AnEmptyWordIsNoDefault) {
    expectRefused(render({"--preset", ""}), "--preset is empty");
    expectRefused(render({"--lights", ""}), "--lights is empty");
    expectRefused(render({"--series", ""}), "--series is empty");
    expectRefused(render({"--json", ""}), "--json is empty");
    // A variable of a script that is not set must not show the phantom.
    expectRefused(runMacula({"render", "", "-o", at("a.png")}), "PATH is empty");
}

TEST_F(Words, OptionsWithoutEffectAreTold) {
    const auto expectTold = [&](const std::vector<std::string>& more, const std::string& option) {
        const Ran ran = render(more);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_NE(ran.err.find(option + " does nothing"), std::string::npos) << ran.err;
    };
    expectTold({"--window", "40,400"}, "--window");
    expectTold({"--look", "dvr", "--window", "40,400"}, "--window");
    expectTold({"--look", "mip", "--bounces", "2"}, "--bounces");
    expectTold({"--look", "mip", "--lights", "even"}, "--lights");
    expectTold({"--look", "minip", "--light-strength", "2"}, "--light-strength");
    expectTold({"--look", "average", "--exposure", "2"}, "--exposure");
    expectTold({"--look", "dvr", "--surface", "0.5"}, "--surface");
    expectTold({"--look", "mip", "--anisotropy", "0.5"}, "--anisotropy");
    expectTold({"--preset", "ct-bone", "--roughness", "0.5"}, "--roughness");
    expectTold({"--look", "cinematic", "--shading"}, "--shading");
    expectTold({"--keep-unfinished"}, "--keep-unfinished");
    expectTold({"--look", "mip", "--tone-map", "hue"}, "--tone-map");
    expectTold({"--look", "minip", "--fog-mm", "50"}, "--fog-mm");
    expectTold({"--look", "dvr", "--lens-mm", "20"}, "--lens-mm");
    expectTold({"--focus-mm", "300"}, "--focus-mm");
    const Ran quiet = render({"--look", "mip", "--window", "40,400"});
    EXPECT_EQ(quiet.err.find("does nothing"), std::string::npos) << quiet.err;
}

// It is the camera file's that --fov replaces.
TEST_F(Words, FovCountsMoreThanTheCameraFile) {
    const std::string camera = write(
        "camera.json",
        R"({"positionMm": [0, -700, 0], "targetMm": [0, 0, 0], "up": [0, 0, 1], "verticalFovDeg": 30})");
    const Ran ran = render({"--camera", camera, "--fov", "50", "--json", "-"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(json::parse(ran.out)["camera"]["verticalFovDeg"], 50.0);
}

TEST_F(Words, WhatDoesNotExistIsToldWithWhatDoes) {
    const auto expectNearest = [&](const Ran& ran, const std::string& nearest, const std::string& another) {
        expectRefused(ran, "Did you mean " + nearest + "?");
        EXPECT_NE(ran.err.find(another), std::string::npos) << ran.err;
    };
    expectNearest(render({"--preset", "ct-bnoe"}), "ct-bone", "cinematic-chest");
    expectNearest(render({"--lights", "studoi"}), "studio", "headlight");
    expectNearest(render({"--clip", "left-haf"}), "left-half", "slab-axial");
    expectNearest(render({"--look", "cinematc"}), "cinematic", "average");
    expectNearest(runMacula({"rendr"}), "render", "export");
    const Ran far = render({"--preset", "xyzzyplugh"});
    expectRefused(far, "There are: ");
    EXPECT_EQ(far.err.find("Did you mean"), std::string::npos) << far.err;
}

TEST_F(Words, APictureWithNothingInItSaysSo) {
    const std::string preset = write("none.json", R"({"volumeProperties": [{"components": [{
        "rgbTransferFunction": {"type": "colorTransferFunction", "points": [{"x": 0, "color": [1, 1, 1]}]},
        "scalarOpacity": {"type": "piecewiseLinearFunction", "points": [{"x": 20000, "y": 0}, {"x": 30000, "y": 1}]}}]}]})");
    for (const char* name : {"a.png", "a.exr"}) {
        const Ran ran = runMacula({"render", "phantom:", "-o", at(name), "--size", "16x16", "--spp", "1",
                                   "--preset", preset, "--json", at("a.json"), "--overwrite"});
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_NE(ran.err.find("macula: warning: Nothing is visible"), std::string::npos) << ran.err;
        EXPECT_NE(ran.err.find(" HU. Presets that show"), std::string::npos) << ran.err;
        EXPECT_NE(ran.err.find("cinematic-bone"), std::string::npos) << ran.err;
        EXPECT_NE(json::parse(readAll(at("a.json")))["notes"].dump().find("Nothing is visible"),
                  std::string::npos);
    }
    EXPECT_EQ(render({}).err.find("Nothing is visible"), std::string::npos);
}

TEST_F(Words, APictureTellsAllThatMadeIt) {
    const Ran ran = render(
        {"--look", "mip", "--window", "40,400", "--exposure", "2", "--view", "left", "--json", at("a.json")});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const std::vector<std::string> keys{
        "macula:window",           "macula:unit",           "macula:exposure", "macula:lightRotationDeg",
        "macula:cameraPositionMm", "macula:verticalFovDeg", "macula:notes"};
    const auto found = image::readMetadata(at("a.png"), keys);
    ASSERT_TRUE(found.ok());
    const std::map<std::string, std::string> metadata(found->begin(), found->end());
    EXPECT_EQ(metadata.at("macula:window"), "40,400");
    EXPECT_EQ(metadata.at("macula:unit"), "HU");
    EXPECT_EQ(metadata.at("macula:exposure"), "2");
    EXPECT_EQ(metadata.at("macula:lightRotationDeg"), "0");
    EXPECT_EQ(metadata.at("macula:verticalFovDeg"), "30");
    EXPECT_NE(metadata.at("macula:notes").find("--exposure does nothing"), std::string::npos);
    const json report = json::parse(readAll(at("a.json")));
    EXPECT_EQ(report["window"]["center"], 40.0);
    const std::string camera = metadata.at("macula:cameraPositionMm");
    EXPECT_EQ(std::stod(camera), std::round(report["camera"]["positionMm"][0].get<double>() * 1e3) / 1e3);
}

TEST_F(Words, APictureTellsOfItsMatter) {
    const auto matterOf = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all{"--preset", "ct-bone", "--json", at("a.json")};
        all.insert(all.end(), more.begin(), more.end());
        const Ran ran = render(all);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_EQ(ran.err.find("does nothing"), std::string::npos) << ran.err;
        const json report = json::parse(readAll(at("a.json")));
        EXPECT_EQ(report["preset"], "ct-bone");
        const auto picture = image::readImage(at("a.png"));
        EXPECT_TRUE(picture.ok());
        return std::pair(report["matter"], picture ? picture->pixels : std::vector<float>{});
    };
    const auto plain = matterOf({});
    EXPECT_EQ(plain.first["surfaceWeight"], 0.0);
    const auto given = matterOf({"--surface", "0.75", "--surface-gradient", "60", "--roughness", "0.2",
                                 "--reflectance", "0.05", "--anisotropy", "-0.25"});
    EXPECT_EQ(given.first, json::parse(R"({"surfaceWeight": 0.75, "surfaceGradientPerMm": 60.0,
        "roughness": 0.2, "reflectance": 0.05, "anisotropy": -0.25, "steepGradientPerMm": 200.0})"));
    EXPECT_NE(given.second, plain.second);
    const std::vector<std::string> keys{"macula:surfaceWeight", "macula:roughness"};
    const auto found = image::readMetadata(at("a.png"), keys);
    ASSERT_TRUE(found.ok());
    const std::map<std::string, std::string> metadata(found->begin(), found->end());
    EXPECT_EQ(metadata.at("macula:surfaceWeight"), "0.75");
    EXPECT_EQ(metadata.at("macula:roughness"), "0.2");
}

TEST_F(Words, MatterThatNoPresetMayHaveIsRefused) {
    expectRefused(render({"--surface", "1.01"}), "--surface");
    expectRefused(render({"--surface-gradient", "0"}), "--surface-gradient");
    expectRefused(render({"--roughness", "0.09"}), "0.1 to 1");
    expectRefused(render({"--reflectance", "-0.1"}), "--reflectance");
    expectRefused(render({"--anisotropy", "1"}), "-0.99 to 0.99");
}

TEST_F(Words, ASheetNamesEachPicture) {
    ASSERT_EQ(runMacula({"sheet", writeBall(), "-o", at("s.png"), "--tile", "16", "--spp", "1"}).exitCode, 0);
    const std::vector<std::string> keys{"macula:pictures", "macula:view"};
    const auto found = image::readMetadata(at("s.png"), keys);
    ASSERT_TRUE(found.ok());
    const std::map<std::string, std::string> metadata(found->begin(), found->end());
    const std::string& pictures = metadata.at("macula:pictures");
    EXPECT_TRUE(
        pictures.starts_with("column 1 row 1: cinematic-bone cinematic; column 2 row 1: cinematic-bone"))
        << pictures.substr(0, 100);
    EXPECT_NE(pictures.find("us-fetal mip"), std::string::npos);
    EXPECT_EQ(metadata.at("macula:view"), "anterior");
}

// docs/command.md: "this one sees `ct_cta_rider` from the front".
TEST_F(Words, TheCameraOfTheDocsSeesItsStudy) {
    const fs::path study = macula::test::sharedFolder() / "data/ct_cta_rider";
    if (!fs::exists(study)) GTEST_SKIP() << "the study is not here";
    std::istringstream page(readAll(macula::test::projectFolder() / "docs/command.md"));
    std::string camera;
    for (std::string line; camera.empty() && std::getline(page, line);) {
        if (line.starts_with("    {\"positionMm\"")) camera = line;
    }
    ASSERT_FALSE(camera.empty());
    const Ran ran = runMacula({"render", study.string(), "-o", at("a.exr"), "--size", "32x32", "--spp", "1",
                               "--camera", write("camera.json", camera)});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto picture = image::readImage(at("a.exr"));
    ASSERT_TRUE(picture.ok());
    // The thorax fills the width, and lies in the middle.
    std::size_t seen = 0;
    for (std::size_t x = 0; x < 32; ++x) seen += picture->pixels[(16 * 32 + x) * 5 + 3] > 0.0f ? 1 : 0;
    EXPECT_GT(seen, 20u);
}

TEST_F(Words, EndingsMayBeInCapitals) {
    const std::string ball = writeBall();
    EXPECT_EQ(runMacula({"render", ball, "-o", at("A.PNG"), "--size", "16x16", "--spp", "1"}).exitCode, 0);
    EXPECT_TRUE(readAll(at("A.PNG")).starts_with("\x89PNG"));
    EXPECT_EQ(runMacula({"render", ball, "-o", at("A.EXR"), "--size", "16x16", "--spp", "1"}).exitCode, 0);
    EXPECT_TRUE(readAll(at("A.EXR")).starts_with("\x76\x2f\x31\x01"));
}

TEST_F(Words, ThePhantomHasInfoToo) {
    const Ran ran = runMacula({"info", "phantom:"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.out.find("built-in phantom"), std::string::npos) << ran.out;
    EXPECT_EQ(json::parse(runMacula({"info", "phantom:", "--json"}).out)["volumeFile"]["unit"], "HU");
}

TEST_F(Words, AFileThatEndsEarlyIsNotFine) {
    ASSERT_EQ(runMacula({"export", "phantom:", "-o", at("v.nii.gz")}).exitCode, 0);
    ASSERT_EQ(runMacula({"info", at("v.nii.gz")}).exitCode, 0);
    fs::resize_file(at("v.nii.gz"), fs::file_size(at("v.nii.gz")) / 2);
    const Ran ran = runMacula({"info", at("v.nii.gz")});
    EXPECT_EQ(ran.exitCode, 3) << ran.out;
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
}

TEST_F(Words, MissingSlicesAreAWarning) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    for (int slice = 60; slice < 80; ++slice) fs::remove(at(fmt::format("study/IM{:05}.dcm", slice)));
    for (const std::vector<std::string>& verb : std::vector<std::vector<std::string>>{
             {"render", at("study"), "-o", at("a.png"), "--size", "16x16", "--spp", "1"},
             {"export", at("study"), "-o", at("a.nii")}}) {
        const Ran ran = runMacula(verb);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_NE(ran.err.find("macula: warning: "), std::string::npos) << ran.err;
        EXPECT_NE(ran.err.find("20"), std::string::npos) << ran.err;
    }
}

TEST_F(Words, WhatWasWrittenIsToldAndWhere) {
    const Ran ran = render({});
    EXPECT_NE(ran.err.find("Wrote " + at("a.png") + " in "), std::string::npos) << ran.err;
}

// By a name that the shell looks up, from another folder: what is loaded when it is needed is found all the
// same.
TEST_F(Words, IsFoundByPath) {
    const fs::path program = MACULA_BINARY;
    const std::string call =
        fmt::format("cd / && PATH='{}':$PATH macula render '{}' -o '{}' --size 16x16 --spp 1 2>'{}'",
                    program.parent_path().string(), writeBall(), at("a.png"), at("err"));
    EXPECT_EQ(std::system(call.c_str()), 0) << readAll(at("err"));
}

TEST_F(Words, ATerminalThatUnderstandsNothingGetsNoControlCharacters) {
    const auto never = [](const std::string&) { return false; };
    const std::vector<std::string> arguments{"render", "-o", at("a.png"), "--size",         "64x64",
                                             "--spp",  "16", "--preset",  "cinematic-bone", "--overwrite"};
    setenv("TERM", "dumb", 1);
    const Ran dumb = runMaculaInterrupted(arguments, never);
    setenv("TERM", "xterm", 1);
    const Ran clever = runMaculaInterrupted(arguments, never);
    EXPECT_EQ(dumb.exitCode, 0) << dumb.err;
    EXPECT_EQ(dumb.err.find('\x1b'), std::string::npos) << dumb.err;
    EXPECT_NE(clever.err.find('\x1b'), std::string::npos) << clever.err;
}

}  // namespace
}  // namespace macula::cli
