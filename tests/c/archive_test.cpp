// Archives through the C interface: what is sent to one that really runs is found, fetched and opened.
#include <condition_variable>
#include <fstream>
#include <mutex>
#include <thread>

#include "c/archive_fixture.h"

namespace macula::test {
namespace {

using net::test::Orthanc;
using net::test::QrArchive;

enum class Way { get, move, web, dcmtk };

std::string nameOf(Way way) {
    switch (way) {
        case Way::get:
            return "OrthancByGet";
        case Way::move:
            return "OrthancByMove";
        case Way::web:
            return "OrthancByWeb";
        case Way::dcmtk:
            return "Dcmqrscp";
    }
    return {};
}

// One archive, and one of the ways to it.
class Reached {
  public:
    explicit Reached(Way way) {
        if (way == Way::dcmtk) {
            dcmtk_.emplace();
            source_ = dimseAt(dcmtk_->port(), dcmtk_->title());
            return;
        }
        const std::uint16_t receiver = net::test::freePort();
        orthanc_.emplace(net::test::OrthancOptions{.known = {{"RECEIVER", receiver}}});
        source_ =
            way == Way::web ? webAt(orthanc_->webUrl()) : dimseAt(orthanc_->dicomPort(), orthanc_->title());
        if (way != Way::move) return;
        source_["dimse"]["retrieve"] = "move";
        source_["dimse"]["receiverAe"] = "RECEIVER";
        source_["dimse"]["receiverPort"] = receiver;
    }
    Owned<macula_archive> archive() const { return archiveOf(source_); }

  private:
    std::optional<Orthanc> orthanc_;
    std::optional<QrArchive> dcmtk_;
    nlohmann::json source_;
};

class CArchivesBy : public ::testing::TestWithParam<Way> {
  protected:
    void SetUp() override {
        SKIP_WITHOUT_PROGRAM("Orthanc");
        SKIP_WITHOUT_PROGRAM("dcmqrscp");
        reached_.emplace(GetParam());
        archive_ = reached_->archive();
        ASSERT_NE(archive_, nullptr);
        ASSERT_NO_FATAL_FAILURE(study_.sendTo(archive_.get()));
    }

    SentStudy study_{"2.25.9101", 24, 256};  // of 6 MB, more than comes at once
    std::optional<Reached> reached_;
    Owned<macula_archive> archive_;
};

TEST_P(CArchivesBy, WhatIsSentIsFoundFetchedAndOpened) {
    auto query = sized<macula_query>();
    query.patient_name = "SYNTH*";
    query.modality = "CT";
    const auto found = answered(
        [&](const char** json) { return macula_archive_find(archive_.get(), &query, nullptr, json); });
    ASSERT_EQ(found["studies"].size(), 1u) << found;
    EXPECT_EQ(found["studies"][0]["studyInstanceUid"], study_.uid);
    EXPECT_EQ(found["isCutShort"], false);
    query.patient_name = "NOBODY";
    const auto nobody = answered(
        [&](const char** json) { return macula_archive_find(archive_.get(), &query, nullptr, json); });
    EXPECT_EQ(nobody["studies"].size(), 0u);
    const auto series = answered([&](const char** json) {
        return macula_archive_series(archive_.get(), study_.uid.c_str(), nullptr, json);
    });
    EXPECT_EQ(series.size(), study_.series.size()) << series;

    Fetching fetching(study_);
    ASSERT_EQ(fetching.from(archive_.get()), MACULA_DONE) << lastError().message;
    EXPECT_EQ(fetching.fetched.is_complete, 1);
    EXPECT_EQ(fetching.fetched.kept, study_.files.size());
    EXPECT_EQ(fetching.fetched.promised, study_.files.size());
    EXPECT_EQ(fetching.fetched.never + fetching.fetched.refused + fetching.fetched.had_already, 0u);
    EXPECT_EQ(notesOf(archive_.get()), std::vector<std::string>());
    const std::filesystem::path folder = fetching.fetched.folder;
    EXPECT_EQ(datasetsIn(filesIn(folder)), datasetsIn(study_.files));
    std::uintmax_t bytes = 0;
    for (const auto& file : filesIn(folder)) bytes += std::filesystem::file_size(file);
    EXPECT_EQ(fetching.folder, folder) << "the host heard of it";
    EXPECT_EQ(fetching.instances, study_.files.size()) << "of the last image too";
    EXPECT_EQ(fetching.bytes, bytes);
    EXPECT_GT(fetching.stages, 0);

    macula_study* opened = nullptr;
    ASSERT_EQ(macula_study_open(folder.c_str(), nullptr, nullptr, &opened), MACULA_DONE)
        << lastError().message;
    const Owned<macula_study> owned(opened);
    auto volume = sized<macula_volume>();
    ASSERT_EQ(macula_study_volume(opened, &volume), MACULA_DONE);
    EXPECT_EQ(volume.study_uid, study_.uid);
    EXPECT_EQ(volume.slices, study_.slices);
    for (const std::string& note : notesOf(opened)) EXPECT_EQ(note.find("complete"), std::string::npos);
}

// Holds the first image until another thread has cancelled.
class Halted : public Fetching {
  public:
    explicit Halted(const SentStudy& study) : Fetching(study) {
        EXPECT_EQ(macula_cancel_create(&cancel_), MACULA_DONE);
        progress.cancel = cancel_;
        canceller_ = std::thread([this] {
            std::unique_lock lock(mutex_);
            if (changed_.wait_for(lock, std::chrono::seconds(60), [this] { return hasArrived_; }))
                macula_cancel_now(cancel_);
            hasCancelled_ = true;
            changed_.notify_all();
        });
    }
    ~Halted() override {
        canceller_.join();
        macula_cancel_close(cancel_);
    }

