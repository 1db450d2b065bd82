// Everything that can be wrong: one sentence, the right exit code, nothing left behind.
#include <unistd.h>

#include <filesystem>

#include "cli/run_command.h"

namespace macula::cli {
namespace {

class BadInput : public CommandTest {
  protected:
    // Renders the phantom with `arguments`, and expects `exitCode`, one line of error that contains `words`,
    // and no file besides the `filesBefore` that were there.
    void expectRefused(int exitCode, const std::string& words, std::vector<std::string> arguments) {
        const std::size_t before = fileCount();
        arguments.insert(arguments.begin(), "render");
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_EQ(fileCount(), before) << "something was left behind";
    }
    std::vector<std::string> with(const std::string& option, const std::string& value) const {
        return {"-o", at("a.png"), "--size", "16x16", "--spp", "1", option, value};
    }
};

TEST_F(BadInput, Usage) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{},
                                               {"dance"},
                                               {"render"},
                                               {"info"},
                                               {"render", "--spp"},
                                               {"info", "--nonsense", "x"},
                                               {"sessions"},
                                               {"sessions", "show"},
                                               {"sessions", "purge"}}) {
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, 2) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find("--help"), std::string::npos) << ran.err;
    }
    EXPECT_EQ(runMacula({"--help"}).exitCode, 0);
    EXPECT_EQ(runMacula({"render", "--help"}).exitCode, 0);
    const Ran version = runMacula({"--version"});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_TRUE(version.out.starts_with("macula ")) << version.out;
}

TEST_F(BadInput, VerbsThatAnotherProgramHas) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"bench"},
                                               {"bench", "trace", "--size", "16"},
                                               {"bench", "train", "--help"},
                                               {"evaluate"},
                                               {"evaluate", "init", "--json", at("a.json")}}) {
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, 2) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find("There is no verb " + arguments[0] + ". Call macula-bench"), std::string::npos)
            << ran.err;
    }
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{}, {"render"}, {"cast", "--nonsense"}}) {
        const Ran ran = runBench(arguments);
        EXPECT_EQ(ran.exitCode, 2) << ran.err;
        EXPECT_TRUE(ran.err.starts_with("macula-bench: ")) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find("See macula-bench "), std::string::npos) << ran.err;
    }
    EXPECT_NE(runMacula({"--help"}).out.find("macula-bench"), std::string::npos);
    EXPECT_TRUE(runBench({"--version"}).out.starts_with("macula-bench "));
}

TEST_F(BadInput, Options) {
    expectRefused(2, "--size", with("--size", "640"));
    expectRefused(2, "--size", with("--size", "0x100"));
    expectRefused(2, "--size", with("--size", "640x480garbage"));
    expectRefused(2, "--spp", with("--spp", "0"));
    expectRefused(2, "--error", with("--error", "0"));
    expectRefused(2, "--error", with("--error", "nan"));
    expectRefused(2, "--spp", with("--spp", "many"));
    expectRefused(2, "--bounces", with("--bounces", "0"));
    expectRefused(2, "--fov", with("--fov", "180"));
    expectRefused(2, "--view: sideways is no direction", with("--view", "sideways"));
    expectRefused(2, "--look", with("--look", "pretty"));
    expectRefused(2, "--window", with("--window", "40"));
    expectRefused(2, "--window", with("--window", "40,0"));
    expectRefused(2, "--window", with("--window", "40,400,8"));
    expectRefused(2, "--window", with("--window", "nan,400"));
    expectRefused(2, "--light-rotation", with("--light-rotation", "sideways"));
    expectRefused(2, "--light-strength", with("--light-strength", "-1"));
    expectRefused(2, "--exposure", with("--exposure", "0"));
    expectRefused(2, "--tone-map", with("--tone-map", "pretty"));
    expectRefused(2, "--lens-mm", with("--lens-mm", "-1"));
    expectRefused(2, "--fog-mm", with("--fog-mm", "0"));
    expectRefused(2, "what is sharp", with("--focus-mm", "near"));
    expectRefused(2, "what is sharp", with("--focus-mm", "-300"));
    expectRefused(2, "no such preset", with("--preset", "ct-unicorn"));
    expectRefused(2, "no such lights", with("--lights", "disco"));
    expectRefused(2, "macula: ", with("--device", "no such device"));
    expectRefused(2, "Leave --series out", with("--series", "1"));
}

TEST_F(BadInput, Output) {
    expectRefused(2, ".png or .exr", {"-o", at("a.jpg")});
    expectRefused(2, "does not exist", {"-o", at("no/such/a.png")});
    std::filesystem::create_directory(at("taken.png"));
    expectRefused(2, "folder of that name", {"-o", at("taken.png")});
    if (geteuid() == 0) return;  // root may write anywhere
    std::filesystem::create_directory(at("locked"));
    std::filesystem::permissions(at("locked"),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    expectRefused(2, "cannot be written", {"-o", at("locked/a.png")});
}

TEST_F(BadInput, Folders) {
    expectRefused(3, "macula: ", {at("missing"), "-o", at("a.png")});
    std::filesystem::create_directory(at("empty"));
    expectRefused(3, "macula: ", {at("empty"), "-o", at("a.png")});
    std::filesystem::create_directory(at("letters"));
    write("letters/readme.dcm", "not DICOM at all");
    expectRefused(3, "macula: ", {at("letters"), "-o", at("a.png")});
    for (const char* folder : {"missing", "empty", "letters"}) {
        const Ran info = runMacula({"info", at(folder)});
        EXPECT_EQ(info.exitCode, 3) << folder;
        EXPECT_EQ(info.errorLines(), 1u) << info.err;
    }
}

TEST_F(BadInput, Presets) {
    expectRefused(3, "line 2, column 15", with("--preset", write("comma.json", "{\n    \"macula\": ,\n}")));
    expectRefused(3, "volumeProperties", with("--preset", write("other.json", "{}")));
    expectRefused(3, "does not exist", with("--preset", at("missing.json")));
}

TEST_F(BadInput, Lights) {
    expectRefused(3, "no Radiance HDR", with("--lights", write("list.hdr", "milk, eggs")));
    expectRefused(3, "damaged or incomplete",
                  with("--lights", write("cut.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\nab")));
    expectRefused(3, "line 1", with("--lights", write("rig.json", "[1, 2")));
    expectRefused(
        3, "unknown",
        with("--lights",
             write("typo.json",
                   R"({"version": 1, "name": "a", "title": "A", "frame": "camera", "lamps": []})")));
}

TEST_F(BadInput, Cameras) {
    expectRefused(3, "does not exist", with("--camera", at("missing.json")));
    expectRefused(3, "positionMm",
                  with("--camera", write("short.json", R"({"positionMm": [1, 2], "targetMm": [0, 0, 0],
        "up": [0, 0, 1], "verticalFovDeg": 30})")));
    expectRefused(
        3, "macula: ", with("--camera", write("same.json", R"({"positionMm": [0, 0, 0], "targetMm": [0, 0, 0],
        "up": [0, 0, 1], "verticalFovDeg": 30})")));
    std::vector<std::string> both = with("--camera", at("short.json"));
    both.insert(both.end(), {"--view", "left"});
    expectRefused(2, "--camera", both);
}

TEST_F(BadInput, NoVulkanDriver) {
    const std::vector<std::string> none{"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent"};
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"devices"}, {"render", "-o", at("a.png")}}) {
        const Ran ran = runMacula(arguments, none);
        EXPECT_EQ(ran.exitCode, 4) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    }
    EXPECT_EQ(fileCount(), 0u);
}

}  // namespace
}  // namespace macula::cli
