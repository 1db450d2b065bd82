// When the disk is no friend: each trouble is told as what it is, and changes nothing.
#include "session/trouble.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>
#include <set>

#include "session/support.h"

namespace macula::session {
namespace {

namespace fs = std::filesystem;
using test::isOk;
using test::keyOf;
using test::troubleIn;
using test::valueOf;

class Troubles : public test::StoreTest {
  protected:
    fs::path database() const { return folder_ / "sessions.db"; }
    void fill() {
        Store store = open();
        ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
        ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), test::blobOf(1, 1000))));
    }
    std::vector<std::string> allBytes() const {
        std::vector<std::string> bytes;
        for (const fs::path& file : test::filesBelow(folder_))
            bytes.push_back(file.string() + "\n" + test::textOf(folder_ / file));
        return bytes;
    }
    void execute(const char* sql) const {
        SQLite::Database(database().string(), SQLite::OPEN_READWRITE).exec(sql);
    }
};

TEST(TroubleSentences, AreTheirOwnAndNameNoPath) {
    std::set<std::string> sentences;
    for (int i = 0; i < kTroubles; ++i) {
        const Error error = errorOf(static_cast<Trouble>(i), "/home/anna");
        EXPECT_TRUE(sentences.insert(error.message.english()).second) << error.message;
        EXPECT_EQ(troubleOf(error), static_cast<Trouble>(i));
        EXPECT_EQ(error.where, "/home/anna");
        EXPECT_FALSE(error.hint.empty());
        EXPECT_EQ((error.message.english() + error.hint.english()).find("anna"), std::string::npos);
    }
    EXPECT_EQ(troubleOf(Error{ErrorCode::usage, Text("Something else."), {}, {}}), std::nullopt);
}

TEST_F(Troubles, OfAReadOnlyFolder) {
    fill();
    fs::permissions(folder_.parent_path(),
                    fs::perms::owner_all | fs::perms::others_exec | fs::perms::others_read);
    fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
    ASSERT_EQ(geteuid() == 0 ? chown(folder_.c_str(), test::kNobody, test::kNobody) : 0, 0);
    const auto before = allBytes();
    EXPECT_EQ(
        test::inChildOfNobody([&] { return troubleIn(Store::open(options())) == Trouble::readOnly ? 0 : 1; }),
        0);
    StoreOptions below = options();
    below.folder = folder_ / "new" / "store";
    EXPECT_EQ(
        test::inChildOfNobody([&] { return troubleIn(Store::open(below)) == Trouble::readOnly ? 0 : 1; }), 0);
    EXPECT_EQ(allBytes(), before);
    fs::permissions(folder_, fs::perms::owner_all);
}

TEST_F(Troubles, OfAReadOnlyDatabase) {
    fill();
    fs::permissions(folder_.parent_path(),
                    fs::perms::owner_all | fs::perms::others_exec | fs::perms::others_read);
    fs::permissions(database(), fs::perms::owner_read);
    if (geteuid() == 0) {
        for (const auto& path : {folder_, folder_ / "sessions.lock", folder_ / "models", database()})
            ASSERT_EQ(chown(path.c_str(), test::kNobody, test::kNobody), 0);
    }
    const auto before = allBytes();
    EXPECT_EQ(
        test::inChildOfNobody([&] { return troubleIn(Store::open(options())) == Trouble::readOnly ? 0 : 1; }),
        0);
    EXPECT_EQ(allBytes(), before);
}

TEST_F(Troubles, OfALockedDatabase) {
    fill();
    Store store = open();
    SQLite::Database other(database().string(), SQLite::OPEN_READWRITE);
    other.exec("BEGIN EXCLUSIVE");
    EXPECT_EQ(troubleIn(Store::open(options())), Trouble::lockedByAnother);
    EXPECT_EQ(troubleIn(store.saveModel(keyOf("head"), test::blobOf(1, 10))), Trouble::lockedByAnother);
    EXPECT_EQ(troubleIn(store.listStudies()), Trouble::lockedByAnother);
    EXPECT_EQ(troubleIn(store.purgeStudy(studyIdentity("1"), DamagedFiles::keep)), Trouble::lockedByAnother);
    other.exec("ROLLBACK");
    EXPECT_EQ(valueOf(store.findModel(keyOf("head"))), std::nullopt);
    EXPECT_TRUE(valueOf(store.findModel(keyOf("chest"))));
}

