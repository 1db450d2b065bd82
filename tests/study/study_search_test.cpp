// One search over archives and this machine: what each says, however late, wrong or silent.
#include "study/archive/study_search.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <thread>

#include "base/installation_key.h"
#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "net/archive/query_match.h"
#include "net/no_archive.h"
#include "study/archive/local_studies.h"
#include "study/spool/spool.h"

namespace macula::study {
namespace {

namespace fs = std::filesystem;

// Answers a search with what it is given, once it may.
class AnsweringArchive : public net::test::NoArchive {
  public:
    explicit AnsweringArchive(Result<net::StudyAnswers> answer) : answer_(std::move(answer)) {}

    std::shared_future<void> until;

    Result<net::StudyAnswers> findStudies(const net::StudyQuery& /*query*/, Progress& /*progress*/) override {
        if (until.valid()) until.wait();
        return answer_;
    }

  private:
    Result<net::StudyAnswers> answer_;
};

net::FoundStudy found(const std::string& uid) {
    net::FoundStudy study;
    study.studyInstanceUid = uid;
    return study;
}

class StudySearchTest : public ::testing::Test {
  protected:
    StudySearchTest() { fs::remove_all(spoolFolder()); }
    ~StudySearchTest() override { fs::remove_all(spoolFolder()); }

