// Export and import.
#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/stat.h>

#include "session/database.h"
#include "session/rows.h"
#include "session/store.h"
#include "session/support.h"

namespace macula::session {
namespace {

namespace fs = std::filesystem;
using test::blobOf;
using test::digestOf;
using test::isOk;
using test::keyOf;
using test::troubleIn;
using test::valueOf;

class Snapshots : public test::StoreTest {
  protected:
    fs::path target() const { return folder_.parent_path() / "copy"; }
    Store openOther() {
        StoreOptions with = options();
        with.folder = folder_.parent_path() / "other";
        return open(with);
    }
    void fill(Store& store) {
        ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
        ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 1000))));
        ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "lung"), blobOf(2, 1000))));
        ASSERT_TRUE(isOk(
            store.putDocument({DocumentKind::studyState, studyIdentity("1"), "last"}, 1, R"({"a": 1})", {})));
    }
    Progress progress_;
};

std::optional<std::uint32_t> numberIn(Store& store, const ModelKey& key) {
    const auto info = valueOf(store.findModel(key));
    return info ? test::numberOf(valueOf(store.readModel(*info)).blob) : std::nullopt;
}

TEST_F(Snapshots, BringAllOfAStoreIntoAnother) {
    Store store = open();
    fill(store);
    const SnapshotReport out = valueOf(store.exportTo(target(), progress_));
    EXPECT_EQ(out.studies, 1u);
    EXPECT_EQ(out.models, 2u);
    EXPECT_EQ(out.documents, 1u);
    EXPECT_EQ(fs::status(target()).permissions(), fs::perms::owner_all);
    EXPECT_EQ(test::filesBelow(target()).size(), 3u) << "a database and two blobs";
    for (const fs::path& file : test::filesBelow(target()))
        EXPECT_EQ(fs::status(target() / file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    Store other = openOther();
    const SnapshotReport in = valueOf(other.importFrom(target(), progress_));
    EXPECT_EQ(in.studies, 1u);
    EXPECT_EQ(in.models, 2u);
    EXPECT_EQ(in.documents, 1u);
    EXPECT_EQ(in.damaged, 0u);
    EXPECT_EQ(numberIn(other, keyOf("chest", "lung")), 2u);
    EXPECT_EQ(valueOf(other.getDocument({DocumentKind::studyState, studyIdentity("1"), "last"}))->json,
              R"({"a": 1})");
    EXPECT_EQ(valueOf(other.listSeries(studyIdentity("1"))).entries.at(0).volumes,
              std::vector{digestOf("chest")});
    EXPECT_TRUE(valueOf(other.verify(progress_)).isSound());
    const SnapshotReport again = valueOf(other.importFrom(target(), progress_));
    EXPECT_EQ(again.models + again.documents + again.studies, 0u);
    EXPECT_EQ(again.skipped, 3u);
    EXPECT_EQ(test::filesBelow(folder_.parent_path() / "other").size(), 5u) << "nothing is left over";
}

TEST_F(Snapshots, TheNewerOfTwoStays) {
    Store store = open();
    fill(store);
    Store other = openOther();
    nowMs_ += 1000;
    ASSERT_TRUE(isOk(other.saveModel(keyOf("chest"), blobOf(10, 1000))));
    ASSERT_TRUE(isOk(store.exportTo(target(), progress_)));
    ASSERT_TRUE(isOk(other.importFrom(target(), progress_)));
    EXPECT_EQ(numberIn(other, keyOf("chest")), 10u);
    nowMs_ += 1000;
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(11, 1000))));
    fs::remove_all(target());
    ASSERT_TRUE(isOk(store.exportTo(target(), progress_)));
    EXPECT_EQ(valueOf(other.importFrom(target(), progress_)).models, 1u);
    EXPECT_EQ(numberIn(other, keyOf("chest")), 11u);
}

TEST_F(Snapshots, LeaveOutWhatIsDamaged) {
    Store store = open();
    fill(store);
    const ModelInfo bad = *valueOf(store.findModel(keyOf("chest")));
    test::putText(folder_ / "models" / (bad.checksum + ".model"), "damaged");
    const SnapshotReport out = valueOf(store.exportTo(target(), progress_));
    EXPECT_EQ(out.models, 1u);
    EXPECT_EQ(out.damaged, 1u);
    const ModelInfo good = *valueOf(store.findModel(keyOf("chest", "lung")));
    test::putText(target() / "models" / (good.checksum + ".model"), "damaged on the way");
    Store other = openOther();
    const SnapshotReport in = valueOf(other.importFrom(target(), progress_));
    EXPECT_EQ(in.models, 0u);
    EXPECT_EQ(in.damaged, 1u);
    EXPECT_EQ(numberIn(other, keyOf("chest", "lung")), std::nullopt);
}

// 64 GB that take no room on the disk: an import that read them first would need that much memory.
TEST_F(Snapshots, AskTheCapBeforeTheyRead) {
    Store store = open();
    fill(store);
    ASSERT_TRUE(isOk(store.exportTo(target(), progress_)));
    constexpr std::int64_t kBytes = std::int64_t{64} << 30;
    const ModelInfo model = *valueOf(store.findModel(keyOf("chest")));
    {
        SQLite::Database sqlite((target() / "sessions.db").string(), SQLite::OPEN_READWRITE);
        addCheckFunction(sqlite);
        EXPECT_EQ(sqlite.exec("UPDATE models SET bytes = " + std::to_string(kBytes) + " WHERE blob = '" +
                              model.checksum + "'"),
                  1);
        EXPECT_EQ(
            sqlite.exec("UPDATE models SET row_check = macula_check('models', id, key, volume, trainer, "
                        "parts, bytes, blob, created, saved, used, aside)"),
            2);
    }
    fs::resize_file(target() / "models" / (model.checksum + ".model"), kBytes);
    Store other = openOther();
    const SnapshotReport in = valueOf(other.importFrom(target(), progress_));
    EXPECT_EQ(in.skipped, 1u) << "above the cap";
    EXPECT_EQ(in.models, 1u);
    EXPECT_EQ(in.damaged, 0u);
    EXPECT_EQ(numberIn(other, keyOf("chest", "lung")), 2u);
}

