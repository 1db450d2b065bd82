// Models: saving, finding, eviction, and blobs that are not what was saved.
#include "session/store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/resource.h>

#include <csignal>

#include "session/fault_vfs.h"
#include "session/support.h"
#include "session/trouble.h"

namespace macula::session {
namespace {

namespace fs = std::filesystem;
using test::blobOf;
using test::digestOf;
using test::isOk;
using test::keyOf;
using test::troubleIn;
using test::valueOf;

class Models : public test::StoreTest {
  protected:
    fs::path blobFile(const ModelInfo& info) const { return folder_ / "models" / (info.checksum + ".model"); }
    std::size_t blobFiles() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_ / "models"), {}));
    }
};

std::uint32_t numberIn(Store& store, const ModelKey& key) {
    const auto info = valueOf(store.findModel(key));
    EXPECT_TRUE(info);
    return test::numberOf(valueOf(store.readModel(info.value())).blob).value();
}

TEST_F(Models, AreFoundUnderTheirKeyInAnotherRun) {
    const auto blob = blobOf(1, 100'000);
    const auto saved = [&] {
        Store store = open();
        return valueOf(store.saveModel(keyOf("chest"), blob)).info;
    }();
    EXPECT_EQ(saved.bytes, blob.size());
    EXPECT_EQ(saved.usedMs, nowMs_);
    Store store = open();
    const auto found = valueOf(store.findModel(keyOf("chest")));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->id, saved.id);
    EXPECT_EQ(found->checksum, saved.checksum);
    EXPECT_EQ(found->key.digest(), keyOf("chest").digest());
    EXPECT_EQ(valueOf(store.readModel(*found)).blob, blob);
    EXPECT_EQ(valueOf(store.findModel(keyOf("chest", "lung"))), std::nullopt);
    ModelKey trained = keyOf("chest");
    ++trained.trainer;
    EXPECT_EQ(valueOf(store.findModel(trained)), std::nullopt);
}

TEST_F(Models, AreReplacedAndTheirBlobsGo) {
    Store store = open();
    const ModelInfo first = valueOf(store.saveModel(keyOf("chest"), blobOf(1, 1000))).info;
    nowMs_ += 10;
    const ModelInfo second = valueOf(store.saveModel(keyOf("chest"), blobOf(2, 2000))).info;
    EXPECT_EQ(second.id, first.id);
    EXPECT_EQ(second.createdMs, first.createdMs);
    EXPECT_EQ(second.savedMs, nowMs_);
    EXPECT_EQ(blobFiles(), 1u);
    EXPECT_EQ(test::numberOf(valueOf(store.readModel(first)).blob), 2u) << "what was saved last";
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(2, 2000))));
    EXPECT_EQ(numberIn(store, keyOf("chest")), 2u) << "the same blob once more";
}

TEST_F(Models, MayShareABlob) {
    Store store = open();
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 1000))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("head"), blobOf(1, 1000))));
    EXPECT_EQ(blobFiles(), 1u);
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(2, 1000))));
    EXPECT_EQ(numberIn(store, keyOf("head")), 1u);
}

TEST_F(Models, OfTheSameVolumeAreNear) {
    Store store = open();
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "bone", "half"), blobOf(1, 10))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "lung", "half"), blobOf(2, 10))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "bone"), blobOf(3, 10))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("head", "bone"), blobOf(4, 10))));
    ModelKey old = keyOf("chest", "bone", "none");
    old.trainer = 6;
    ASSERT_TRUE(isOk(store.saveModel(old, blobOf(5, 10))));
    const auto near = valueOf(store.nearestModels(keyOf("chest", "bone"), 10));
    ASSERT_EQ(near.size(), 3u);
    EXPECT_EQ(near[0].differing, std::vector<std::string>{"trainer"}) << "the last used of two";
    EXPECT_EQ(near[1].differing, std::vector<std::string>{"clip"});
    EXPECT_EQ(near[2].differing, (std::vector<std::string>{"clip", "transfer-function"}));
    EXPECT_EQ(test::numberOf(valueOf(store.readModel(near[2].info)).blob), 2u);
    EXPECT_EQ(valueOf(store.nearestModels(keyOf("chest", "bone"), 1)).size(), 1u);
}