    static std::shared_ptr<AnsweringArchive> answering(std::vector<net::FoundStudy> studies) {
        return std::make_shared<AnsweringArchive>(net::StudyAnswers{.studies = std::move(studies)});
    }
    static NamedArchive named(const char* name, std::shared_ptr<net::Archive> archive) {
        return {name, Result<std::shared_ptr<net::Archive>>(std::move(archive))};
    }
    // All images of the series.
    fs::path putIntoSpool(const std::string& archive, bool isWhole) {
        auto spool = Spool::open(spoolFolder(), {.patience = {}, .leastFreeBytes = 0});
        EXPECT_TRUE(spool);
        auto study = spool->study(series_.studyUid);
        EXPECT_TRUE(study);
        for (const fs::path& file : files_) {
            const auto place = (*study)->place();
            fs::copy_file(file, *place, fs::copy_options::overwrite_existing);
            EXPECT_TRUE((*study)->take(*place, {}));
        }
        SpoolRecord record;
        record.source = archive;
        record.isComplete = isWhole;
        EXPECT_TRUE((*study)->finish(record));
        return (*study)->folder();
    }
    Listing search(const PlacesToSearch& places, const net::StudyQuery& query = {}) {
        Progress progress;
        return searchStudies(places, query, progress);
    }

    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    std::vector<fs::path> files_ = dicom::test::writeFiles(folder_ / "export", series_);
};

TEST_F(StudySearchTest, ListsArchivesInTheirOrderAndNamesTheSilentOnes) {
    const Error why{ErrorCode::archiveNotUsable, Text("Nobody answers."), {}, {}};
    const PlacesToSearch places{
        .archives = {named("A", answering({found("2.25.1")})),
                     named("B", std::make_shared<AnsweringArchive>(why)), NamedArchive{"C", why},
                     named("D", answering({found("2.25.1"), found("2.25.2")}))},
        .isHereToo = true,
        .folders = {}};
    const Listing listing = search(places);
    ASSERT_EQ(listing.studies.size(), 3u);
    EXPECT_EQ(listing.studies[0].archive, "A");
    EXPECT_EQ(listing.studies[1].archive, "D") << "each archive's own copy";
    EXPECT_EQ(listing.studies[2].study.studyInstanceUid, "2.25.2");
    ASSERT_EQ(listing.silent.size(), 2u);
    EXPECT_EQ(listing.silent[0].name, "B");
    EXPECT_EQ(listing.silent[1].name, "C");
}

TEST_F(StudySearchTest, OneThatIsLateHoldsUpNoOther) {
    std::promise<void> mayAnswer;
    const auto late = answering({found("2.25.2")});
    late->until = mayAnswer.get_future().share();
    const PlacesToSearch places{
        .archives = {named("late", late), named("quick", answering({found("2.25.1")}))},
        .isHereToo = false,
        .folders = {}};
    std::size_t before = 0;
    bool isFreed = false;
    Progress progress;
    const Listing all = searchStudies(places, {}, progress, [&](const Listing& soFar) {
        if (soFar.studies.size() != 1 || isFreed) return;
        EXPECT_EQ(soFar.studies[0].archive, "quick");
        before = soFar.studies.size();
        isFreed = true;
        mayAnswer.set_value();
    });
    EXPECT_EQ(before, 1u);
    EXPECT_EQ(all.studies.size(), 2u);
}

TEST_F(StudySearchTest, WhatOthersSendMeanwhileIsAddedAndNoArchiveIsAsked) {
    const Listing before{.studies = {{found("2.25.2"), "A", {}, false}}, .silent = {}};
    const fs::path folder = putIntoSpool("", false);
    const Listing now = withStudiesHere(before, {.patientName = "synth*"});
    ASSERT_EQ(now.studies.size(), 2u);
    EXPECT_EQ(now.studies[0].archive, "A");
    EXPECT_EQ(now.studies[1].folder, folder);
    EXPECT_EQ(now.studies[1].archive, "");
    EXPECT_FALSE(now.studies[1].isWhole);
    EXPECT_EQ(now.studies[1].study.instanceCount, files_.size());
    EXPECT_EQ(withStudiesHere(before, {.patientName = "other*"}).studies.size(), 1u);

    Listing older = now;
    older.studies[1].study.instanceCount = 1;
    const Listing again = withStudiesHere(older, {.patientName = "synth*"});
    ASSERT_EQ(again.studies.size(), 2u) << "it stands once";
    EXPECT_EQ(again.studies[1].study.instanceCount, files_.size());
}

TEST_F(StudySearchTest, AFetchedStudyStandsOnceWithWhereItLies) {
    const fs::path folder = putIntoSpool("A", true);
    const PlacesToSearch places{.archives = {named("A", answering({found(series_.studyUid)})),
                                             named("B", answering({found(series_.studyUid)}))},
                                .isHereToo = true,
                                .folders = {}};
    const Listing listing = search(places);
    ASSERT_EQ(listing.studies.size(), 2u);
    EXPECT_EQ(listing.studies[0].folder, folder);
    EXPECT_TRUE(listing.studies[0].isWhole);
    EXPECT_TRUE(listing.studies[1].folder.empty()) << "B's may be another version";
}

TEST_F(StudySearchTest, WhatLiesHereIsComparedWithTheQuery) {
    putIntoSpool("gone", false);
    dicom::test::SyntheticSeries other;
    other.studyUid = "2.25.5000";
    other.patientName = "OTHER^SOMEBODY";
    dicom::test::writeFiles(folder_ / "export" / "other", other);
    const PlacesToSearch places{.archives = {}, .isHereToo = true, .folders = {folder_ / "export"}};
    EXPECT_EQ(search(places).studies.size(), 3u) << "fetched, and two in the folder";
    const Listing named = search(places, {.patientName = "synth*"});
    ASSERT_EQ(named.studies.size(), 2u);
    EXPECT_FALSE(named.studies[0].isWhole);
    EXPECT_EQ(named.studies[0].study.modalities, std::vector<std::string>{"CT"});
    EXPECT_EQ(named.studies[0].study.instanceCount, files_.size());
    EXPECT_EQ(named.studies[1].folder.parent_path(), folder_ / "export") << "a file of it alone";
    EXPECT_EQ(search(places, {.modality = "MR"}).studies.size(), 0u);
    const PlacesToSearch elsewhere{.archives = {}, .isHereToo = false, .folders = {folder_ / "export"}};
    EXPECT_TRUE(search(elsewhere).studies.empty());
}

TEST(QueryMatch, ComparesEveryKey) {
    net::FoundStudy study;
    study.studyInstanceUid = "2.25.1";
    study.patientName = "MEIER^ANNA=\xe5\xb1\xb1";
    study.patientBirthDate = "19600229";
    study.date = "20260301";
    study.modalities = {"CT", "SR"};
    EXPECT_TRUE(net::matchesQuery({}, study));
    EXPECT_TRUE(net::matchesQuery({.dateFrom = "20260301", .dateTo = "20260301", .modality = "SR"}, study));
    EXPECT_TRUE(net::matchesQuery({.patientName = "meier*", .patientBirthDate = "19600229"}, study));
    EXPECT_FALSE(net::matchesQuery({.patientBirthDate = "19600228"}, study));
    EXPECT_FALSE(net::matchesQuery({.studyInstanceUid = "2.25.11"}, study));
    EXPECT_FALSE(net::matchesQuery({.dateFrom = "20260302"}, study));
    EXPECT_FALSE(net::matchesQuery({.dateTo = "20260228"}, study));
    EXPECT_FALSE(net::matchesQuery({.modality = "C"}, study));
    study.date.clear();
    EXPECT_FALSE(net::matchesQuery({.dateTo = "20300101"}, study)) << "of no day";
}

}  // namespace
}  // namespace macula::study
