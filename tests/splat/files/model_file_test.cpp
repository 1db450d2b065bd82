#include "pipeline/splat/files/model_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "splat/model_support.h"

namespace macula::splat {
namespace {

namespace fs = std::filesystem;

class ModelFileTest : public ::testing::Test {
  protected:
    ModelFileTest() {
        std::string name = (fs::temp_directory_path() / "macula-model-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~ModelFileTest() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    // Of those that writeModel writes.
    std::vector<fs::path> ofEachFormat() const {
        std::vector<fs::path> paths;
        for (const ModelFormat& format : kModelFormats)
            if (!format.keepsTraining()) paths.push_back(folder_ / ("a" + std::string(format.extension)));
        return paths;
    }
    fs::path folder_;
};

TEST_F(ModelFileTest, EveryFormatIsKnownByContent) {
    const Splats splats = testing::randomModel(100, 1, 3);
    for (const fs::path& path : ofEachFormat()) {
        const auto written = writeModel(path, splats);
        ASSERT_TRUE(written.ok()) << written.error().message;
        EXPECT_EQ(*written, 0u);
        fs::rename(path, folder_ / "a.other");
        const auto read = readModel(folder_ / "a.other");
        ASSERT_TRUE(read.ok()) << read.error().message;
        EXPECT_EQ(read->splats.size(), 100u);
        EXPECT_EQ(read->splats.originMm, splats.originMm);
        EXPECT_EQ(read->splats.axes, Axes::patientLps);
        if (path.extension() == ".ply") {
            EXPECT_TRUE(testing::sameBits(read->splats, splats));
        }
    }
}

// From PLY to SPZ and on to PLY, a model stays where it is.
TEST_F(ModelFileTest, FormatsAgree) {
    const Splats splats = testing::randomModel(100, 1, 5);
    ASSERT_TRUE(writeModel(folder_ / "a.ply", splats).ok());
    ASSERT_TRUE(writeModel(folder_ / "b.spz", readModel(folder_ / "a.ply")->splats).ok());
    const auto packed = readModel(folder_ / "b.spz");
    ASSERT_TRUE(packed.ok());
    ASSERT_TRUE(writeModel(folder_ / "c.ply", packed->splats).ok());
    const auto last = readModel(folder_ / "c.ply");
    ASSERT_TRUE(last.ok());
    EXPECT_TRUE(testing::sameBits(last->splats, packed->splats));
    for (std::size_t i = 0; i < 100; ++i)
        EXPECT_LT(glm::length(last->splats.position[i] - splats.position[i]), 1e-3f);
}

TEST_F(ModelFileTest, BadFilesSayWhich) {
    const auto refused = [&](const fs::path& path, ErrorCode code) {
        const auto read = readModel(path);
        ASSERT_FALSE(read.ok());
        EXPECT_EQ(read.error().code, code);
        EXPECT_EQ(read.error().where, path.string());
        EXPECT_EQ(read.error().message.english().find(folder_.string()), std::string::npos);
    };
    refused(folder_ / "absent.ply", ErrorCode::inputNotUsable);
    refused(folder_, ErrorCode::inputNotUsable);
    for (const char* text : {"", "x", "plx", "ply", "NGSP", "\x1f\x8b", "a letter"}) {
        std::ofstream(folder_ / "bad") << text;
        refused(folder_ / "bad", ErrorCode::inputNotUsable);
    }
}

TEST_F(ModelFileTest, AnEmptyModelIsReadOnlyWhereItIsAskedFor) {
    // One splat, at a place that is no number; none at all.
    Splats splats = testing::randomModel(1, 0, 7);
    ASSERT_TRUE(writeModel(folder_ / "one.ply", splats).ok());
    std::string bytes;
    {
        std::ifstream file(folder_ / "one.ply", std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
    }
    const std::size_t header = bytes.find("end_header\n") + 11;
    const float nan = std::nanf("");
    std::string bad = bytes;
    std::memcpy(&bad[header], &nan, sizeof(nan));
    std::string none = bytes.substr(0, header);
    none.replace(none.find("vertex 1"), 8, "vertex 0");
    for (const std::string& content : {bad, none}) {
        std::ofstream(folder_ / "a.ply", std::ios::binary) << content;
        EXPECT_FALSE(readModel(folder_ / "a.ply").ok());
        EXPECT_FALSE(readModel(folder_ / "a.ply", BadSplats::repair).ok());
        const auto read = readModel(folder_ / "a.ply", BadSplats::repairOrNone);
        ASSERT_TRUE(read.ok());
        EXPECT_EQ(read->splats.size(), 0u);
    }
}

TEST_F(ModelFileTest, NothingIsLeftOfAFailedWrite) {
    const Splats splats = testing::randomModel(3, 0, 7);
    EXPECT_EQ(writeModel(folder_ / "a.obj", splats).error().code, ErrorCode::usage);
    EXPECT_EQ(writeModel(folder_ / "none" / "a.ply", splats).error().code, ErrorCode::outputNotWritable);
    for (const fs::path& path : ofEachFormat()) {
        EXPECT_EQ(writeModel(path, Splats{}).error().code, ErrorCode::inputNotUsable);
        ASSERT_TRUE(writeModel(path, splats).ok());
        Splats bad = splats;
        bad.position[1].x = std::nanf("");
        EXPECT_FALSE(writeModel(path, bad).ok());
        EXPECT_EQ(readModel(path)->splats.size(), 3u);  // the one before
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}),
              std::ssize(ofEachFormat()));
}

}  // namespace
}  // namespace macula::splat