TEST_F(Models, GoWhenTheyWereNotUsedForLongest) {
    StoreOptions with = options();
    with.modelCapBytes = 3000;
    Store store = open(with);
    for (std::uint32_t i = 0; i < 3; ++i)
        ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", std::to_string(i)), blobOf(i, 1000))));
    ASSERT_TRUE(isOk(store.touchModel(keyOf("chest", "0"))));
    const auto report = valueOf(store.saveModel(keyOf("head"), blobOf(9, 1500)));
    EXPECT_EQ(report.evicted.models, 2u);
    EXPECT_EQ(report.evicted.bytes, 2000u);
    EXPECT_EQ(report.evicted.bytesLeft, 2500u);
    EXPECT_TRUE(valueOf(store.findModel(keyOf("chest", "0"))));
    EXPECT_EQ(valueOf(store.findModel(keyOf("chest", "1"))), std::nullopt);
    EXPECT_EQ(valueOf(store.findModel(keyOf("chest", "2"))), std::nullopt);
    EXPECT_EQ(blobFiles(), 2u);
    EXPECT_EQ(troubleIn(store.saveModel(keyOf("foot"), blobOf(9, 3001))), Trouble::modelTooLarge);
    EXPECT_EQ(valueOf(store.evictModels(0)).models, 2u);
    EXPECT_EQ(blobFiles(), 0u);
}

TEST_F(Models, AreOrderedByUseWhenTheClockIsPutBack) {
    Store store = open();
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "first"), blobOf(1, 100))));
    nowMs_ -= 1'000'000;
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "second"), blobOf(2, 100))));
    EXPECT_EQ(valueOf(store.evictModels(100)).models, 1u);
    EXPECT_TRUE(valueOf(store.findModel(keyOf("chest", "second"))));
}

TEST_F(Models, StayWhileTheyAreOpenInAnyProcess) {
    Store store = open();
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "here"), blobOf(1, 1000))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "there"), blobOf(2, 1000))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "closed"), blobOf(3, 1000))));
    Store other = open();
    {
        const OpenMark there = valueOf(other.markOpen(keyOf("chest", "there")));
        const OpenMark here = valueOf(store.markOpen(keyOf("chest", "here")));
        { const OpenMark twice = valueOf(store.markOpen(keyOf("chest", "here"))); }
        const auto report = valueOf(store.evictModels(0));
        EXPECT_EQ(report.models, 1u);
        EXPECT_EQ(report.bytesLeft, 2000u);
        EXPECT_EQ(numberIn(store, keyOf("chest", "here")), 1u);
        EXPECT_EQ(numberIn(store, keyOf("chest", "there")), 2u);
    }
    EXPECT_EQ(valueOf(store.evictModels(0)).models, 2u);
}

// Each of them: the row is set aside, found no more, and a new model takes its place.
TEST_F(Models, WithADamagedBlobAreSetAside) {
    const auto damage = [](const fs::path& file, int way) {
        std::string text = test::textOf(file);
        if (way == 0) text[500] = static_cast<char>(text[500] ^ 1);
        if (way == 1) text.pop_back();
        if (way == 2) text += '\0';
        if (way == 3) text.clear();
        way == 4 ? static_cast<void>(fs::remove(file)) : test::putText(file, text);
    };
    const char* reasons[]{"checksum", "size", "size", "size", "missing"};
    Store store = open();
    for (int way = 0; way < 5; ++way) {
        const ModelKey key = keyOf("chest", std::to_string(way));
        const ModelInfo info = valueOf(store.saveModel(key, blobOf(7, 1000))).info;
        damage(blobFile(info), way);
        EXPECT_EQ(troubleIn(store.readModel(info)), Trouble::modelDamaged) << way;
        EXPECT_EQ(valueOf(store.findModel(key)), std::nullopt);
        EXPECT_TRUE(valueOf(store.nearestModels(keyOf("chest", "other"), 10)).empty());
        EXPECT_EQ(troubleIn(store.readModel(info)), Trouble::modelGone);
        const auto rows = valueOf(store.listModels(digestOf("chest"))).entries;
        ASSERT_EQ(rows.size(), 1u) << "not deleted";
        EXPECT_EQ(rows[0].aside, reasons[way]);
        ASSERT_TRUE(isOk(store.saveModel(key, blobOf(8, 1000))));
        EXPECT_EQ(numberIn(store, key), 8u);
        EXPECT_EQ(valueOf(store.evictModels(1000)).models, 1u) << "what is set aside goes first";
        EXPECT_EQ(numberIn(store, key), 8u);
        ASSERT_TRUE(isOk(store.evictModels(0)));
    }
}

