// Opening, studies and series.
#include "session/store.h"

#include <sys/stat.h>

#include <cstdlib>

#include "session/support.h"

namespace macula::session {
namespace {

namespace fs = std::filesystem;
using test::digestOf;
using test::isOk;
using test::keyOf;
using test::valueOf;

class Stores : public test::StoreTest {};

fs::perms modeOf(const fs::path& path) {
    return fs::status(path).permissions();
}

TEST_F(Stores, AreMadeForTheirOwnerAlone) {
    const mode_t before = umask(0);
    {
        Store store = open();
        EXPECT_TRUE(store.notes().isNew);
        EXPECT_FALSE(store.notes().othersMayRead);
        ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), test::blobOf(1, 1000))));
        for (const fs::path& file : test::filesBelow(folder_))
            EXPECT_EQ(modeOf(folder_ / file), fs::perms::owner_read | fs::perms::owner_write) << file;
        EXPECT_EQ(modeOf(folder_), fs::perms::owner_all);
        EXPECT_EQ(modeOf(folder_ / "models"), fs::perms::owner_all);
    }
    umask(before);
    EXPECT_FALSE(open().notes().isNew);
}

TEST_F(Stores, TakeRightsFromOthersWhereTheyHadSome) {
    open();
    fs::permissions(folder_, fs::perms::all);
    fs::permissions(folder_ / "sessions.db", fs::perms::all);
    EXPECT_FALSE(open().notes().othersMayRead);
    EXPECT_EQ(modeOf(folder_), fs::perms::owner_all);
    EXPECT_EQ(modeOf(folder_ / "sessions.db"), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Stores, AreWhereThePlatformKeepsData) {
    setenv("XDG_DATA_HOME", "/data", 1);
    EXPECT_EQ(defaultFolder(), "/data/macula/sessions");
    setenv("XDG_DATA_HOME", "relative", 1);
    setenv("HOME", "/home/anna", 1);
    EXPECT_EQ(defaultFolder(), "/home/anna/.local/share/macula/sessions");
    unsetenv("XDG_DATA_HOME");
    EXPECT_EQ(defaultFolder(), "/home/anna/.local/share/macula/sessions");
    setenv("MACULA_SESSIONS", "/elsewhere", 1);
    EXPECT_EQ(defaultFolder(), "/elsewhere");
    setenv("MACULA_SESSIONS", "", 1);
    EXPECT_EQ(defaultFolder(), "/home/anna/.local/share/macula/sessions");
    unsetenv("MACULA_SESSIONS");
}

TEST_F(Stores, OpenBehindALink) {
    fs::create_directories(folder_);
    fs::create_directory_symlink(folder_, folder_.parent_path() / "link");
    StoreOptions with = options();
    with.folder = folder_.parent_path() / "link";
    Store store = open(with);
    EXPECT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
}

TEST_F(Stores, RememberWhatWasOpened) {
    Store store = open();
    ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
    nowMs_ += 1000;
    ASSERT_TRUE(isOk(store.recordOpened(opened("2", "1", "head"))));
    nowMs_ += 1000;
    OpenedVolume again = opened("1", "2", "chest late");
    again.readableStudy = "Anna, 1970";
    ASSERT_TRUE(isOk(store.recordOpened(again)));
    const auto studies = valueOf(store.listStudies());
    ASSERT_EQ(studies.entries.size(), 2u);
    EXPECT_EQ(studies.damaged, 0u);
    EXPECT_EQ(studies.entries[0].identity, studyIdentity("1"));
    EXPECT_EQ(studies.entries[0].readable, "Anna, 1970");
    EXPECT_EQ(studies.entries[0].firstOpenedMs, 1'700'000'000'000);
    EXPECT_EQ(studies.entries[0].lastOpenedMs, 1'700'000'002'000);
    EXPECT_EQ(studies.entries[0].series, 2u);
    EXPECT_EQ(studies.entries[1].readable, std::nullopt);
    const auto series = valueOf(store.listSeries(studyIdentity("1")));
    ASSERT_EQ(series.entries.size(), 2u);
    EXPECT_EQ(series.entries[0].identity, seriesIdentity("1", "2"));
    EXPECT_EQ(series.entries[0].volumes, std::vector{digestOf("chest late")});
}

TEST_F(Stores, ForgetReadableTextWhenItIsNotPassed) {
    Store store = open();
    OpenedVolume readable = opened("1", "1", "chest");
    readable.readableStudy = "Anna, 1970";
    readable.readableSeries = "Thorax of Anna";
    ASSERT_TRUE(isOk(store.recordOpened(readable)));
    ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
    EXPECT_EQ(valueOf(store.listStudies()).entries.at(0).readable, std::nullopt);
    for (const fs::path& file : test::filesBelow(folder_))
        EXPECT_EQ(test::textOf(folder_ / file).find("Anna"), std::string::npos) << file;
}

TEST_F(Stores, CountModelsAndDocumentsOfAStudy) {
    Store store = open();
    ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
    ASSERT_TRUE(isOk(store.recordOpened(opened("1", "2", "chest"))));  // the same pixels in two series
    ASSERT_TRUE(isOk(store.recordOpened(opened("2", "1", "head"))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), test::blobOf(1, 1000))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest", "lung"), test::blobOf(2, 500))));
    ASSERT_TRUE(isOk(store.putDocument({DocumentKind::view, studyIdentity("1"), "apex"}, 1, "{}", {})));
    for (const StudyEntry& study : valueOf(store.listStudies()).entries) {
        const bool isFirst = study.identity == studyIdentity("1");
        EXPECT_EQ(study.models, isFirst ? 2u : 0u);
        EXPECT_EQ(study.modelBytes, isFirst ? 1500u : 0u);
        EXPECT_EQ(study.documents, isFirst ? 1u : 0u);
    }
}

TEST_F(Stores, HaveNothingOfOneStudyUnderAnother) {
    Store store = open();
    ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
    ASSERT_TRUE(isOk(store.recordOpened(opened("2", "1", "head"))));
    ASSERT_TRUE(isOk(store.saveModel(keyOf("chest"), test::blobOf(1, 100))));
    ASSERT_TRUE(isOk(
        store.putDocument({DocumentKind::studyState, studyIdentity("1"), "last"}, 1, R"({"of": "1"})", {})));
    EXPECT_EQ(valueOf(store.findModel(keyOf("head"))), std::nullopt);
    EXPECT_TRUE(valueOf(store.nearestModels(keyOf("head"), 10)).empty());
    EXPECT_TRUE(valueOf(store.listModels(digestOf("head"))).entries.empty());
    EXPECT_EQ(valueOf(store.getDocument({DocumentKind::studyState, studyIdentity("2"), "last"})),
              std::nullopt);
    EXPECT_EQ(valueOf(store.getDocument({DocumentKind::studyState, "", "last"})), std::nullopt);
    EXPECT_TRUE(valueOf(store.listDocuments(DocumentKind::studyState, studyIdentity("2"))).entries.empty());
    EXPECT_TRUE(valueOf(store.listDocuments(DocumentKind::studyState, "")).entries.empty());
    const auto series = valueOf(store.listSeries(studyIdentity("2")));
    ASSERT_EQ(series.entries.size(), 1u);
    EXPECT_EQ(series.entries[0].volumes, std::vector{digestOf("head")});
}

TEST_F(Stores, KeepAnAuditTrailThatIsOnlyAddedTo) {
    Store store = open();
    ASSERT_TRUE(isOk(store.recordOpened(opened("1", "1", "chest"))));
    nowMs_ += 5;
    ASSERT_TRUE(isOk(store.addAudit(AuditAction::exported, AuditKind::picture, studyIdentity("1"), 3)));
    const auto trail = valueOf(store.listAudit(10));
    ASSERT_EQ(trail.entries.size(), 2u);
    EXPECT_EQ(trail.entries[0].action, "opened");
    EXPECT_EQ(trail.entries[0].subject, studyIdentity("1"));
    EXPECT_EQ(trail.entries[1].action, "exported");
    EXPECT_EQ(trail.entries[1].kind, "picture");
    EXPECT_EQ(trail.entries[1].amount, 3);
    EXPECT_EQ(trail.entries[1].atMs, nowMs_);
    EXPECT_EQ(valueOf(store.listAudit(1)).entries.at(0).id, trail.entries[1].id);
}

}  // namespace
}  // namespace macula::session
