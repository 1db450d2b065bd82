// What was deleted is in no byte of any file of the folder.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>

#include "session/lock_file.h"
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

constexpr std::string_view kMarker = "MARKER-OF-ANNA";

class Purges : public test::StoreTest {
  protected:
    std::vector<fs::path> filesWith(std::string_view text) const {
        std::vector<fs::path> found;
        for (const fs::path& file : test::filesBelow(folder_))
            if (test::textOf(folder_ / file).find(text) != std::string::npos) found.push_back(file);
        return found;
    }
    // Everything of a study that can name it, and enough of it that rows move between pages.
    void fillStudy(Store& store, const std::string& uid, const std::string& text) {
        for (int i = 0; i < 40; ++i) {
            OpenedVolume volume = opened(uid, std::to_string(i), uid + std::to_string(i % 4));
            volume.readableStudy = text;
            volume.readableSeries = text + std::to_string(i);
            ASSERT_TRUE(isOk(store.recordOpened(volume)));
            const std::string json =
                "{\"note\": \"" + text + std::string(static_cast<std::size_t>(i) * 97, '.') + "\"}";
            const DocumentId id{DocumentKind::view, studyIdentity(uid), text + std::to_string(i)};
            ASSERT_TRUE(isOk(store.putDocument(id, 1, json, {})));
        }
        std::vector<std::byte> blob = blobOf(1, 50'000);
        std::ranges::copy(std::as_bytes(std::span(text)), blob.begin() + 10'000);
        ASSERT_TRUE(isOk(store.saveModel(keyOf(uid + "0"), blob)));
    }
};

TEST_F(Purges, LeaveNoByteOfAStudy) {
    Store store = open();
    fillStudy(store, "bert", "of-bert");
    fillStudy(store, "anna", std::string(kMarker));
    fillStudy(store, "carl", "of-carl");
    EXPECT_GE(filesWith(kMarker).size(), 2u) << "the database and a blob";
    const PurgeReport report = valueOf(store.purgeStudy(studyIdentity("anna"), DamagedFiles::keep));
    EXPECT_EQ(report.studies, 1u);
    EXPECT_EQ(report.volumes, 4u);
    EXPECT_EQ(report.models, 1u);
    EXPECT_EQ(report.documents, 40u);
    EXPECT_EQ(filesWith(kMarker), std::vector<fs::path>{});
    EXPECT_EQ(filesWith(digestOf("anna0")), std::vector<fs::path>{}) << "the volume";
    EXPECT_EQ(filesWith(seriesIdentity("anna", "1")), std::vector<fs::path>{});
    EXPECT_EQ(filesWith(studyIdentity("anna")), std::vector<fs::path>{"sessions.db"}) << "the audit trail";
    EXPECT_EQ(valueOf(store.listAudit(1)).entries.at(0).action, "deleted");
    EXPECT_EQ(valueOf(store.listStudies()).entries.size(), 2u);
    EXPECT_TRUE(valueOf(store.findModel(keyOf("bert0"))));
    EXPECT_EQ(valueOf(store.listSeries(studyIdentity("carl"))).entries.size(), 40u);
}

TEST_F(Purges, LeaveVolumesThatAnotherStudyHas) {
    Store store = open();
    ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
    ASSERT_TRUE(isOk(store.recordOpened(opened("copy of 1", "1", "chest"))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 100))));
    EXPECT_EQ(valueOf(store.purgeStudy(studyIdentity("1"), DamagedFiles::keep)).volumes, 0u);
    EXPECT_TRUE(valueOf(store.findModel(keyOf("chest"))));
    EXPECT_EQ(valueOf(store.purgeVolume(digestOf("chest"), DamagedFiles::keep)).volumes, 0u);
    EXPECT_EQ(valueOf(store.listAudit(1)).entries.at(0).amount, 0) << "nothing was deleted";
    EXPECT_EQ(valueOf(store.purgeStudy(studyIdentity("copy of 1"), DamagedFiles::keep)).models, 1u);
    EXPECT_EQ(valueOf(store.findModel(keyOf("chest"))), std::nullopt);
}