  private:
    bool hears() override {
        std::unique_lock lock(mutex_);
        hasArrived_ = true;
        changed_.notify_all();
        changed_.wait(lock, [this] { return hasCancelled_; });
        return true;
    }

    macula_cancel* cancel_ = nullptr;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool hasArrived_ = false;
    bool hasCancelled_ = false;
    std::thread canceller_;
};

void expectCancelled(macula_status ended, const Fetching& fetching) {
    EXPECT_EQ(ended, MACULA_CANCELLED) << lastError().message;
    EXPECT_STRNE(lastError().message, "");
    EXPECT_EQ(fetching.fetched.folder, nullptr) << "on failure nothing is changed";
    EXPECT_LT(filesIn(fetching.folder).size(), fetching.study().files.size()) << "it ended in the middle";
}

TEST_P(CArchivesBy, AFetchThatIsCancelledGoesOnFromThere) {
    Halted halted(study_);
    const macula_status ended = halted.from(archive_.get());
    // libcurl hands over all that lies in its buffers before anybody can ask it to end.
    const bool hasCome = GetParam() == Way::web && ended == MACULA_DONE;
    if (!hasCome) expectCancelled(ended, halted);
    ASSERT_GE(halted.instances, 1u);
    const std::size_t there = filesIn(halted.folder).size();
    EXPECT_GE(there, 1u);

    // A part of a study does not pass for all of it.
    macula_study* part = nullptr;
    if (!hasCome && macula_study_open(halted.folder.c_str(), nullptr, nullptr, &part) == MACULA_DONE) {
        ASSERT_FALSE(notesOf(part).empty());
        EXPECT_NE(notesOf(part).front().find("not known to be complete"), std::string::npos);
        macula_study_close(part);
    }

    auto fetch = halted.fetch;
    fetch.arrived = nullptr;
    auto fetched = sized<macula_fetched>();
    ASSERT_EQ(macula_archive_fetch(archive_.get(), &fetch, nullptr, &fetched), MACULA_DONE)
        << lastError().message;
    EXPECT_EQ(fetched.is_complete, 1);
    EXPECT_EQ(fetched.had_already, there);
    EXPECT_EQ(fetched.kept, study_.files.size() - there);
    EXPECT_EQ(datasetsIn(filesIn(fetched.folder)), datasetsIn(study_.files));
}

INSTANTIATE_TEST_SUITE_P(Ways, CArchivesBy, ::testing::Values(Way::get, Way::move, Way::web, Way::dcmtk),
                         [](const auto& tested) { return nameOf(tested.param); });

class CArchives : public ::testing::Test {
  protected:
    void SetUp() override { SKIP_WITHOUT_PROGRAM("dcmqrscp"); }
};

// Waits at its first image for the other fetch to have its own.
class Meeting : public Fetching {
  public:
    Meeting(const SentStudy& study, std::atomic<int>& arrived) : Fetching(study), arrived_(arrived) {}
    bool hasMet = false;

  private:
    bool hears() override {
        if (arrivals > 1) return true;
        ++arrived_;
        hasMet = net::test::comes([this] { return arrived_ == 2; });
        return true;
    }

    std::atomic<int>& arrived_;
};

TEST_F(CArchives, TwoFetchesRunAtOnce) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const Orthanc server;  // dcmqrscp sends to one after the other
    const SentStudy studies[]{SentStudy("2.25.9201"), SentStudy("2.25.9202")};
    std::atomic<int> arrived{0};
    Meeting fetches[]{{studies[0], arrived}, {studies[1], arrived}};
    const nlohmann::json source = dimseAt(server.dicomPort(), server.title());
    const Owned<macula_archive> archives[]{archiveOf(source), archiveOf(source)};
    for (const SentStudy& study : studies) ASSERT_NO_FATAL_FAILURE(study.sendTo(archives[0].get()));
    macula_status done[]{MACULA_FAULT, MACULA_FAULT};
    std::thread other([&] { done[1] = fetches[1].from(archives[1].get()); });
    done[0] = fetches[0].from(archives[0].get());
    other.join();
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(done[i], MACULA_DONE);
        EXPECT_TRUE(fetches[i].hasMet) << "one waited for the end of the other";
        EXPECT_EQ(datasetsIn(filesIn(fetches[i].fetched.folder)), datasetsIn(studies[i].files));
    }
}

