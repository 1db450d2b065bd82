// What becomes of archives that answer less, or other things, than they should: no archive that runs here
// does so.
#include "study/archive/fetched_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "net/no_archive.h"

namespace macula::study {

namespace {

namespace fs = std::filesystem;

// Has a study, and sends the files that it is told to.
class OddArchive : public net::test::NoArchive {
  public:
    net::FoundStudy study;
    std::vector<fs::path> sends;
    net::Fetched says;

    Result<net::StudyAnswers> findStudies(const net::StudyQuery& /*query*/, Progress& /*progress*/) override {
        return net::StudyAnswers{.studies = {study}};
    }
    Result<net::Fetched> fetch(const net::Wanted& wanted, net::Receiver& receiver,
                               Progress& /*progress*/) override {
        net::Fetched fetched = says;
        fetched.hadAlready = wanted.sopInstancesHad.size();
        for (const fs::path& file : sends) {
            MACULA_TRY(const fs::path place, receiver.place());
            std::ofstream(place, std::ios::binary) << std::ifstream(file, std::ios::binary).rdbuf();
            MACULA_TRY(const auto verdict, receiver.take(place, {}));
            fetched.kept += verdict == net::Receiver::Verdict::kept ? 1 : 0;
            fetched.refused += verdict == net::Receiver::Verdict::refused ? 1 : 0;
        }
        return fetched;
    }
};

class FetchedStudyTest : public ::testing::Test {
  protected:
    FetchedStudyTest() {
        archive_.sends = dicom::test::writeFiles(folder_ / "files", series_);
        archive_.study = {.studyInstanceUid = series_.studyUid,
                          .patientName = series_.patientName,
                          .patientId = series_.patientId};
        archive_.says.promised = archive_.sends.size();
    }
    Result<FetchedStudy> fetch(FetchRequest request = {}) {
        request.studyInstanceUid = series_.studyUid;
        auto spool = Spool::open(folder_ / "spool", {.patience = {}, .leastFreeBytes = 0});
        EXPECT_TRUE(spool);
        Progress progress;
        return fetchStudy(archive_, "Hospital", request, *spool, progress);
    }
    static bool tells(const FetchedStudy& fetched, std::string_view key) {
        return std::ranges::any_of(fetched.messages,
                                   [&](const Message& message) { return message.key == key; });
    }

    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    OddArchive archive_;
};

TEST_F(FetchedStudyTest, AllThatWasPromisedIsComplete) {
    const auto fetched = fetch();
    ASSERT_TRUE(fetched) << fetched.error().message;
    EXPECT_TRUE(fetched->isComplete);
    EXPECT_TRUE(fetched->messages.empty());
    EXPECT_TRUE(readSpoolRecord(fetched->folder)->isComplete);
}

TEST_F(FetchedStudyTest, FewerThanPromisedIsIncompleteAndSaidUntilTheRestCame) {
    const fs::path last = archive_.sends.back();
    archive_.sends.pop_back();
    auto fetched = fetch();
    ASSERT_TRUE(fetched);
    EXPECT_FALSE(fetched->isComplete);
    EXPECT_TRUE(tells(*fetched, "may-be-missing"));
    EXPECT_FALSE(readSpoolRecord(fetched->folder)->isComplete);
    EXPECT_EQ(readSpoolRecord(fetched->folder)->promised, series_.size.z);
    archive_.sends = {last};
    fetched = fetch();
    ASSERT_TRUE(fetched);
    EXPECT_TRUE(fetched->isComplete);
}

TEST_F(FetchedStudyTest, AListThatWasCutIsNoPromise) {
    archive_.says.isListWhole = false;
    const auto fetched = fetch();
    ASSERT_TRUE(fetched);
    EXPECT_FALSE(fetched->isComplete);
    EXPECT_TRUE(tells(*fetched, "may-be-missing"));
}

TEST_F(FetchedStudyTest, FewerThanTheStudyIsSaidToHaveIsIncomplete) {
    archive_.study.instanceCount = archive_.sends.size() + 1;
    const auto fetched = fetch();
    ASSERT_TRUE(fetched);
    EXPECT_FALSE(fetched->isComplete);
}

TEST_F(FetchedStudyTest, SomeSeriesAreNotTheStudyAndDoNotUndoIt) {
    FetchRequest request;
    request.seriesInstanceUids = {series_.seriesUid};
    auto fetched = fetch(request);
    ASSERT_TRUE(fetched);
    EXPECT_TRUE(fetched->isComplete) << "of that series";
    EXPECT_FALSE(readSpoolRecord(fetched->folder)->isComplete);
    ASSERT_TRUE(fetch());
    EXPECT_TRUE(readSpoolRecord(fetched->folder)->isComplete);
    archive_.says.promised = archive_.sends.size() + 5;
    ASSERT_TRUE(fetch(request));
    EXPECT_TRUE(readSpoolRecord(fetched->folder)->isComplete)
        << "a series that is incomplete now does not take images away";
}

TEST_F(FetchedStudyTest, AnotherPatientThanChosenIsNotFetched) {
    FetchRequest request;
    request.chosen =
        Identity{.patientName = "SOMEBODY^ELSE", .patientId = "OTHER", .studyInstanceUid = series_.studyUid};
    const auto fetched = fetch(request);
    ASSERT_FALSE(fetched);
    EXPECT_EQ(fetched.error().code, ErrorCode::archiveNotUsable);
    EXPECT_TRUE(!fs::exists(folder_ / "spool") || fs::is_empty(folder_ / "spool"));
}

TEST_F(FetchedStudyTest, ANameThatLostLettersRefusesNothing) {
    archive_.study.patientName = "S?NTHETIC^ONE";
    const auto fetched = fetch();
    ASSERT_TRUE(fetched);
    EXPECT_TRUE(fetched->isComplete);
    archive_.study.patientId = "OTHER";
    EXPECT_FALSE(fetch()) << "the ID still counts";
}

}  // namespace

}  // namespace macula::study
