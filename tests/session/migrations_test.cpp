// How the schema grows, from every version that there was.
#include "session/migrations.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdlib>

#include "session/fixture.h"
#include "session/support.h"

namespace macula::session {
namespace {

namespace fs = std::filesystem;
using test::isOk;
using test::troubleIn;
using test::valueOf;

class Migrations : public test::StoreTest {
  protected:
    fs::path database() const { return folder_ / "sessions.db"; }
    std::unique_ptr<Connection> connectHere() const { return valueOf(connect(database(), {})); }
};

int versionOf(Connection& connection) {
    return connection.sqlite.execAndGet("PRAGMA user_version").getInt();
}

TEST_F(Migrations, AreNumberedWithoutGaps) {
    int expected = 0;
    for (const Migration& migration : migrations()) {
        EXPECT_EQ(migration.number, ++expected);
        EXPECT_FALSE(migration.sql.empty());
    }
    EXPECT_GE(newestVersion(), 1);
}

// MACULA_WRITE_FIXTURE=1 writes the fixture of the newest version; those of released versions stay as they
// are.
TEST_F(Migrations, LeadHereFromEveryFixture) {
    test::fillFixture(folder_);
    const std::string newest = test::sqlOf(database());
    if (std::getenv("MACULA_WRITE_FIXTURE") != nullptr)
        test::putText(test::fixtureFile(newestVersion()), newest);
    EXPECT_EQ(test::textOf(test::fixtureFile(newestVersion())), newest);
    for (int version = 1; version <= newestVersion(); ++version) {
        ASSERT_TRUE(fs::exists(test::fixtureFile(version))) << version;
        StoreOptions with = options();
        with.folder = folder_.parent_path() / std::to_string(version);
        test::makeFixture(version, with.folder);
        Store store = open(with);
        EXPECT_FALSE(store.notes().setAside);
        EXPECT_EQ(store.notes().versionBefore, version == newestVersion() ? 0 : version);
        test::expectFixture(store);
    }
}

TEST_F(Migrations, ChangeRowsWithTheirChecksums) {
    test::makeFixture(1, folder_);
    const auto connection = connectHere();
    std::vector<Migration> all(migrations().begin(), migrations().begin() + 1);
    all.push_back(
        {2, "0002_later",
         "UPDATE volumes SET last_opened = last_opened + 5;"
         "UPDATE volumes SET row_check = macula_check('volumes', digest, first_opened, last_opened);"});
    ASSERT_TRUE(isOk(migrate(*connection, all)));
    EXPECT_EQ(versionOf(*connection), 2);
    connection->sqlite.exec("PRAGMA user_version = 1");
    Store store = open();
    Progress progress;
    EXPECT_EQ(valueOf(store.verify(progress)).damagedRows, 0u);
}

// The first of two is there, the second has left nothing.
TEST_F(Migrations, ThatFailChangeNothing) {
    test::makeFixture(1, folder_);
    const auto connection = connectHere();
    std::vector<Migration> all(migrations().begin(), migrations().begin() + 1);
    all.push_back({2, "0002_good", "CREATE TABLE good (a) STRICT;"});
    all.push_back({3, "0003_bad", "CREATE TABLE bad (a INTEGER) STRICT; INSERT INTO bad VALUES ('text');"});
    all[1].sql = "CREATE TABLE good (a INTEGER) STRICT;";
    EXPECT_FALSE(migrate(*connection, all).ok());
    EXPECT_EQ(versionOf(*connection), 2);
    EXPECT_TRUE(connection->sqlite.tableExists("good"));
    EXPECT_FALSE(connection->sqlite.tableExists("bad"));
    all.back().sql = "DELETE FROM studies;";  // what refers to them stays behind
    EXPECT_EQ(troubleIn(migrate(*connection, all)), Trouble::damaged);
    EXPECT_EQ(connection->sqlite.execAndGet("SELECT count(*) FROM studies").getInt(), 1);
    EXPECT_EQ(connection->sqlite.execAndGet("PRAGMA foreign_keys").getInt(), 1);
}

TEST_F(Migrations, RefuseANewerVersion) {
    test::makeFixture(1, folder_);
    const auto connection = connectHere();
    connection->sqlite.exec("PRAGMA user_version = 9");
    EXPECT_EQ(troubleIn(migrate(*connection)), Trouble::newerSchema);
    EXPECT_EQ(versionOf(*connection), 9);
}

TEST_F(Migrations, MakeASchemaThatIsKnownWordForWord) {
    open();
    const auto connection = connectHere();
    EXPECT_TRUE(isOk(checkSchema(*connection)));
    connection->sqlite.exec("DROP TRIGGER audit_is_not_deleted");
    EXPECT_EQ(troubleIn(checkSchema(*connection)), Trouble::damaged);
}

}  // namespace
}  // namespace macula::session
