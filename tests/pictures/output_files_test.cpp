// The one rule about what may be written.
#include "pictures/output_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support.h"

namespace macula::pictures {
namespace {

namespace fs = std::filesystem;
using dicom::test::TemporaryFolder;

class OutputFilesTest : public testing::Test {
  protected:
    fs::path made(const std::string& name) const {
        std::ofstream(folder_ / name) << "text";
        return folder_ / name;
    }
    static void expectRefused(const Result<void>& refused, ErrorCode code, const std::string& hint) {
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, code);
        EXPECT_NE(refused.error().hint.english().find(hint), std::string::npos) << refused.error().hint;
    }

    TemporaryFolder folder_;
};

TEST_F(OutputFilesTest, ReplaceOnlyWhenTold) {
    const fs::path there = made("there.png");
    expectRefused(OutputFiles(false).write(there), ErrorCode::outputNotWritable, "--overwrite");
    EXPECT_TRUE(OutputFiles(true).write(there));
    EXPECT_TRUE(OutputFiles(false).write(folder_ / "new.png"));
    EXPECT_TRUE(OutputFiles(false).write("-"));
    EXPECT_TRUE(OutputFiles(false).write({}));
}

TEST_F(OutputFilesTest, NeverReplaceWhatIsRead) {
    const fs::path read = made("read.json");
    fs::create_hard_link(read, folder_ / "same.json");
    fs::create_directory(folder_ / "study");
    std::ofstream(folder_ / "study/slice") << "text";
    OutputFiles files(true);
    files.read(read.string() + "#NAME");
    files.read(folder_ / "study");
    files.read("phantom:");
    expectRefused(files.write(read), ErrorCode::outputNotWritable, "never replaced");
    expectRefused(files.write(folder_ / "same.json"), ErrorCode::outputNotWritable, "never replaced");
    expectRefused(files.write(folder_ / "study/../study/slice"), ErrorCode::outputNotWritable,
                  "never replaced");
    EXPECT_TRUE(files.write(folder_ / "study/new.png"));
    EXPECT_TRUE(files.writeOn(made("training.macula")));
}

TEST_F(OutputFilesTest, AreDifferentFilesInFoldersThatExist) {
    OutputFiles files(true);
    EXPECT_TRUE(files.write(folder_ / "a.png"));
    expectRefused(files.write(folder_ / "./a.png"), ErrorCode::usage, "a name of its own");
    expectRefused(files.write(folder_ / "no/a.png"), ErrorCode::outputNotWritable, "Create it");
    fs::create_directory(folder_ / "b.png");
    expectRefused(files.write(folder_ / "b.png"), ErrorCode::outputNotWritable, "another name");
}

TEST_F(OutputFilesTest, UnfinishedResultsReplaceNoFinishedOnes) {
    EXPECT_EQ(placeOfUnfinished(folder_ / "model.ply"), folder_ / "model.ply");
    EXPECT_EQ(placeOfUnfinished(made("model.ply")), folder_ / "model-unfinished.ply");
}

TEST_F(OutputFilesTest, AreTheSameByWhateverName) {
    const fs::path file = made("file");
    fs::create_symlink(file, folder_ / "link");
    EXPECT_TRUE(isSameFile(file, folder_ / "link"));
    EXPECT_TRUE(isSameFile(folder_ / "not-there", folder_ / "./not-there"));
    EXPECT_FALSE(isSameFile(file, folder_ / "not-there"));
    EXPECT_FALSE(isSameFile({}, {}));
}

}  // namespace
}  // namespace macula::pictures