// Under the cap each blob is read a piece at a time, and taken only where all of it is as it was written.
TEST_F(Snapshots, TakeNoBlobThatChangedBehindItsFirstPiece) {
    Store store = open();
    ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 3'000'001))));
    ASSERT_TRUE(isOk(store.exportTo(target(), progress_)));
    const ModelInfo model = *valueOf(store.findModel(keyOf("chest")));
    const fs::path file = target() / "models" / (model.checksum + ".model");
    std::string text = test::textOf(file);
    ASSERT_EQ(text.size(), 3'000'001u);
    {
        Store other = openOther();
        EXPECT_EQ(valueOf(other.importFrom(target(), progress_)).models, 1u);
        EXPECT_EQ(numberIn(other, keyOf("chest")), 1u);
    }
    fs::remove_all(folder_.parent_path() / "other");
    text.back() = static_cast<char>(text.back() + 1);
    test::putText(file, text);
    Store other = openOther();
    const SnapshotReport in = valueOf(other.importFrom(target(), progress_));
    EXPECT_EQ(in.models, 0u);
    EXPECT_EQ(in.damaged, 1u);
    EXPECT_TRUE(fs::is_empty(folder_.parent_path() / "other" / "models"));
}

TEST_F(Snapshots, ReplaceNothingAndLeaveNothing) {
    Store store = open();
    fill(store);
    fs::create_directories(target());
    const auto refused = store.exportTo(target(), progress_);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::outputNotWritable);
    fs::remove(target());
    Progress stopped;
    stopped.token().cancel();
    const auto cancelled = store.exportTo(target(), stopped);
    ASSERT_FALSE(cancelled.ok());
    EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.parent_path()), {}), 1) << "only the store";
}

TEST_F(Snapshots, GoBehindALinkAndNotIntoTheStore) {
    Store store = open();
    fill(store);
    fs::create_directories(folder_.parent_path() / "disk");
    fs::create_directory_symlink(folder_.parent_path() / "disk", folder_.parent_path() / "link");
    EXPECT_EQ(valueOf(store.exportTo(folder_.parent_path() / "link" / "copy" / "", progress_)).models, 2u);
    EXPECT_TRUE(fs::exists(folder_.parent_path() / "disk" / "copy" / "sessions.db"));
    const auto refused = store.exportTo(folder_ / "models" / "copy", progress_);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::outputNotWritable);
    EXPECT_FALSE(store.exportTo(folder_.parent_path() / "none" / "copy", progress_).ok());
    EXPECT_EQ(valueOf(store.listAudit(9)).entries.size(), 2u) << "opened, exported";
    EXPECT_FALSE(open().notes().isNew);
}

// Anybody may have made it: rows that no store writes are left out.
TEST_F(Snapshots, BringNothingThatNoStoreWrites) {
    Store store = open();
    fill(store);
    ASSERT_TRUE(isOk(store.exportTo(target(), progress_)));
    const std::string crafted(64, 'Z');
    {
        const auto connection = valueOf(connect(target() / "sessions.db", {}));
        putRow(*connection, kStudies, {{crafted, std::string("text"), std::int64_t{1}, std::int64_t{1}}});
        putRow(*connection, kDocuments,
               {{std::int64_t{99}, std::string("view"), Value(), std::string("list"), std::int64_t{1},
                 std::string("[1]"), std::int64_t{1}, std::int64_t{1}, Value()}});
    }
    Store other = openOther();
    ASSERT_TRUE(isOk(other.importFrom(target(), progress_)));
    const auto studies = valueOf(other.listStudies());
    ASSERT_EQ(studies.entries.size(), 1u);
    EXPECT_EQ(studies.entries[0].identity, studyIdentity("1"));
    EXPECT_TRUE(valueOf(other.listDocuments(DocumentKind::view, "")).entries.empty());
}

TEST_F(Snapshots, ThatAreNoneAreRefused) {
    Store store = open();
    fill(store);
    EXPECT_EQ(troubleIn(store.importFrom(target(), progress_)), Trouble::snapshotInvalid);
    fs::create_directories(target());
    EXPECT_EQ(troubleIn(store.importFrom(target(), progress_)), Trouble::snapshotInvalid);
    for (const char* text : {"", "no database at all, but some bytes"}) {
        test::putText(target() / "sessions.db", text);
        EXPECT_EQ(troubleIn(store.importFrom(target(), progress_)), Trouble::snapshotInvalid);
        EXPECT_EQ(test::textOf(target() / "sessions.db"), text);
    }
    EXPECT_EQ(numberIn(store, keyOf("chest")), 1u);
}

TEST_F(Snapshots, KeepToTheCap) {
    Store store = open();
    fill(store);
    ASSERT_TRUE(isOk(store.exportTo(target(), progress_)));
    StoreOptions with = options();
    with.folder = folder_.parent_path() / "other";
    with.modelCapBytes = 1500;
    Store other = open(with);
    ASSERT_TRUE(isOk(other.importFrom(target(), progress_)));
    const auto models = valueOf(other.listModels()).entries;
    ASSERT_EQ(models.size(), 1u);
    EXPECT_EQ(models[0].key.digest(), keyOf("chest", "lung").digest()) << "the last used of them";
}

}  // namespace
}  // namespace macula::session