// The sqlite3 tool can do so.
TEST_F(Troubles, OfWalAreUndone) {
    fill();
    {
        SQLite::Database other(database().string(), SQLite::OPEN_READWRITE);
        EXPECT_EQ(other.execAndGet("PRAGMA journal_mode = WAL").getString(), "wal");
        other.exec("UPDATE volumes SET first_opened = first_opened");
        EXPECT_TRUE(fs::exists(folder_ / "sessions.db-wal"));
    }
    Store store = open();
    EXPECT_FALSE(store.notes().setAside);
    EXPECT_TRUE(valueOf(store.findModel(keyOf("chest"))));
    EXPECT_FALSE(fs::exists(folder_ / "sessions.db-wal"));
    EXPECT_EQ(SQLite::Database(database().string()).execAndGet("PRAGMA journal_mode").getString(), "delete");
}

TEST_F(Troubles, OfANewerSchema) {
    fill();
    execute("PRAGMA user_version = 1000; CREATE TABLE future (a)");
    const auto before = allBytes();
    EXPECT_EQ(troubleIn(Store::open(options())), Trouble::newerSchema);
    EXPECT_EQ(allBytes(), before);
}

// A newer version may have another journal, and a schema that this one takes for damage.
TEST_F(Troubles, OfANewerSchemaThatIsNotUnderstood) {
    fill();
    execute("PRAGMA journal_mode = WAL; PRAGMA user_version = 1000");
    const auto before = allBytes();
    EXPECT_EQ(troubleIn(Store::open(options())), Trouble::newerSchema);
    EXPECT_EQ(allBytes(), before);
    std::string bytes = test::textOf(database());
    const std::size_t table = bytes.find("CREATE TABLE studies");
    ASSERT_NE(table, std::string::npos);
    test::putText(database(), bytes.replace(table, 6, "INVENT"));
    EXPECT_EQ(troubleIn(Store::open(options())), Trouble::newerSchema);
    EXPECT_EQ(test::textOf(database()), bytes);
    EXPECT_FALSE(fs::exists(folder_ / "damaged"));
}

TEST_F(Troubles, OfAFolderOfSomebodyElse) {
    fs::create_directories(folder_);
    test::putText(folder_ / "holiday.jpg", "a picture");
    EXPECT_EQ(troubleIn(Store::open(options())), Trouble::notOurs);
    EXPECT_EQ(test::filesBelow(folder_).size(), 1u);
    test::putText(folder_.parent_path() / "file", "");
    StoreOptions with = options();
    with.folder = folder_.parent_path() / "file";
    EXPECT_EQ(troubleIn(Store::open(with)), Trouble::notOurs);
}

TEST_F(Troubles, OfADatabaseOfSomebodyElse) {
    fs::create_directories(folder_);
    SQLite::Database(database().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
        .exec("CREATE TABLE bookmarks (url)");
    const std::string before = test::textOf(database());
    EXPECT_EQ(troubleIn(Store::open(options())), Trouble::notOurs);
    EXPECT_EQ(test::textOf(database()), before);
}

// The kernel answers as a network drive without locks does.
bool refuseLocks() {
    const sock_filter program[]{
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_fcntl, 0, 4),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[1])),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, F_SETLK, 1, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, F_OFD_SETLK, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOLCK),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog whole{std::size(program), const_cast<sock_filter*>(program)};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &whole, 0, 0) == 0;
}

TEST_F(Troubles, OfADriveWithoutLocks) {
    const int status = test::inChild([&] {
        if (!refuseLocks()) return 77;
        return troubleIn(Store::open(options())) == Trouble::noLocks ? 0 : 1;
    });
    if (status == 77) GTEST_SKIP() << "system calls cannot be filtered here";
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(open().notes().isNew) << "no database was begun";
}

// Two programs find the damage; one of them has the store open all the time.
TEST_F(Troubles, OfADamagedFileThatSomebodyUses) {
    fill();
    Store user = open();
    {
        const std::string bytes = test::textOf(database());
        const int file = ::open(database().c_str(), O_WRONLY);
        ASSERT_EQ(pwrite(file, std::string(100, 'x').data(), 100, 0), 100);
        close(file);
    }
    EXPECT_EQ(troubleIn(Store::open(options())), Trouble::lockedByAnother);
    EXPECT_FALSE(fs::exists(folder_ / "damaged"));
    { const Store gone = std::move(user); }
    Store store = open();
    ASSERT_TRUE(store.notes().setAside);
    EXPECT_TRUE(valueOf(store.findModel(keyOf("chest")))) << "rescued";
}

}  // namespace
}  // namespace macula::session
