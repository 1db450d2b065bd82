// Clocks that jump delete nothing for its age, and take no opening back.
#include <SQLiteCpp/SQLiteCpp.h>

#include "session/store.h"
#include "session/support.h"

namespace macula::session {
namespace {

using test::digestOf;
using test::isOk;
using test::valueOf;

constexpr std::int64_t kHourMs = 3'600'000;
constexpr std::int64_t kDayMs = 24 * kHourMs;
constexpr std::chrono::days kRetention{30};

class AgeClocks : public test::StoreTest {
  protected:
    void openStudy(Store& store, std::string_view study) {
        ASSERT_TRUE(isOk(store.recordOpened(opened(study, "1", study))));
    }
    PurgeReport purged(Store& store, Store::Clock clock = Store::Clock::checked) {
        return valueOf(store.purgeUnused(kRetention, DamagedFiles::keep, clock));
    }
    std::size_t studies(Store& store) { return valueOf(store.listStudies()).entries.size(); }
    std::size_t held(Store& store) {
        std::size_t count = 0;
        for (const AuditEntry& entry : valueOf(store.listAudit(1000)).entries)
            count += entry.action == "held" ? 1 : 0;
        return count;
    }
    std::int64_t lastOpened(Store& store, std::string_view study) {
        for (const StudyEntry& entry : valueOf(store.listStudies()).entries)
            if (entry.identity == studyIdentity(study)) return entry.lastOpenedMs;
        return 0;
    }
};

TEST_F(AgeClocks, ThatJumpAheadDeleteNothing) {
    Store store = open();
    openStudy(store, "anna");
    nowMs_ += kDayMs;
    openStudy(store, "bert");
    const std::int64_t before = nowMs_;
    nowMs_ += 3650 * kDayMs;
    EXPECT_EQ(valueOf(store.clockDoubt(kRetention)), ClockDoubt::ahead);
    EXPECT_EQ(held(store), 0u) << "only asked";
    const PurgeReport report = purged(store);
    EXPECT_EQ(report.clock, ClockDoubt::ahead);
    EXPECT_EQ(report.studies + report.volumes, 0u);
    EXPECT_EQ(studies(store), 2u);
    EXPECT_EQ(held(store), 1u);
    // The same wrong day: opening something bears out nothing.
    nowMs_ += kHourMs;
    openStudy(store, "carl");
    EXPECT_EQ(purged(store).clock, ClockDoubt::ahead);
    EXPECT_EQ(studies(store), 3u);
    EXPECT_EQ(held(store), 1u) << "once a day";
    // It is set right, and Carl's opening lies ahead.
    nowMs_ = before + 2 * kDayMs;
    EXPECT_EQ(purged(store).clock, ClockDoubt::behind);
    EXPECT_EQ(studies(store), 3u);
}

TEST_F(AgeClocks, AreBelievedWhenTheyHaveGoneOnForADay) {
    Store store = open();
    openStudy(store, "anna");
    nowMs_ += 31 * kDayMs;
    EXPECT_EQ(purged(store).studies, 0u);
    nowMs_ += kDayMs;
    const PurgeReport report = purged(store);
    EXPECT_EQ(report.clock, ClockDoubt::none);
    EXPECT_EQ(report.studies, 1u);
    EXPECT_EQ(report.volumes, 1u);
}

// A timer of the system asks each day, and nobody opens anything.
TEST_F(AgeClocks, OfATimerDeleteADayLate) {
    Store store = open();
    openStudy(store, "anna");
    int day = 0;
    while (studies(store) > 0 && day < 100) {
        nowMs_ += kDayMs;
        ++day;
        purged(store);
    }
    EXPECT_EQ(day, 32);
    EXPECT_EQ(held(store), 1u);
}

// Who comes every forty days is doubted each time; retention is a visit late, and not for ever.
TEST_F(AgeClocks, OfRareVisitsDeleteAVisitLate) {
    Store store = open();
    openStudy(store, "anna");
    nowMs_ += 40 * kDayMs;
    EXPECT_EQ(purged(store).studies, 0u);
    openStudy(store, "bert");
    nowMs_ += 40 * kDayMs;
    const PurgeReport report = purged(store);
    EXPECT_EQ(report.studies, 1u) << "Anna's, who was old when Bert came";
    EXPECT_EQ(report.clock, ClockDoubt::ahead);
    EXPECT_GT(lastOpened(store, "bert"), 0);
}

TEST_F(AgeClocks, ThatArePutBackDeleteNothing) {
    Store store = open();
    openStudy(store, "anna");
    nowMs_ += 100 * kDayMs;
    openStudy(store, "bert");
    nowMs_ -= 50 * kDayMs;  // Anna's opening is older than the retention by this clock, too
    const PurgeReport report = purged(store);
    EXPECT_EQ(report.clock, ClockDoubt::behind);
    EXPECT_EQ(report.studies, 0u);
    EXPECT_EQ(studies(store), 2u);
    EXPECT_EQ(held(store), 1u);
    EXPECT_EQ(valueOf(store.listAudit(1)).entries.at(0).kind, "store");
    nowMs_ += 50 * kDayMs;
    EXPECT_EQ(purged(store).studies, 1u) << "Anna's, as soon as the clock is right";
}

TEST_F(AgeClocks, TakeNoOpeningBack) {
    Store store = open();
    openStudy(store, "anna");
    const std::int64_t right = nowMs_;
    nowMs_ -= 5000 * kDayMs;
    openStudy(store, "anna");
    openStudy(store, "bert");
    EXPECT_EQ(lastOpened(store, "anna"), right);
    EXPECT_EQ(lastOpened(store, "bert"), right) << "new, and not 5000 days old";
    EXPECT_EQ(valueOf(store.listSeries(studyIdentity("anna"))).entries.at(0).lastOpenedMs, right);
    nowMs_ = right + kDayMs;
    EXPECT_EQ(purged(store).studies, 0u);
    EXPECT_EQ(studies(store), 2u);
}

TEST_F(AgeClocks, ThatAreTrustedAreNotAsked) {
    Store store = open();
    openStudy(store, "anna");
    nowMs_ += 3650 * kDayMs;
    openStudy(store, "bert");
    nowMs_ -= 3600 * kDayMs;
    const PurgeReport report = purged(store, Store::Clock::trusted);
    EXPECT_EQ(report.clock, ClockDoubt::none);
    EXPECT_EQ(report.studies, 1u);
    EXPECT_EQ(lastOpened(store, "bert"), nowMs_);
    EXPECT_EQ(purged(store).clock, ClockDoubt::none) << "nothing lies ahead any more";
    nowMs_ += 20 * kDayMs;
    openStudy(store, "carl");
    nowMs_ += 20 * kDayMs;
    EXPECT_EQ(purged(store).studies, 1u) << "Bert's, 40 days after";
}

// A row that is damaged says nothing of the time.
TEST_F(AgeClocks, AreNotDoubtedForADamagedRow) {
    Store store = open();
    openStudy(store, "anna");
    {
        SQLite::Database sqlite((folder_ / "sessions.db").string(), SQLite::OPEN_READWRITE);
        ASSERT_EQ(sqlite.exec("UPDATE volumes SET last_opened = 9000000000000"), 1);
    }
    EXPECT_EQ(valueOf(store.clockDoubt(kRetention)), ClockDoubt::none);
}

TEST_F(AgeClocks, OfOtherMachinesAreNotImported) {
    Store store = open();
    nowMs_ += 3650 * kDayMs;
    openStudy(store, "anna");
    ASSERT_TRUE(isOk(store.saveModel(test::keyOf("anna"), test::blobOf(1, 100))));
    ASSERT_TRUE(isOk(store.saveModel(test::keyOf("of no study"), test::blobOf(2, 100))));
    ASSERT_TRUE(isOk(store.putDocument({DocumentKind::view, studyIdentity("only this"), "a"}, 1, "{}", {})));
    Progress progress;
    ASSERT_TRUE(isOk(store.exportTo(folder_.parent_path() / "copy", progress)));
    nowMs_ -= 3650 * kDayMs;
    StoreOptions with = options();
    with.folder = folder_.parent_path() / "other";
    Store other = open(with);
    ASSERT_TRUE(isOk(other.importFrom(folder_.parent_path() / "copy", progress)));
    EXPECT_EQ(lastOpened(other, "anna"), nowMs_);
    EXPECT_EQ(valueOf(other.clockDoubt(kRetention)), ClockDoubt::none);
}

}  // namespace
}  // namespace macula::session