// From within a fetch, as a host must not.
class Meddling : public Fetching {
  public:
    Meddling(const SentStudy& study, macula_archive* archive) : Fetching(study), archive_(archive) {}
    macula_status found = MACULA_DONE;
    const char* note = "not asked";

  private:
    bool hears() override {
        const char* json = nullptr;
        found = macula_archive_find(archive_, nullptr, nullptr, &json);
        note = macula_archive_note(archive_, 0);
        macula_archive_close(archive_);
        return true;
    }

    macula_archive* archive_;
};

TEST_F(CArchives, OneInUseIsRefusedAndLivesUntilItsCallEnds) {
    const QrArchive server;
    const SentStudy study;
    macula_archive* const archive = archiveOf(dimseAt(server.port(), server.title())).release();
    ASSERT_NO_FATAL_FAILURE(study.sendTo(archive));
    Meddling meddling(study, archive);
    EXPECT_EQ(meddling.from(archive), MACULA_DONE) << lastError().message;
    EXPECT_EQ(meddling.found, MACULA_USAGE);
    EXPECT_EQ(meddling.note, nullptr);
    EXPECT_EQ(meddling.fetched.kept, study.files.size());
    expectError(meddling.from(archive), MACULA_USAGE);
}

class Ending : public Fetching {
  public:
    Ending(const SentStudy& study, bool byArrival) : Fetching(study), byArrival_(byArrival) {}

  private:
    bool hears() override { return !byArrival_; }
    bool hearsProgress() override { return byArrival_; }

    bool byArrival_;
};

TEST_F(CArchives, EitherListenerEndsAFetch) {
    const QrArchive server;
    const SentStudy study;
    const Owned<macula_archive> archive = archiveOf(dimseAt(server.port(), server.title()));
    ASSERT_NO_FATAL_FAILURE(study.sendTo(archive.get()));
    for (const bool byArrival : {true, false}) {
        Ending ending(study, byArrival);
        EXPECT_EQ(ending.from(archive.get()), MACULA_CANCELLED) << byArrival;
        EXPECT_LE(ending.instances, byArrival ? 1u : 0u) << "and hears no more";
    }
}

TEST_F(CArchives, SomeSeriesAreFetchedWithoutTheOthers) {
    const QrArchive server;
    const SentStudy study;
    const Owned<macula_archive> archive = archiveOf(dimseAt(server.port(), server.title()));
    ASSERT_NO_FATAL_FAILURE(study.sendTo(archive.get()));
    Fetching fetching(study);
    const char* const series[]{study.series[1].c_str()};
    fetching.fetch.series_uids = series;
    fetching.fetch.series_count = 1;
    ASSERT_EQ(fetching.from(archive.get()), MACULA_DONE) << lastError().message;
    EXPECT_EQ(fetching.fetched.is_complete, 1) << "of these";
    EXPECT_EQ(fetching.fetched.kept, std::uint64_t(study.slices));
    macula_study* opened = nullptr;
    ASSERT_EQ(macula_study_open(fetching.fetched.folder, nullptr, nullptr, &opened), MACULA_DONE);
    const Owned<macula_study> owned(opened);
    auto volume = sized<macula_volume>();
    ASSERT_EQ(macula_study_volume(opened, &volume), MACULA_DONE);
    EXPECT_EQ(volume.series_uid, study.series[1]);
    EXPECT_NE(notesOf(opened).front().find("not known to be complete"), std::string::npos)
        << "the study has more";
}

TEST_F(CArchives, WithoutAFolderItLiesInThePrivateOne) {
    const QrArchive server;
    const SentStudy study;
    const Owned<macula_archive> archive = archiveOf(dimseAt(server.port(), server.title()));
    ASSERT_NO_FATAL_FAILURE(study.sendTo(archive.get()));
    auto fetch = sized<macula_fetch>();
    fetch.study_uid = study.uid.c_str();
    fetch.into = "";
    auto fetched = sized<macula_fetched>();
    ASSERT_EQ(macula_archive_fetch(archive.get(), &fetch, nullptr, &fetched), MACULA_DONE)
        << lastError().message;
    const std::filesystem::path folder = fetched.folder;
    EXPECT_EQ(folder.parent_path(),
              std::filesystem::path(std::getenv("XDG_DATA_HOME")) / "macula" / "fetched");
    EXPECT_EQ(std::filesystem::status(folder).permissions(), std::filesystem::perms::owner_all);
    EXPECT_EQ(folder.string().find(study.uid), std::string::npos) << "its name says nothing";
}

