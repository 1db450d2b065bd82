// What `macula info`, `presets`, `devices` and `phantom` print.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/paths.h"
#include "base/phantom.h"
#include "cli/run_command.h"

namespace macula::cli {
namespace {

using Info = CommandTest;

TEST_F(Info, PhantomIsOneSeriesThatCanBeShown) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    const std::size_t slices = fileCount("study");
    EXPECT_GT(slices, 50u);

    const Ran ran = runMacula({"info", at("study"), "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    ASSERT_EQ(json["studies"].size(), 1u);
    ASSERT_EQ(json["studies"][0]["series"].size(), 1u);
    const auto& series = json["studies"][0]["series"][0];
    EXPECT_EQ(series["modality"], "CT");
    EXPECT_EQ(series["canBeVolume"], true);
    EXPECT_EQ(series["instances"], slices);
    ASSERT_EQ(series["stacks"].size(), 1u);
    const auto& stack = series["stacks"][0];
    EXPECT_EQ(stack["size"][2], slices);
    EXPECT_EQ(stack["best"], true);
    const glm::dvec3 spacing = phantom::Options{}.spacingMm;
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(stack["spacingMm"][axis].get<double>(), spacing[axis], 1e-6);
    EXPECT_EQ(stack["worldFromVoxel"][3], (std::vector<double>{0, 0, 0, 1}));
}

TEST_F(Info, JsonIsPrintedAlsoWhereNothingCanBeRead) {
    write("study/broken.dcm", std::string(128, '\0') + "DICM and then nonsense");
    for (const std::string& path : {at("study"), at("nothing.nii")}) {
        const Ran ran = runMacula({"info", path, "--json"});
        EXPECT_EQ(ran.exitCode, 3);
        const auto json = nlohmann::json::parse(ran.out);
        EXPECT_FALSE(json["error"]["sentence"].get<std::string>().empty());
        EXPECT_FALSE(json["error"]["action"].get<std::string>().empty());
        EXPECT_TRUE(json["studies"].empty());
        EXPECT_FALSE(json["error"].contains("where"));
    }
}

TEST_F(Info, SegmentsAreListedByNumberAndLabel) {
    const auto pair = macula::test::sharedFolder() / "data/odd/legacy_enhanced_pair";
    if (!std::filesystem::exists(pair)) GTEST_SKIP() << "the real test data are not on this machine";
    const Ran text = runMacula({"info", pair.string()});
    ASSERT_EQ(text.exitCode, 0) << text.err;
    EXPECT_NE(text.out.find("    1  Liver\n"), std::string::npos) << text.out;
    const Ran ran = runMacula({"info", pair.string(), "--json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    bool isListed = false;
    const auto json = nlohmann::json::parse(ran.out);
    for (const auto& study : json["studies"])
        for (const auto& series : study["series"])
            for (const auto& object : series["objects"])
                isListed = isListed || object.value("segments", nlohmann::json::array()) ==
                                           nlohmann::json::parse(R"([{"number": 1, "label": "Liver"}])");
    EXPECT_TRUE(isListed) << ran.out;
}

// Each image of a class of its own is a stack of its own; one line stands for most of them.
TEST_F(Info, ASeriesInHundredsOfStacksIsSummarised) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(at("study"))) files.push_back(entry.path());
    ASSERT_GT(files.size(), 60u);
    const std::string ctImage("1.2.840.10008.5.1.4.1.1.2\0", 26);
    for (std::size_t i = 0; i < files.size(); ++i) {
        std::string bytes = readAll(files[i]);
        const std::string other = fmt::format("1.2.3.4.5.6.7.8.9.10.1.{}", 100 + i);
        ASSERT_EQ(other.size(), ctImage.size());
        for (std::size_t at = bytes.find(ctImage); at != std::string::npos; at = bytes.find(ctImage))
            bytes.replace(at, other.size(), other);
        write("study/" + files[i].filename().string(), bytes);
    }
    const Ran ran = runMacula({"info", at("study")});
    EXPECT_NE(ran.out.find("more stacks with"), std::string::npos) << ran.out.substr(0, 2000);
    EXPECT_LT(std::ranges::count(ran.out, '\n'), 60);
    const Ran json = runMacula({"info", at("study"), "--json"});
    EXPECT_EQ(nlohmann::json::parse(json.out)["studies"][0]["series"][0]["stacks"].size(), files.size());
}

TEST_F(Info, OneIsNotToldAsSeveral) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(at("study"))) files.push_back(entry.path());
    ASSERT_GT(files.size(), 1u);
    for (std::size_t i = 1; i < files.size(); ++i) std::filesystem::remove(files[i]);
    const Ran ran = runMacula({"info", at("study")});
    EXPECT_NE(ran.out.find("1 file: 1 image, 0 other DICOM objects, 0 left out"), std::string::npos)
        << ran.out;
    EXPECT_NE(ran.out.find("The only stack of images: "), std::string::npos) << ran.out;
}

TEST_F(Info, PatientIsNamedOnlyWhenAskedFor) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    for (const std::vector<std::string>& format : {std::vector<std::string>{}, {"--json"}}) {
        std::vector<std::string> arguments{"info", at("study")};
        arguments.insert(arguments.end(), format.begin(), format.end());
        const Ran quiet = runMacula(arguments);
        ASSERT_EQ(quiet.exitCode, 0);
        EXPECT_EQ((quiet.out + quiet.err).find("PHANTOM"), std::string::npos) << quiet.out;
        arguments.emplace_back("--patient");
        const Ran asked = runMacula(arguments);
        EXPECT_NE(asked.out.find("PHANTOM"), std::string::npos) << asked.out;
    }
}

