// What only its owner may read, and locks between programs.
#include "base/private_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "base/file_lock.h"
#include "base/utc_time.h"

namespace macula {
namespace {

namespace fs = std::filesystem;

constexpr fs::perms kOwnFile = fs::perms::owner_read | fs::perms::owner_write;

class PrivateFileTest : public ::testing::Test {
  protected:
    PrivateFileTest() : folder_(fs::temp_directory_path() / fmt::format("macula-private-{}", getpid())) {
        fs::remove_all(folder_);
    }
    ~PrivateFileTest() override { fs::remove_all(folder_); }
    fs::path folder_;
};

TEST_F(PrivateFileTest, IsPrivateWhateverTheUmask) {
    const mode_t before = umask(0);
    ASSERT_TRUE(makePrivateFolder(folder_ / "a" / "b"));
    ASSERT_TRUE(writeTextPrivately(folder_ / "a" / "b" / "text", "first"));
    ASSERT_TRUE(writeTextPrivately(folder_ / "a" / "b" / "text", "second"));
    umask(before);
    EXPECT_EQ(fs::status(folder_ / "a" / "b").permissions(), fs::perms::owner_all);
    EXPECT_EQ(fs::status(folder_ / "a" / "b" / "text").permissions(), kOwnFile);
    EXPECT_EQ(*readText(folder_ / "a" / "b" / "text"), "second");
    fs::permissions(folder_ / "a" / "b", fs::perms::all);
    ASSERT_TRUE(makePrivateFolder(folder_ / "a" / "b"));
    EXPECT_EQ(fs::status(folder_ / "a" / "b").permissions(), fs::perms::owner_all);
}

TEST_F(PrivateFileTest, WhereNoFolderCanBeItIsSaid) {
    fs::create_directories(folder_);
    ASSERT_TRUE(writeTextPrivately(folder_ / "file", "text"));
    const auto made = makePrivateFolder(folder_ / "file" / "below");
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::outputNotWritable);
    EXPECT_FALSE(writeTextPrivately(folder_ / "nowhere" / "file", "text"));
}

TEST_F(PrivateFileTest, ALockKeepsOthersOutUntilItsProgramEnds) {
    fs::create_directories(folder_);
    const fs::path file = folder_ / "lock";
    int told[2];
    ASSERT_EQ(pipe(told), 0);
    const pid_t child = fork();
    if (child == 0) {
        const FileLock lock(file);
        const char isOurs = lock.isOurs() ? 'y' : 'n';
        if (write(told[1], &isOurs, 1) != 1) _exit(1);
        for (;;) pause();
    }
    char isTheirs = 'n';
    ASSERT_EQ(read(told[0], &isTheirs, 1), 1);
    EXPECT_EQ(isTheirs, 'y');
    const FileLock lock(file);
    EXPECT_FALSE(lock.isFree());
    EXPECT_FALSE(lock.isOurs());
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    EXPECT_TRUE(lock.isFree());
    EXPECT_TRUE(lock.isOurs());
    EXPECT_FALSE(FileLock(file).isOurs()) << "another object of the same program";
    EXPECT_EQ(fs::status(file).permissions(), kOwnFile);
}

TEST(UtcTime, IsByIso8601) {
    const std::string now = nowInUtc();
    ASSERT_EQ(now.size(), 20u);
    EXPECT_TRUE(now.starts_with("20")) << now;
    EXPECT_EQ(now[10], 'T');
    EXPECT_EQ(now.back(), 'Z');
    const std::string before = nowInUtcMs();
    ASSERT_EQ(before.size(), 24u);
    EXPECT_EQ(before[19], '.');
    EXPECT_LE(before, nowInUtcMs());
}

}  // namespace
}  // namespace macula
