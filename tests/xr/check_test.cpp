// macula xr and macula-bench xr, as a person runs them.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/run_command.h"
#include "xr/runtime.h"

namespace macula::xr {
namespace {

using cli::Ran;
using cli::runBench;
using cli::runMacula;

const std::string kScripted = "XR_RUNTIME_JSON=" MACULA_XR_MANIFEST;

class XrCommand : public cli::CommandTest {
  protected:
    static void expectMissing(const Ran& ran, const std::string& words) {
        EXPECT_EQ(ran.exitCode, 4) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_EQ(ran.out.find("can be shown"), std::string::npos) << ran.out;
    }
};

TEST_F(XrCommand, CheckTellsWhatThereIs) {
    const Ran ran = runMacula({"xr", "--check"}, {kScripted});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    for (const char* words :
         {"Scripted runtime 1.2.3", "Scripted headset", "64x64 pixels", "followed", "can be shown in it"})
        EXPECT_NE(ran.out.find(words), std::string::npos) << words << " is not in:\n" << ran.out;
    EXPECT_EQ(ran.err, "");
}

TEST_F(XrCommand, CheckTellsWhatIsMissing) {
    const Ran none = runMacula({"xr", "--check"}, {kScripted, "MACULA_XR_SCRIPT=no-headset"});
    expectMissing(none, "No headset is connected");
    EXPECT_NE(none.out.find("Scripted runtime"), std::string::npos) << "the software is there";
    expectMissing(runMacula({"xr", "--check"}, {kScripted, "MACULA_XR_SCRIPT=no-vulkan2"}),
                  "XR_KHR_vulkan_enable2");
    expectMissing(runMacula({"xr", "--check"}, {kScripted, "MACULA_XR_SCRIPT=newer-vulkan"}),
                  "another version of Vulkan");
    const std::string broken = write("broken.json", "{ \"file_format_version\": ");
    expectMissing(runMacula({"xr", "--check"}, {"XR_RUNTIME_JSON=" + broken}), "cannot be loaded");
    expectMissing(runMacula({"xr", "--check"}, {"XR_RUNTIME_JSON=" + at("none.json")}), "cannot be loaded");
    const std::string noLibrary = write("no-library.json",
                                        R"({"file_format_version": "1.0.0",
                                            "runtime": {"library_path": "/nonexistent/runtime.so"}})");
    expectMissing(runMacula({"xr", "--check"}, {"XR_RUNTIME_JSON=" + noLibrary}), "cannot be loaded");
}

TEST_F(XrCommand, CheckTellsThatNoRuntimeIsChosen) {
    for (const char* folder : {"/etc/xdg/openxr/1", "/etc/openxr/1", "/usr/local/share/openxr/1",
                               "/usr/share/openxr/1", "/usr/local/etc/openxr/1"})
        if (std::filesystem::exists(folder)) GTEST_SKIP() << "this computer has a runtime of its own";
    expectMissing(runMacula({"xr", "--check"}, {"XR_RUNTIME_JSON=", "HOME=" + at("."),
                                                "XDG_CONFIG_HOME=" + at("."), "XDG_CONFIG_DIRS=" + at(".")}),
                  "No software of a headset");
}

TEST_F(XrCommand, AComputerWithoutTheLoaderIsTold) {
    const Check check = checkHeadset("libmacula-has-no-such-loader.so");
    ASSERT_TRUE(check.missing);
    EXPECT_EQ(check.missing->code, ErrorCode::deviceNotUsable);
    EXPECT_NE(check.missing->message.english().find("loader is not installed"), std::string::npos);
    EXPECT_NE(check.missing->hint.english().find("libopenxr-loader1"), std::string::npos);
}

TEST_F(XrCommand, ShowsAStudyForSoManyFrames) {
    const Ran ran = runMacula({"xr", writeBall(), "--frames", "5"}, {kScripted});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.out.find("Scripted headset: 5 frames"), std::string::npos) << ran.out << ran.err;
}

