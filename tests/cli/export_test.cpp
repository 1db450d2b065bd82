// `macula export`, and files of other formats where a folder with DICOM may be given.
#include <nlohmann/json.hpp>

#include "base/paths.h"
#include "base/phantom.h"
#include "cli/run_command.h"

namespace macula::cli {
namespace {

using Json = nlohmann::json;
using Export = CommandTest;

const char* const kEndings[] = {".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd"};

TEST_F(Export, PhantomInEveryFormat) {
    ASSERT_EQ(runMacula({"phantom", at("PHANTOM")}).exitCode, 0);
    const auto expected = phantom::worldFromVoxel();
    for (const std::string ending : kEndings) {
        const std::string name = ending.substr(1, 3) + ending;  // .nhdr and .mhd both leave a .raw
        const Ran ran = runMacula({"export", at("PHANTOM"), "-o", at(name), "--json"});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        const Json json = Json::parse(ran.out);
        EXPECT_EQ(json["values"], "int16");
        EXPECT_EQ(json["unit"], "HU");
        EXPECT_EQ(json["sheared"], false);
        EXPECT_EQ(json["size"], Json({256, 224, 160}));
        EXPECT_EQ(json["valueRange"][0], -1000.0);

        // Read back as a person would look at it.
        const Ran info = runMacula({"info", at(name), "--json"});
        ASSERT_EQ(info.exitCode, 0) << info.err;
        const Json file = Json::parse(info.out)["volumeFile"];
        EXPECT_EQ(file["format"], json["format"]);
        EXPECT_EQ(file["size"], json["size"]);
        ASSERT_EQ(file["assumptions"].size(), 1u);
        EXPECT_NE(file["assumptions"][0].get<std::string>().find("with values in HU"), std::string::npos);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column)
                EXPECT_NEAR(file["worldFromVoxel"][row][column].get<double>(), expected[column][row], 1e-4);
        }
        const Ran text = runMacula({"info", at(name)});
        EXPECT_NE(text.out.find("256 x 224 x 160"), std::string::npos) << text.out;

        // The series has the name PHANTOM in its patient, its folder and its UIDs; the file has it nowhere.
        for (const std::string word : {"PHANTOM", "Phantom", "1.2.826", "2.25."})
            EXPECT_EQ(readAll(at(name)).find(word), std::string::npos) << ending << " " << word;
        EXPECT_EQ(ran.out.find("PHANTOM"), std::string::npos);
    }
    EXPECT_EQ(fileCount("."), fileCount("PHANTOM") + 1 + 8) << "six files, and the values of two";
}

TEST_F(Export, ConvertsFiles) {
    ASSERT_EQ(runMacula({"export", "phantom:", "-o", at("a.nii.gz")}).exitCode, 0);
    ASSERT_EQ(runMacula({"export", at("a.nii.gz"), "-o", at("b.mha")}).exitCode, 0);
    ASSERT_EQ(runMacula({"export", "phantom:", "-o", at("c.mha")}).exitCode, 0);
    const std::string converted = readAll(at("b.mha"));
    const std::string direct = readAll(at("c.mha"));
    constexpr std::size_t kVoxels = std::size_t{2} * 256 * 224 * 160;
    ASSERT_GT(converted.size(), kVoxels);
    EXPECT_TRUE(converted.substr(converted.size() - kVoxels) == direct.substr(direct.size() - kVoxels));
}