TEST_F(CArchives, WhatIsRefusedIsToldByFile) {
    SKIP_WITHOUT_PROGRAM("storescp");
    const net::test::StoreServer server;
    const Owned<macula_archive> archive = archiveOf(dimseAt(server.port(), server.title()));
    const dicom::test::TemporaryFolder folder;
    dicom::test::SyntheticSeries series;
    series.size = {8, 8, 1};
    dicom::test::writeFiles(folder.path(), series);
    series.sopClassUid = "2.25.9300";  // which no archive knows
    series.seriesUid = "2.25.9301";
    const std::filesystem::path own = folder / "own";
    std::filesystem::create_directory(own);
    const std::string odd = dicom::test::writeFiles(own, series).front().string();

    const std::string path = folder.path().string();
    const char* const paths[]{path.c_str()};
    auto sent = sized<macula_sent>();
    ASSERT_EQ(macula_archive_send(archive.get(), paths, 1, nullptr, &sent), MACULA_DONE)
        << lastError().message;
    EXPECT_EQ(sent.files, 2u);
    EXPECT_EQ(sent.stored, 1u);
    ASSERT_EQ(sent.refused, 1u);
    auto refusal = sized<macula_refusal>();
    ASSERT_EQ(macula_archive_refusal(archive.get(), 0, &refusal), MACULA_DONE);
    EXPECT_EQ(refusal.file, odd);
    EXPECT_STRNE(refusal.why, "");
    EXPECT_STRNE(refusal.advice, "");
    expectError(macula_archive_refusal(archive.get(), 1, &refusal), MACULA_USAGE);
    ASSERT_EQ(server.files().size(), 1u);

    const std::string text = (folder / "a.txt").string();
    std::ofstream(text) << "no DICOM";
    const char* const none[]{text.c_str()};
    expectError(macula_archive_send(archive.get(), none, 1, nullptr, &sent), MACULA_INPUT);
    EXPECT_EQ(lastError().place, text);
    expectError(macula_archive_refusal(archive.get(), 0, &refusal), MACULA_USAGE);
}

int32_t stop(void* /*user*/, const char* /*stage*/, double /*fraction*/) {
    return 1;
}

TEST_F(CArchives, EachCallIsCancelled) {
    const QrArchive server;
    const SentStudy study;
    const Owned<macula_archive> archive = archiveOf(dimseAt(server.port(), server.title()));
    auto progress = sized<macula_progress>();
    progress.told = stop;
    const char* json = nullptr;
    EXPECT_EQ(macula_archive_find(archive.get(), nullptr, &progress, &json), MACULA_CANCELLED);
    EXPECT_EQ(macula_archive_series(archive.get(), study.uid.c_str(), &progress, &json), MACULA_CANCELLED);
    EXPECT_EQ(macula_archive_test(archive.get(), &progress, &json), MACULA_CANCELLED);
    EXPECT_EQ(json, nullptr);
    const std::string path = study.folder.path().string();
    const char* const paths[]{path.c_str()};
    auto sent = sized<macula_sent>();
    EXPECT_EQ(macula_archive_send(archive.get(), paths, 1, &progress, &sent), MACULA_CANCELLED);
    const auto found =
        answered([&](const char** all) { return macula_archive_find(archive.get(), nullptr, nullptr, all); });
    EXPECT_EQ(found["studies"].size(), 0u) << found;
}

// tests/consumer/fetch_study, a program of somebody else.
TEST_F(CArchives, AProgramInCFetches) {
    const QrArchive server;
    const SentStudy study;
    const nlohmann::json source = dimseAt(server.port(), server.title());
    ASSERT_NO_FATAL_FAILURE(study.sendTo(archiveOf(source).get()));
    const dicom::test::TemporaryFolder folder;
    const auto listed = net::test::ran({MACULA_FETCH_PROGRAM, source.dump()}, folder.path());
    EXPECT_EQ(listed.exitCode, 0) << listed.output;
    EXPECT_NE(listed.output.find(study.uid), std::string::npos) << listed.output;
    const auto fetched = net::test::ran(
        {MACULA_FETCH_PROGRAM, source.dump(), study.uid, (folder / "fetched").string()}, folder.path());
    EXPECT_EQ(fetched.exitCode, 0) << fetched.output;
    EXPECT_NE(fetched.output.find("12 of 12 images came; 16 x 16 x 6 voxels"), std::string::npos)
        << fetched.output;
}

}  // namespace
}  // namespace macula::test