TEST_F(XrCommand, CheckTellsWhatElseIsOffered) {
    const Ran ran =
        runMacula({"xr", "--check"}, {kScripted, "MACULA_XR_SCRIPT=insets,depth,mask,room,eye=80x72"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    for (const char* words : {"80x72 pixels", "48x48 pixels", "Depths:   taken", "what they hide is told",
                              "Room:     can be seen"})
        EXPECT_NE(ran.out.find(words), std::string::npos) << words << " is not in:\n" << ran.out;
    const Ran few = runMacula({"xr", "--check"}, {kScripted});
    for (const char* words : {"not taken", "is not told", "cannot be seen"})
        EXPECT_NE(few.out.find(words), std::string::npos) << words << " is not in:\n" << few.out;
    EXPECT_EQ(few.out.find("Insets"), std::string::npos);
    const Ran glass = runMacula({"xr", "--check"}, {kScripted, "MACULA_XR_SCRIPT=see-through"});
    EXPECT_NE(glass.out.find("is always seen"), std::string::npos) << glass.out;
}

TEST_F(XrCommand, TheRoomThatCannotBeShownIsTold) {
    const Ran ran = runMacula({"xr", writeBall(), "--frames", "3", "--room"}, {kScripted});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.err.find("cannot show the room"), std::string::npos) << ran.err;
    const Ran shown =
        runMacula({"xr", writeBall(), "--frames", "3", "--room"}, {kScripted, "MACULA_XR_SCRIPT=room"});
    EXPECT_EQ(shown.exitCode, 0) << shown.err;
    EXPECT_EQ(shown.err.find("cannot show the room"), std::string::npos) << shown.err;
}

TEST_F(XrCommand, BenchTellsWhetherFramesAreInTime) {
    const std::string paced = "MACULA_XR_SCRIPT=paced,no-pictures,rate=30";
    const Ran ran =
        runBench({"xr", writeBall(), "--frames", "30", "--warm-up", "10", "--size", "96x64", "--json"},
                 {kScripted, paced});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json["benchmark"], "xr");
    EXPECT_EQ(json["headset"], "Scripted headset");
    EXPECT_EQ(json["eyePx"], (std::vector<int>{96, 64}));
    const auto& results = json["results"];
    EXPECT_EQ(results["frames"], 30);
    EXPECT_EQ(results["framesEmpty"], 0);
    EXPECT_EQ(results["framesUnsubmitted"], 0);
    EXPECT_NEAR(results["periodMs"].get<double>(), 1000.0 / 30.0, 0.01);
    const double inTime = results["inTimePercent"].get<double>();
    const double missed = results["timesMissed"].get<double>();
    EXPECT_NEAR(inTime, 100.0 * 30.0 / (30.0 + missed), 1e-6);
    EXPECT_GT(results["longestMs"].get<double>(), 0.0);
    EXPECT_GE(results["longestMs"].get<double>(), results["meanMs"]["drawn"].get<double>());
    EXPECT_GT(results["meanMs"]["device"].get<double>(), 0.0);
    EXPECT_EQ(results["sessions"], 1);
    EXPECT_LE(results["governor"]["levelAtEnd"].get<int>(), results["governor"]["levelAtMost"].get<int>());

    const Ran lines = runBench({"xr", writeBall(), "--frames", "5", "--warm-up", "0"}, {kScripted});
    EXPECT_EQ(lines.exitCode, 0) << lines.err;
    for (const char* words :
         {"In time:", "of 5 frames", "Governor:", "0 frames were begun and not submitted"})
        EXPECT_NE(lines.out.find(words), std::string::npos) << words << " is not in:\n" << lines.out;
}

TEST_F(XrCommand, BenchRefusesWhatIsNoSizeAndTellsThatThereIsNoHeadset) {
    EXPECT_EQ(runBench({"xr", writeBall(), "--size", "big"}, {kScripted}).exitCode, 2);
    EXPECT_EQ(runBench({"xr", writeBall(), "--frames", "0"}, {kScripted}).exitCode, 2);
    expectMissing(runBench({"xr", writeBall()}, {kScripted, "MACULA_XR_SCRIPT=no-headset"}),
                  "No headset is connected");
}

// By the layer of Debian that checks what is called: openxr-layer-corevalidation.
TEST_F(XrCommand, TheValidationLayerOfOpenXrFindsNothing) {
    if (!std::filesystem::exists(
            "/usr/share/openxr/1/api_layers/explicit.d/XrApiLayer_core_validation.x86_64-linux-gnu.json"))
        GTEST_SKIP() << "openxr-layer-corevalidation is not installed";
    const std::vector<std::string> checked{
        kScripted, "XR_ENABLE_API_LAYERS=XR_APILAYER_LUNARG_core_validation",
        "XR_CORE_VALIDATION_EXPORT_TYPE=text", "XR_CORE_VALIDATION_FILE_NAME=" + at("log.txt")};
    const Ran ran = runMacula({"xr", writeBall(), "--frames", "5"}, checked);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE((ran.out + ran.err).find("Core Validation"), std::string::npos) << "it was not there";
    if (std::filesystem::exists(at("log.txt"))) {
        EXPECT_EQ(cli::readAll(at("log.txt")), "");
    }
}

TEST_F(XrCommand, AStudyIsNotReadWhereThereIsNoHeadset) {
    const Ran ran = runMacula({"xr", at("no such study")}, {kScripted, "MACULA_XR_SCRIPT=no-headset"});
    expectMissing(ran, "No headset is connected");
    EXPECT_EQ(runMacula({"xr", at("no such study")}, {kScripted}).exitCode, 3);
    EXPECT_EQ(runMacula({"xr", "--check", "--frames", "5"}, {kScripted}).exitCode, 2) << "without effect";
}

}  // namespace
}  // namespace macula::xr
