// Disks that fail, fill up, write by halves or lose their power, from the first write of some calls to the
// last.
//
// MACULA_SESSION_FAULTS: how many faults of each kind, 25 unless it is set. They are spread evenly; when
// there are more than writes, each write fails several times, and what a power cut takes is drawn anew each
// time.
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "session/fault_vfs.h"
#include "session/store.h"
#include "session/support.h"

namespace macula::session {
namespace {

namespace fs = std::filesystem;
using test::blobOf;
using test::digestOf;
using test::Fault;
using test::isOk;
using test::keyOf;
using test::valueOf;

constexpr std::uint64_t kCap = 70'000;

// What may be there: all that the last call that was told to have gone well left, or what calls that were
// told to have failed since might have left.
using Possible = std::map<std::string, std::set<int>>;

class Power : public test::StoreTest {
  protected:
    Power() {
        Store store = open(withFaults());
        EXPECT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
        EXPECT_TRUE(isOk(store.recordOpened(opened("2", "1", "head"))));
        for (int i = 0; i < 3; ++i)
            EXPECT_TRUE(isOk(store.saveModel(keyOf("chest", nameOf(i)), blobNumber(i))));
        EXPECT_TRUE(isOk(store.putDocument(document("1"), 1, jsonOf(1), {})));
        EXPECT_TRUE(isOk(store.putDocument(document("2"), 2, jsonOf(2), {})));
        fs::copy(folder_, folder_.parent_path() / "whole", fs::copy_options::recursive);
    }
    static int most() { return test::numberFromEnvironment("MACULA_SESSION_FAULTS", 25); }
    StoreOptions withFaults() const {
        StoreOptions with = options();
        with.vfs = test::kFaultVfs;
        with.modelCapBytes = kCap;
        return with;
    }
    static std::string nameOf(int i) { return "preset " + std::to_string(i); }
    static std::vector<std::byte> blobNumber(int i) { return blobOf(static_cast<std::uint32_t>(i), 20'000); }
    static DocumentId document(const std::string& study) {
        return {DocumentKind::studyState, studyIdentity(study), "last"};
    }
    // Of several pages, so that a commit is several writes.
    static std::string jsonOf(int i) {
        return "{\"n\": " + std::to_string(i) + ", \"text\": \"" +
               std::string(9000, static_cast<char>('a' + i)) + "\"}";
    }
    void restoreFolder() {
        fs::remove_all(folder_);
        fs::copy(folder_.parent_path() / "whole", folder_, fs::copy_options::recursive);
    }
    static Possible atFirst() {
        return {
            {"model 0", {0}}, {"model 1", {1}}, {"model 2", {2}}, {"document 1", {1}}, {"document 2", {2}}};
    }

    // Calls that write; what they may leave.
    static void note(Possible& possible, const std::string& what, int value, bool isDone) {
        if (isDone) possible[what].clear();
        possible[what].insert(value);
    }
    static constexpr int kGone = -1;
    void write(Possible& possible) {
        auto store = Store::open(withFaults());
        if (!store) return;
        const auto save = [&](int name, int value) {
            const bool isDone = store->saveModel(keyOf("chest", nameOf(name)), blobNumber(value)).ok();
            note(possible, "model " + std::to_string(name), value, isDone);
            return isDone;
        };
        const auto put = [&](const std::string& study, int value) {
            note(possible, "document " + study, value,
                 store->putDocument(document(study), value, jsonOf(value), {}).ok());
        };
        save(1, 11);
        put("1", 7);
        // The cap is above three of them: the fourth lets the one go that was not used for longest.
        const bool isDone = save(3, 13);
        note(possible, "model 0", kGone, isDone);
        if (!isDone) note(possible, "model 3", kGone, false);
        put("2", 8);
        static_cast<void>(store->touchModel(keyOf("chest", nameOf(1))));
        static_cast<void>(store->evictModels(kCap));
        note(possible, "document 2", kGone, store->purgeStudy(studyIdentity("2"), DamagedFiles::keep).ok());
    }
    void expectPossible(const Possible& possible, int at) {
        StoreOptions with = options();
        with.check = StoreOptions::Check::full;
        auto store = Store::open(with);
        ASSERT_TRUE(isOk(store)) << at;
        EXPECT_FALSE(store->notes().setAside) << at;
        Progress progress;
        const VerifyReport report = valueOf(store->verify(progress));
        EXPECT_TRUE(report.isSound()) << at;
        EXPECT_EQ(report.setAside, 0u) << at;
        for (int i = 0; i < 4; ++i) {
            const auto info = valueOf(store->findModel(keyOf("chest", nameOf(i))));
            const auto number = info ? test::numberOf(valueOf(store->readModel(*info)).blob) : std::nullopt;
            const auto expected = possible.find("model " + std::to_string(i));
            const int found = number ? static_cast<int>(*number) : kGone;
            EXPECT_TRUE(expected == possible.end() ? !info : expected->second.contains(found))
                << "model " << i << " is " << found << " at " << at;
        }
        for (const std::string study : {"1", "2"}) {
            const auto stored = valueOf(store->getDocument(document(study)));
            const int found = stored ? static_cast<int>(stored->version) : kGone;
            EXPECT_TRUE(possible.at("document " + study).contains(found)) << study << " is " << found << at;
            if (!stored) continue;
            EXPECT_EQ(stored->json, jsonOf(found));
        }
        EXPECT_TRUE(valueOf(store->nearestModels(keyOf("head"), 10)).empty());
        EXPECT_TRUE(isOk(store->saveModel(keyOf("head"), blobNumber(99)))) << "it can be used on";
    }
    int operationsWithoutFault(Fault fault) {
        restoreFolder();
        Possible possible = atFirst();
        test::setFault(fault, std::numeric_limits<int>::max(), 0);
        write(possible);
        const int count = test::operationCount();
        test::setFault(Fault::none, 0, 0);
        expectPossible(possible, 0);
        return count;
    }
    void failAtEach(Fault fault) {
        const std::int64_t count = operationsWithoutFault(fault);
        ASSERT_GE(count, 20);
        for (std::int64_t i = 0; i < most() && !HasFailure(); ++i) {
            const std::int64_t step = most() < count ? i * count / most() : i % count;
            const int at = static_cast<int>(step) + 1;
            restoreFolder();
            Possible possible = atFirst();
            test::setFault(fault, at, static_cast<std::uint32_t>(i));
            write(possible);
            EXPECT_TRUE(test::hasFailed()) << at << " of " << count;
            fault == Fault::powerCut ? test::loseUnsynced() : test::setFault(Fault::none, 0, 0);
            expectPossible(possible, at);
        }
    }
};

TEST_F(Power, FailingWritesLoseNothing) {
    failAtEach(Fault::ioError);
}
TEST_F(Power, ShortWritesLoseNothing) {
    failAtEach(Fault::shortWrite);
}
TEST_F(Power, AFullDiskLosesNothing) {
    failAtEach(Fault::diskFull);
}
TEST_F(Power, TornWritesLoseNothing) {
    failAtEach(Fault::tornWrite);
}
TEST_F(Power, PowerCutsLoseNothing) {
    failAtEach(Fault::powerCut);
}

// A disk that does not read is no damaged file.
TEST_F(Power, FailingReadsLoseNothing) {
    failAtEach(Fault::readError);
}

TEST_F(Power, OfAStoreThatIsMadeLeavesOneThatOpens) {
    for (const Fault fault :
         {Fault::ioError, Fault::shortWrite, Fault::diskFull, Fault::tornWrite, Fault::powerCut}) {
        for (int at = 1;; ++at) {
            fs::remove_all(folder_);
            test::setFault(fault, at, static_cast<std::uint32_t>(at));
            {
                const auto store = Store::open(withFaults());
                EXPECT_TRUE(store.ok() || troubleOf(store.error()) == Trouble::diskFull ||
                            troubleOf(store.error()) == Trouble::diskError ||
                            troubleOf(store.error()) == Trouble::readOnly)
                    << store.error().message;
            }
            const bool isOver = !test::hasFailed();
            fault == Fault::powerCut ? test::loseUnsynced() : test::setFault(Fault::none, 0, 0);
            Store store = open();
            EXPECT_FALSE(store.notes().setAside) << at;
            ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobNumber(1))));
            if (isOver) break;
        }
    }
}

}  // namespace
}  // namespace macula::session