// Its size counts by the file: the row's own is not to be believed.
TEST_F(Models, WithADamagedRowGoFirst) {
    Store store = open();
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "good"), blobOf(1, 1000))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "bad"), blobOf(2, 1000))));
    {
        SQLite::Database sqlite((folder_ / "sessions.db").string(), SQLite::OPEN_READWRITE);
        EXPECT_EQ(sqlite.exec("UPDATE models SET bytes = 1000000000000 WHERE id = 2"), 1);
    }
    EXPECT_EQ(valueOf(store.evictModels(2000)).models, 0u);
    const EvictionReport report = valueOf(store.evictModels(1500));
    EXPECT_EQ(report.models, 1u);
    EXPECT_EQ(report.bytes, 1000u);
    EXPECT_EQ(report.bytesLeft, 1000u);
    EXPECT_EQ(numberIn(store, keyOf("chest", "good")), 1u);
    EXPECT_EQ(blobFiles(), 1u);
}

TEST_F(Models, LendTheirFilesAsLongAsTheyAreThere) {
    Store store = open();
    const ModelInfo info = valueOf(store.saveModel(keyOf("chest"), blobOf(1, 1000))).info;
    EXPECT_EQ(test::textOf(valueOf(store.modelFile(info))), test::textOf(blobFile(info)));
    {
        const OpenMark mark = valueOf(store.markOpen(keyOf("chest")));
        ASSERT_TRUE(isOk(open().evictModels(0)));
        EXPECT_TRUE(fs::exists(valueOf(store.modelFile(info))));
    }
    ASSERT_TRUE(isOk(open().evictModels(0)));
    EXPECT_EQ(troubleIn(store.modelFile(info)), Trouble::modelGone);
}

TEST_F(Models, ThatACallerCannotUseAreSetAside) {
    Store store = open();
    const ModelInfo first = valueOf(store.saveModel(keyOf("chest"), blobOf(1, 1000))).info;
    ASSERT_TRUE(isOk(store.saveModel(keyOf("head"), blobOf(2, 1000))));
    ASSERT_TRUE(isOk(store.touchModel(keyOf("chest"))));
    ASSERT_TRUE(isOk(store.setModelAside(first, "not-understood")));
    EXPECT_EQ(valueOf(store.findModel(keyOf("chest"))), std::nullopt);
    EXPECT_EQ(valueOf(store.listModels(digestOf("chest"))).entries.at(0).aside, "not-understood");
    ASSERT_TRUE(isOk(store.evictModels(1000)));
    EXPECT_TRUE(valueOf(store.listModels(digestOf("chest"))).entries.empty()) << "it goes first";
    const ModelInfo second = valueOf(store.saveModel(keyOf("chest"), blobOf(3, 1000))).info;
    const ModelInfo third = valueOf(store.saveModel(keyOf("chest"), blobOf(4, 1000))).info;
    EXPECT_EQ(second.id, third.id);
    ASSERT_TRUE(isOk(store.setModelAside(second, "not-understood")));
    EXPECT_EQ(numberIn(store, keyOf("chest")), 4u) << "saved anew since";
}