TEST_F(Purges, OfAVolumeThatBelongsToNoStudy) {
    Store store = open();
    ASSERT_TRUE(isOk(store.recordOpened({.volume = digestOf("nifti")})));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("nifti"), blobOf(1, 100))));
    EXPECT_EQ(valueOf(store.purgeVolume(digestOf("nifti"), DamagedFiles::keep)).models, 1u);
    EXPECT_TRUE(fs::is_empty(folder_ / "models"));
}

// What was set for a file without a study, labels that somebody typed among it, goes with the file's volume.
TEST_F(Purges, OfAVolumeThatBelongsToNoStudyTakeItsStates) {
    Store store = open();
    const auto stateOf = [](std::string_view volume) {
        return DocumentId{DocumentKind::studyState, "", digestOf(volume) + " as it was left"};
    };
    const auto put = [&](const DocumentId& id, std::string_view text) {
        EXPECT_TRUE(isOk(store.putDocument(id, 1, "{\"label\": \"" + std::string(text) + "\"}", {})));
    };
    ASSERT_TRUE(isOk(store.recordOpened({.volume = digestOf("nifti")})));
    ASSERT_TRUE(isOk(store.recordOpened({.volume = digestOf("other")})));
    put(stateOf("nifti"), kMarker);
    put({DocumentKind::studyState, "", digestOf("nifti") + " as it was left, unreadable 0123"}, kMarker);
    put(stateOf("other"), "of another");
    put({DocumentKind::preset, "", digestOf("nifti") + " is a name"}, "of the machine");
    put({DocumentKind::layout, "", "usual"}, "of the machine");
    const PurgeReport report = valueOf(store.purgeVolume(digestOf("nifti"), DamagedFiles::keep));
    EXPECT_EQ(report.documents, 2u);
    EXPECT_EQ(filesWith(kMarker), std::vector<fs::path>{});
    EXPECT_EQ(valueOf(store.getDocument(stateOf("nifti"))), std::nullopt);
    EXPECT_TRUE(valueOf(store.getDocument(stateOf("other"))));
    EXPECT_TRUE(valueOf(store.getDocument({DocumentKind::preset, "", digestOf("nifti") + " is a name"})));
    nowMs_ += std::int64_t{31} * 86'400'000;
    ASSERT_TRUE(isOk(store.recordOpened(opened("new", "1", "foot"))));
    EXPECT_EQ(valueOf(store.purgeUnused(std::chrono::days(30), DamagedFiles::keep)).documents, 1u);
    EXPECT_EQ(valueOf(store.getDocument(stateOf("other"))), std::nullopt);
    EXPECT_TRUE(valueOf(store.getDocument({DocumentKind::layout, "", "usual"})));
}

// Earlier versions left them behind.
TEST_F(Purges, OfAllTakeStatesWhoseVolumeIsGone) {
    Store store = open();
    const DocumentId left{DocumentKind::studyState, "", digestOf("gone") + " as it was left"};
    ASSERT_TRUE(isOk(store.putDocument(left, 1, "{\"label\": \"" + std::string(kMarker) + "\"}", {})));
    EXPECT_FALSE(filesWith(kMarker).empty());
    EXPECT_EQ(valueOf(store.purgeAll(DamagedFiles::keep)).documents, 1u);
    EXPECT_EQ(filesWith(kMarker), std::vector<fs::path>{});
}

TEST_F(Purges, RefuseWhatIsOpen) {
    Store store = open();
    Store other = open();
    ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 100))));
    {
        const OpenMark mark = valueOf(other.markOpen(keyOf("chest")));
        EXPECT_EQ(troubleIn(store.purgeStudy(studyIdentity("1"), DamagedFiles::keep)),
                  Trouble::lockedByAnother);
        EXPECT_EQ(valueOf(store.listStudies()).entries.size(), 1u);
    }
    EXPECT_EQ(valueOf(store.purgeStudy(studyIdentity("1"), DamagedFiles::keep)).models, 1u);
}