// Gives a file, which is in Explicit VR Little Endian, a SeriesInstanceUID of its own.
void renameSeries(const std::filesystem::path& file, std::size_t number) {
    std::stringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    std::string bytes = text.str();
    const std::size_t at = bytes.find(std::string("\x20\x00\x0E\x00UI", 6));
    ASSERT_NE(at, std::string::npos);
    const auto length = static_cast<unsigned char>(bytes[at + 6]);
    std::string uid = fmt::format("2.25.9{:04}", number);
    uid.resize(length, '\0');
    bytes.replace(at + 8, length, uid);
    std::ofstream(file, std::ios::binary) << bytes;
}

TEST_F(Info, ASeriesUidForEachSliceIsOneQuestionThatJoinAnswers) {
    ASSERT_EQ(runMacula({"phantom", at("study")}).exitCode, 0);
    std::size_t number = 0;
    for (const auto& entry : std::filesystem::directory_iterator(at("study")))
        renameSeries(entry.path(), ++number);
    const Ran asked = runMacula({"info", at("study")});
    EXPECT_EQ(asked.exitCode, 0) << asked.err;
    EXPECT_NE(asked.out.find("--join"), std::string::npos) << asked.out;
    EXPECT_EQ(asked.out.find("only one slice"), std::string::npos) << asked.out;
    const Ran refused = runMacula({"export", at("study"), "-o", at("volume.nrrd")});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_NE(refused.err.find("--join"), std::string::npos) << refused.err;
    const Ran joined = runMacula({"export", at("study"), "--join", "-o", at("volume.nrrd")});
    EXPECT_EQ(joined.exitCode, 0) << joined.err;
    EXPECT_NE(joined.err.find("joined"), std::string::npos) << joined.err;
}

TEST_F(Info, PathsOfFilesLeftOutAreShownOnlyWhenAskedFor) {
    ASSERT_EQ(runMacula({"phantom", at("DOE_JANE")}).exitCode, 0);
    write("DOE_JANE/broken.dcm", std::string(128, '\0') + "DICM and then nonsense");
    for (const std::vector<std::string>& format : {std::vector<std::string>{}, {"--json"}}) {
        std::vector<std::string> arguments{"info", at("DOE_JANE")};
        arguments.insert(arguments.end(), format.begin(), format.end());
        EXPECT_EQ(runMacula(arguments).out.find("DOE_JANE"), std::string::npos);
        arguments.emplace_back("--patient");
        EXPECT_NE(runMacula(arguments).out.find("DOE_JANE"), std::string::npos);
    }
}

TEST_F(Info, PhantomRefusesAFolderInUse) {
    write("mine.txt", "important");
    const Ran ran = runMacula({"phantom", folder_.string()});
    EXPECT_EQ(ran.exitCode, 2) << ran.err;
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(Info, ListsPresetsAndDevices) {
    const auto presets = nlohmann::json::parse(runMacula({"presets", "--json"}).out);
    EXPECT_GE(presets["presets"].size(), 5u);
    EXPECT_GE(presets["lights"].size(), 4u);
    EXPECT_NE(runMacula({"presets"}).out.find("ct-bone"), std::string::npos);

    const Ran devices = runMacula({"devices", "--json"});
    ASSERT_EQ(devices.exitCode, 0) << devices.err;
    EXPECT_GE(nlohmann::json::parse(devices.out).size(), 1u);
}

}  // namespace
}  // namespace macula::cli