// Who evicts may have looked for marks before this one came, so marking waits for who writes.
TEST_F(Models, AreMarkedOpenWhenNobodyIsEvicting) {
    Store store = open();
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 1000))));
    {
        SQLite::Database writer((folder_ / "sessions.db").string(), SQLite::OPEN_READWRITE);
        writer.exec("BEGIN IMMEDIATE");
        EXPECT_EQ(troubleIn(store.markOpen(keyOf("chest"))), Trouble::lockedByAnother);
    }
    EXPECT_EQ(valueOf(store.evictModels(0)).models, 1u) << "no mark is left";
}

// Whichever write of the database fails: before the blob has its name, or after.
TEST_F(Models, LeaveNoBlobWhenTheirRowCannotBeWritten) {
    StoreOptions with = options();
    with.vfs = test::kFaultVfs;
    Store store = open(with);
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 1000))));
    std::size_t refused = 0;
    for (int at = 1;; ++at) {
        test::setFault(test::Fault::ioError, at, 1);
        refused += store.saveModel(keyOf("head"), blobOf(2, 1000)).ok() ? 0 : 1;
        const bool hasFailed = test::hasFailed();
        test::setFault(test::Fault::none, 0, 0);
        EXPECT_EQ(blobFiles(), valueOf(store.listModels()).entries.size()) << at;
        if (!hasFailed) break;
    }
    EXPECT_GT(refused, 3u);
    EXPECT_EQ(numberIn(store, keyOf("chest")), 1u);
    EXPECT_EQ(numberIn(store, keyOf("head")), 2u);
}

TEST_F(Models, WithoutARowAreGarbage) {
    Store store = open();
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 1000))));
    test::putText(folder_ / "models" / (digestOf("orphan") + ".model"), "orphan");
    test::putText(folder_ / "models" / ".a.0123456789abcdef.part.model", "left by a killed program");
    const GcReport report = valueOf(store.collectGarbage());
    EXPECT_EQ(report.blobs, 1u);
    EXPECT_EQ(report.bytes, 6u);
    EXPECT_EQ(blobFiles(), 1u);
    EXPECT_EQ(numberIn(store, keyOf("chest")), 1u);
}

TEST_F(Models, AreAsTheyWereWhenTheDiskIsFull) {
    ASSERT_TRUE(isOk(open().saveModel(keyOf("chest"), blobOf(1, 1000))));
    EXPECT_EQ(test::inChild([&] {
                  std::signal(SIGXFSZ, SIG_IGN);
                  auto store = Store::open(options());
                  const rlimit most{200'000, 200'000};  // enough for the database
                  setrlimit(RLIMIT_FSIZE, &most);
                  const auto saved = store->saveModel(keyOf("chest"), blobOf(2, 300'000));
                  return troubleIn(saved) == Trouble::diskFull ? 0 : 1;
              }),
              0);
    Store store = open();
    EXPECT_EQ(numberIn(store, keyOf("chest")), 1u);
    EXPECT_EQ(blobFiles(), 1u);
}

TEST_F(Models, AreVerified) {
    Store store = open();
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 1000))));
    const ModelInfo bad = valueOf(store.saveModel(keyOf("head"), blobOf(2, 1000))).info;
    Progress progress;
    VerifyReport report = valueOf(store.verify(progress));
    EXPECT_TRUE(report.isSound());
    EXPECT_EQ(report.blobs, 2u);
    EXPECT_EQ(report.rows, 4u) << "two volumes, two models";
    test::putText(blobFile(bad), "damaged");
    test::putText(folder_ / "models" / (digestOf("orphan") + ".model"), "orphan");
    report = valueOf(store.verify(progress));
    EXPECT_TRUE(report.isDatabaseSound);
    EXPECT_FALSE(report.isSound());
    EXPECT_EQ(report.damagedBlobs, 1u);
    EXPECT_EQ(report.setAside, 1u);
    EXPECT_EQ(report.orphans, 1u);
    EXPECT_TRUE(valueOf(store.verify(progress)).isSound()) << "set aside, so no longer in the way";
}

}  // namespace
}  // namespace macula::session
