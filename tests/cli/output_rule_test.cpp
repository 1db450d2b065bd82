// What a call may write: never an input, never a file of a folder that is read, never another output of the
// same call, and what exists only with --overwrite. The same for every verb and option that writes.
#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>
#include <map>

#include "cli/run_command.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCamera =
    R"({"positionMm": [0, -700, 0], "targetMm": [0, 0, 0], "up": [0, 0, 1], "verticalFovDeg": 30})";

class OutputRule : public CommandTest {
  protected:
    // Expects exit code 2, one sentence with `words`, and every file as it was.
    void expectKept(const std::vector<std::string>& arguments, const std::string& words,
                    TestedProgram program = TestedProgram::macula) {
        const auto before = contents();
        const Ran ran = run(program, arguments);
        const std::string call = fmt::format("{}", fmt::join(arguments, " "));
        EXPECT_EQ(ran.exitCode, 2) << call << "\n" << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << call << "\n" << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << call << "\n" << ran.err;
        EXPECT_EQ(contents(), before) << call;
    }
    // With --overwrite all the more.
    void expectNeverReplaced(std::vector<std::string> arguments, const std::string& words,
                             TestedProgram program = TestedProgram::macula) {
        expectKept(arguments, words, program);
        arguments.emplace_back("--overwrite");
        expectKept(arguments, words, program);
    }
    std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder_))
            all[entry.path().string()] = entry.is_regular_file() ? readAll(entry.path()) : "";
        return all;
    }
    std::vector<std::string> render(const std::vector<std::string>& more) const {
        std::vector<std::string> all{"render", "--size", "16x16", "--spp", "1"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    std::string anExport(const std::string& name) const {
        EXPECT_EQ(runMacula({"export", "phantom:", "-o", at(name)}).exitCode, 0);
        return at(name);
    }
};

TEST_F(OutputRule, AFileThatExistsNeedsOverwrite) {
    for (const char* name : {"a.png", "a.json", "a.svg", "a.ply", "a.nii", "a.mha", "scene00-view00.png"})
        write(name, "what was there");
    const std::string words = "--overwrite";
    expectKept(render({"-o", at("a.png")}), words);
    expectKept(render({"-o", at("b.png"), "--json", at("a.json")}), words);
    expectKept({"sheet", "-o", at("a.png")}, words);
    expectKept({"export", "phantom:", "-o", at("a.nii")}, words);
    expectKept({"segment", "phantom:", "-o", at("a.nii"), "--threshold", "300", "3000"}, words);
    expectKept({"presets", "export", "ct-bone", "-o", at("a.json")}, words);
    expectKept({"train", "phantom:", "-o", at("a.ply")}, words);
    expectKept({"train", "phantom:", "-o", at("b.ply"), "--json", at("a.json")}, words);
    expectKept({"evaluate", "init", "phantom:", "--json", at("a.json")}, words, TestedProgram::bench);
    expectKept({"evaluate", "init", "phantom:", "--pictures", at(".")}, words, TestedProgram::bench);
    expectKept({"trace-tradeoff", "--plot", at("a.svg")}, words, TestedProgram::bench);
    expectKept({"evaluate", "tradeoff", "--plot", at("a.svg")}, words, TestedProgram::bench);

    EXPECT_EQ(runMacula(render({"-o", at("a.png"), "--json", at("a.json"), "--overwrite"})).exitCode, 0);
    EXPECT_TRUE(readAll(at("a.png")).starts_with("\x89PNG"));
    EXPECT_TRUE(readAll(at("a.json")).starts_with("{"));
}

TEST_F(OutputRule, AFileOfTheFolderThatIsReadIsNeverReplaced) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    fs::create_directory(at("study/deep"));
    fs::rename(at("study/IM00002.dcm"), at("study/deep/IM00002.dcm"));
    const std::string study = at("study");
    const std::string slice = at("study/IM00001.dcm");
    const std::string words = "belongs to the folder that is read";
    expectNeverReplaced(render({study, "-o", at("b.png"), "--json", slice}), words);
    expectNeverReplaced(render({study, "-o", at("b.png"), "--json", at("study/deep/IM00002.dcm")}), words);
    expectNeverReplaced(render({study, "-o", at("b.png"), "--json", at("study/deep/../IM00001.dcm")}), words);
    fs::create_symlink(study, at("link"));
    expectNeverReplaced(render({at("link"), "-o", at("b.png"), "--json", slice}), words);
    expectNeverReplaced(render({study, "-o", at("b.png"), "--json", at("link/IM00001.dcm")}), words);
    fs::create_symlink(slice, at("b.json"));
    expectNeverReplaced(render({study, "-o", at("b.png"), "--json", at("b.json")}), words);
    expectNeverReplaced({"trace-tradeoff", study, "--plot", slice}, words, TestedProgram::bench);
    expectNeverReplaced({"evaluate", "tradeoff", study, "--plot", slice}, words, TestedProgram::bench);
    expectNeverReplaced({"train", study, "-o", at("b.ply"), "--json", slice}, words);
    expectNeverReplaced({"evaluate", "init", study, "--json", slice}, words, TestedProgram::bench);
    // A slice alone, and what lies beside it.
    expectNeverReplaced(render({slice, "-o", at("b.png"), "--json", slice}), "one of those that are read");
}

