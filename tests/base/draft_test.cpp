// What is being written, and what a killed program left of it.
#include "base/draft.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "base/atomic_file.h"

namespace macula {
namespace {

namespace fs = std::filesystem;

class DraftTest : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / fmt::format("macula-draft-{}-{}", getpid(), test->name());
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    std::ptrdiff_t fileCount() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }
    fs::path folder_;
};

TEST_F(DraftTest, GoesUnlessItIsMovedAndHasTheExtension) {
    {
        const auto file = Draft::beside(folder_ / "a.png", Draft::Kind::file);
        const auto folder = Draft::beside(folder_ / "a.mhd", Draft::Kind::folder);
        ASSERT_TRUE(file.ok() && folder.ok());
        EXPECT_EQ(file->path().extension(), ".png");
        EXPECT_EQ(file->path().parent_path(), folder_);
        std::ofstream(folder->path() / "a.raw") << "values";
        EXPECT_EQ(fileCount(), 2);
        std::ofstream(file->path()) << "whole";
        ASSERT_TRUE(putInPlace(file->path(), folder_ / "a.png").ok());
    }
    EXPECT_EQ(fileCount(), 1);
    EXPECT_EQ(*readText(folder_ / "a.png"), "whole");
}

TEST_F(DraftTest, MadeOfAFolderItIsGoneAtOnceAndAllOfItLater) {
    fs::create_directories(folder_ / "study");
    std::ofstream(folder_ / "study" / "a.dcm") << "whole";
    {
        const auto draft = Draft::of(folder_ / "study");
        ASSERT_TRUE(draft.ok());
        EXPECT_FALSE(fs::exists(folder_ / "study"));
        EXPECT_TRUE(fs::exists(draft->path() / "a.dcm"));
        removeAbandonedDrafts(folder_);
        EXPECT_TRUE(fs::exists(draft->path())) << "its maker lives";
    }
    EXPECT_EQ(fileCount(), 0);
    EXPECT_FALSE(Draft::of(folder_ / "study").ok());
}

TEST_F(DraftTest, OfAKilledProgramIsRemovedAndOfALivingOneNot) {
    const pid_t child = fork();
    if (child == 0) {
        const auto file = Draft::beside(folder_ / "a.png", Draft::Kind::file);
        const auto folder = Draft::beside(folder_ / "a.mhd", Draft::Kind::folder);
        if (folder.ok()) std::ofstream(folder->path() / "a.raw") << "values";
        _exit(file.ok() && folder.ok() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_EQ(status, 0);
    const auto mine = Draft::beside(folder_ / "b.png", Draft::Kind::file);
    ASSERT_TRUE(mine.ok());
    std::ofstream(folder_ / ".c.part.png") << "somebody's own";
    EXPECT_EQ(fileCount(), 4);
    removeAbandonedDrafts(folder_);
    EXPECT_EQ(fileCount(), 2);
    EXPECT_TRUE(fs::exists(mine->path()));
}

TEST_F(DraftTest, LongNamesAreCutBetweenCharacters) {
    std::string name;
    while (name.size() < 248) name += "ä";
    const auto draft = Draft::beside(folder_ / (name + ".png"), Draft::Kind::file);
    ASSERT_TRUE(draft.ok()) << draft.error().message;
    const std::string stem = draft->path().filename().string();
    EXPECT_TRUE(stem.starts_with(".ä"));
    EXPECT_EQ(stem.find('.', 1) % 2, 1u) << "half a character";
}

TEST_F(DraftTest, KeepsThePermissionsOfWhatItReplaces) {
    std::ofstream(folder_ / "a.txt") << "for nobody else";
    fs::permissions(folder_ / "a.txt", fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_TRUE(writeTextAtomically(folder_ / "a.txt", "new").ok());
    EXPECT_EQ(fs::status(folder_ / "a.txt").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(DraftTest, ReplacesNothingButFiles) {
    ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    const auto written = writeTextAtomically(folder_ / "pipe", "text");
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().code, ErrorCode::outputNotWritable);
    EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
    EXPECT_EQ(fileCount(), 1);
}

}  // namespace
}  // namespace macula