TEST_F(Purges, SayWhenAReaderKeepsThemFromTheEnd) {
    Store store = open();
    fillStudy(store, "anna", std::string(kMarker));
    {
        SQLite::Database reader((folder_ / "sessions.db").string());
        // The rows are gone before the reader comes: it only stands in the way of writing the file anew.
        ASSERT_TRUE(isOk(store.purgeStudy(studyIdentity("nobody"), DamagedFiles::keep)));
        SQLite::Statement reading(reader, "SELECT * FROM audit");
        ASSERT_TRUE(reading.executeStep());
        EXPECT_EQ(troubleIn(store.purgeStudy(studyIdentity("anna"), DamagedFiles::keep)),
                  Trouble::lockedByAnother);
    }
    ASSERT_TRUE(isOk(store.purgeStudy(studyIdentity("anna"), DamagedFiles::keep)));
    EXPECT_EQ(filesWith(kMarker), std::vector<fs::path>{});
}

// Rows are gone, bytes are not: what comes next finishes it, though it finds nothing to delete.
TEST_F(Purges, ThatWereStoppedAreFinishedByTheNext) {
    Store store = open();
    for (const char* uid : {"anna", "bert"}) {
        fillStudy(store, uid, std::string(kMarker));
        {
            const auto locks = valueOf(LockFile::open(folder_ / "sessions.lock"));
            const HeldLock reading = valueOf(
                HeldLock::take(locks, LockFile::kBlobs, Hold::shared, std::chrono::milliseconds(100)));
            EXPECT_EQ(troubleIn(store.purgeStudy(studyIdentity(uid), DamagedFiles::keep)),
                      Trouble::purgeIncomplete);
        }
        EXPECT_TRUE(valueOf(store.listStudies()).entries.empty());
        EXPECT_FALSE(filesWith(kMarker).empty()) << "the blob";
        EXPECT_TRUE(fs::exists(folder_ / "sessions.purge"));
        if (uid == std::string("anna")) {
            ASSERT_TRUE(isOk(open().purgeUnused(std::chrono::days(30), DamagedFiles::keep)));
        } else {
            EXPECT_EQ(valueOf(open().collectGarbage()).blobs, 1u);
        }
        EXPECT_EQ(filesWith(kMarker), std::vector<fs::path>{});
        EXPECT_FALSE(fs::exists(folder_ / "sessions.purge"));
    }
}

// Nobody can tell whose it is: it goes with the damaged files.
TEST_F(Purges, RemoveDamagedRowsWithDamagedFiles) {
    Store store = open();
    fillStudy(store, "anna", std::string(kMarker));
    {
        SQLite::Database sqlite((folder_ / "sessions.db").string(), SQLite::OPEN_READWRITE);
        EXPECT_EQ(sqlite.exec("UPDATE documents SET study = NULL WHERE id = 1"), 1);
    }
    ASSERT_TRUE(isOk(store.purgeStudy(studyIdentity("anna"), DamagedFiles::keep)));
    EXPECT_FALSE(filesWith(kMarker).empty());
    EXPECT_EQ(valueOf(store.purgeStudy(studyIdentity("anna"), DamagedFiles::remove)).documents, 1u);
    EXPECT_EQ(filesWith(kMarker), std::vector<fs::path>{});
}

// A rescue that was killed leaves the live file with a second name: it is not overwritten by that.
TEST_F(Purges, OfDamagedFilesLeaveTheLiveOne) {
    Store store = open();
    fillStudy(store, "bert", "of-bert");
    fs::create_directories(folder_ / "damaged" / "then");
    fs::create_hard_link(folder_ / "sessions.db", folder_ / "damaged" / "then" / "sessions.db");
    test::putText(folder_ / "damaged" / "then" / "blob", kMarker);
    EXPECT_EQ(valueOf(store.purgeStudy(studyIdentity("nobody"), DamagedFiles::remove)).damagedFolders, 0u);
    EXPECT_EQ(filesWith(kMarker), std::vector<fs::path>{});
    Store again = open();
    EXPECT_FALSE(again.notes().setAside);
    EXPECT_EQ(valueOf(again.listSeries(studyIdentity("bert"))).entries.size(), 40u);
}