TEST_F(OutputRule, NoInputIsReplaced) {
    const std::string words = "one of those that are read";
    const std::string camera = write("camera.json", kCamera);
    ASSERT_EQ(runMacula({"presets", "export", "ct-bone", "-o", at("preset.json")}).exitCode, 0);
    ASSERT_EQ(runMacula(render({"-o", at("b.exr")})).exitCode, 0);
    const std::string volume = anExport("a.nii.gz");
    const std::string header = anExport("a.mhd");
    expectNeverReplaced(render({volume, "-o", at("b.png"), "--json", volume}), words);
    expectNeverReplaced(render({"-o", at("b.png"), "--camera", camera, "--json", camera}), words);
    expectNeverReplaced(
        render({"-o", at("b.png"), "--preset", at("preset.json"), "--json", at("preset.json")}), words);
    expectNeverReplaced(render({"-o", at("b.exr"), "--lights", at("b.exr")}), words);
    const std::string view = write("view.json", R"({"version": 1})");
    expectNeverReplaced(render({"-o", at("b.png"), "--session", view, "--json", view}), words);
    expectNeverReplaced({"export", volume, "-o", volume}, words);
    expectNeverReplaced({"segment", volume, "-o", volume, "--threshold", "300", "3000"}, words);
    // The other header would have its values in the same file.
    expectNeverReplaced({"export", header, "-o", at("a.nhdr")}, words);
    expectNeverReplaced({"presets", "import", at("preset.json"), "-o", at("preset.json")}, words);
    expectNeverReplaced({"presets", "export", at("preset.json"), "-o", at("preset.json")}, words);
    expectNeverReplaced({"trace-tradeoff", volume, "--plot", volume}, words, TestedProgram::bench);
    expectNeverReplaced({"evaluate", "tradeoff", volume, "--plot", volume}, words, TestedProgram::bench);
    expectNeverReplaced({"evaluate", "tradeoff", "--preset", at("preset.json"), "--plot", at("preset.json")},
                        words, TestedProgram::bench);
    expectNeverReplaced({"train", volume, "-o", at("b.ply"), "--json", volume}, words);
    expectNeverReplaced({"evaluate", "init", volume, "--json", volume}, words, TestedProgram::bench);
}

TEST_F(OutputRule, TwoOutputsAreTwoFiles) {
    expectNeverReplaced(render({"-o", at("a.png"), "--json", at("a.png")}), "same name");
    expectNeverReplaced(render({"-o", at("a.png"), "--json", at("./a.png")}), "same name");
    expectNeverReplaced({"train", "phantom:", "-o", at("a.ply"), "--json", at("a.ply")}, "same name");
}

TEST_F(OutputRule, WhatIsNoFileStays) {
    ASSERT_EQ(mkfifo(at("pipe.json").c_str(), 0600), 0);
    expectNeverReplaced(render({"-o", at("a.png"), "--json", at("pipe.json")}), "no file");
    expectNeverReplaced({"presets", "export", "ct-bone", "-o", at("pipe.json")}, "no file");
}

}  // namespace
}  // namespace macula::cli