TEST_F(Export, RendersFiles) {
    ASSERT_EQ(runMacula({"export", "phantom:", "-o", at("a.nrrd")}).exitCode, 0);
    const Ran ran = runMacula(
        {"render", at("a.nrrd"), "-o", at("a.png"), "--size", "16x16", "--spp", "1", "--json", "-"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.err.find("with values in HU"), std::string::npos) << ran.err;
    const std::string preset = Json::parse(ran.out)["preset"];
    EXPECT_TRUE(preset == "cinematic-chest" || preset == "cinematic-bone") << preset;
    const Ran series = runMacula({"render", at("a.nrrd"), "-o", at("b.png"), "--series", "1"});
    EXPECT_EQ(series.exitCode, 2);
    EXPECT_NE(series.err.find("one volume"), std::string::npos);
}

TEST_F(Export, ReplacesOnlyWhenTold) {
    for (const std::string name : {"a.nii", "a.mhd"}) {
        const std::string other = name == "a.mhd" ? "a.raw" : "a.nii";
        write(other, "important");
        const Ran refused = runMacula({"export", "phantom:", "-o", at(name)});
        EXPECT_EQ(refused.exitCode, 2);
        EXPECT_EQ(refused.errorLines(), 1u) << refused.err;
        EXPECT_NE(refused.err.find("--overwrite"), std::string::npos) << refused.err;
        EXPECT_EQ(readAll(at(other)), "important");
        EXPECT_EQ(runMacula({"export", "phantom:", "-o", at(name), "--overwrite"}).exitCode, 0);
        EXPECT_EQ(runMacula({"export", "phantom:", "-o", at(name), "--force"}).exitCode, 0) << "the old word";
        EXPECT_GT(readAll(at(other)).size(), 1000000u);
    }
}

TEST_F(Export, RefusesWhatCannotBe) {
    const auto refused = [&](int code, const std::string& words, std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "export");
        const std::size_t before = fileCount();
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, code) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_EQ(fileCount(), before);
    };
    refused(2, ".nrrd", {"phantom:", "-o", at("a.png")});
    refused(2, "-o", {"phantom:"});
    refused(2, "does not exist", {"phantom:", "-o", at("no/such/a.nii")});
    refused(2, "--volume", {"phantom:", "-o", at("a.nii"), "--volume", "0"});
    refused(2, "no series", {"phantom:", "-o", at("a.nii"), "--series", "1"});
    refused(3, "macula: ", {at("missing"), "-o", at("a.nii")});
    refused(3, "does not exist", {at("missing.nii"), "-o", at("a.nii")});
    write("broken.nrrd", "NRRD0004\nand then nonsense");
    refused(3, "damaged", {at("broken.nrrd"), "-o", at("a.nii")});
    std::filesystem::create_directory(at("taken.nii"));
    refused(2, "folder of that name", {"phantom:", "-o", at("taken.nii"), "--force"});
    const Ran info = runMacula({"info", at("broken.nrrd")});
    EXPECT_EQ(info.exitCode, 3);
    EXPECT_EQ(info.errorLines(), 1u) << info.err;
}

TEST_F(Export, ChoosesSeriesAndVolume) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    EXPECT_EQ(
        runMacula({"export", at("study"), "-o", at("a.mha"), "--series", "1", "--volume", "1"}).exitCode, 0);
    EXPECT_EQ(runMacula({"export", at("study"), "-o", at("b.mha"), "--series", "1.1"}).exitCode, 0);
    EXPECT_EQ(runMacula({"export", at("study"), "-o", at("c.mha"), "--volume", "1"}).exitCode, 0);
    EXPECT_EQ(readAll(at("a.mha")), readAll(at("b.mha")));
    EXPECT_EQ(readAll(at("a.mha")), readAll(at("c.mha")));
    for (const std::vector<std::string>& choice :
         {std::vector<std::string>{"--volume", "2"}, {"--series", "2"}, {"--series", "1", "--volume", "7"}}) {
        std::vector<std::string> arguments{"export", at("study"), "-o", at("d.mha")};
        arguments.insert(arguments.end(), choice.begin(), choice.end());
        EXPECT_EQ(runMacula(arguments).exitCode, 2);
    }
}

// A segmentation without the images it was drawn on, one of a single slice too.
TEST_F(Export, Segmentation) {
    const auto seg = macula::test::sharedFolder() / "data/odd/seg_1frame.dcm";
    if (!std::filesystem::exists(seg)) GTEST_SKIP() << "the real test data are not on this machine";
    std::filesystem::create_directory(at("study"));
    std::filesystem::copy(seg, at("study/seg.dcm"));
    const Ran ran = runMacula({"export", at("study"), "-o", at("seg.nii.gz"), "--series", "1", "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.err.find("grid of its own"), std::string::npos) << ran.err;
    const Json json = Json::parse(ran.out);
    EXPECT_EQ(json["size"], Json({512, 512, 1}));
    ASSERT_EQ(json["segments"].size(), 1u);
    EXPECT_GT(json["segments"][0]["voxels"], 0);
    EXPECT_GT(std::filesystem::file_size(at("seg.nii.gz")), 352u);
    EXPECT_EQ(
        runMacula({"export", at("study"), "-o", at("b.nii"), "--series", "1", "--volume", "2"}).exitCode, 2);
    EXPECT_EQ(runMacula({"export", at("study"), "-o", at("b.nii")}).exitCode, 3);  // no images
}

}  // namespace
}  // namespace macula::cli