TEST_F(Purges, OfWhatWasNotOpenedForLong) {
    Store store = open();
    ASSERT_TRUE(isOk(store.recordOpened(opened("old", "1", "chest"))));
    ASSERT_TRUE(isOk(store.recordOpened(opened("old but open", "1", "head"))));
    ASSERT_TRUE(isOk(store.recordOpened({.volume = digestOf("nifti")})));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), blobOf(1, 100))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("head"), blobOf(2, 100))));
    ASSERT_TRUE(isOk(store.putDocument({DocumentKind::preset, "", "mine"}, 1, "{}", {})));
    nowMs_ += std::int64_t{31} * 86'400'000;
    ASSERT_TRUE(isOk(store.recordOpened(opened("new", "1", "foot"))));
    const OpenMark mark = valueOf(store.markOpen(keyOf("head")));
    const PurgeReport report = valueOf(store.purgeUnused(std::chrono::days(30), DamagedFiles::keep));
    EXPECT_EQ(report.studies, 1u);
    EXPECT_EQ(report.volumes, 2u);
    EXPECT_EQ(report.models, 1u);
    EXPECT_EQ(report.skippedOpen, 1u);
    EXPECT_EQ(valueOf(store.listStudies()).entries.size(), 2u);
    EXPECT_TRUE(valueOf(store.getDocument({DocumentKind::preset, "", "mine"}))) << "of no study";
    EXPECT_EQ(valueOf(store.purgeUnused(std::chrono::days(30), DamagedFiles::keep)).studies, 0u);
}

TEST_F(Purges, OfAllLeaveWhatIsOpenAndWhatIsOfTheMachine) {
    Store store = open();
    fillStudy(store, "anna", std::string(kMarker));
    ASSERT_TRUE(isOk(store.recordOpened(opened("open", "1", "head"))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("head"), blobOf(2, 100))));
    ASSERT_TRUE(isOk(store.recordOpened({.volume = digestOf("nifti")})));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("nifti"), blobOf(3, 100))));
    ASSERT_TRUE(isOk(store.putDocument({DocumentKind::preset, "", "mine"}, 1, "{}", {})));
    {
        const OpenMark mark = valueOf(store.markOpen(keyOf("head")));
        const PurgeReport report = valueOf(store.purgeAll(DamagedFiles::keep));
        EXPECT_EQ(report.studies, 1u);
        EXPECT_EQ(report.volumes, 5u) << "four of Anna's, and the one of no study";
        EXPECT_EQ(report.models, 2u);
        EXPECT_EQ(report.skippedOpen, 1u);
    }
    EXPECT_EQ(filesWith(kMarker), std::vector<fs::path>{});
    EXPECT_TRUE(valueOf(store.findModel(keyOf("head"))));
    EXPECT_EQ(valueOf(store.listAudit(1)).entries.at(0).action, "deleted");
    EXPECT_EQ(valueOf(store.purgeAll(DamagedFiles::keep)).studies, 1u);
    EXPECT_TRUE(fs::is_empty(folder_ / "models"));
    EXPECT_TRUE(valueOf(store.getDocument({DocumentKind::preset, "", "mine"})));
}

TEST_F(Purges, TellOfDamagedFilesAndRemoveThem) {
    {
        Store store = open();
        fillStudy(store, "anna", std::string(kMarker));
    }
    test::putText(folder_ / "sessions.db", "no database" + test::textOf(folder_ / "sessions.db").substr(11));
    Store store = open();
    ASSERT_TRUE(store.notes().setAside);
    EXPECT_EQ(valueOf(store.purgeStudy(studyIdentity("anna"), DamagedFiles::keep)).damagedFolders, 1u);
    EXPECT_FALSE(filesWith(kMarker).empty());
    EXPECT_EQ(valueOf(store.purgeStudy(studyIdentity("anna"), DamagedFiles::remove)).damagedFolders, 0u);
    EXPECT_EQ(filesWith(kMarker), std::vector<fs::path>{});
}

}  // namespace
}  // namespace macula::session
