#include "study/spool/spool.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include "dicom/synthetic.h"

namespace macula::study {

namespace {

namespace fs = std::filesystem;
using Verdict = net::Receiver::Verdict;

std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class SpoolTest : public ::testing::Test {
  protected:
    SpoolTest() : folder_(fs::temp_directory_path() / ("macula-spool-" + std::to_string(getpid()))) {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        files_ = dicom::test::writeFiles(folder_ / "sent", series_);
    }
    ~SpoolTest() override { fs::remove_all(folder_); }

    Spool open(SpoolLimits limits = {.patience = {}, .leastFreeBytes = 0}) {
        auto spool = Spool::open(folder_ / "spool", limits);
        EXPECT_TRUE(spool) << (spool ? Text() : spool.error().message);
        return *spool;
    }
    std::unique_ptr<SpooledStudy> studyIn(Spool& spool) {
        auto study = spool.study(series_.studyUid);
        EXPECT_TRUE(study) << (study ? Text() : study.error().message);
        return study ? *std::move(study) : nullptr;
    }
    static Result<Verdict> receive(SpooledStudy& study, const fs::path& file,
                                   const net::InstanceKey& promised = {}) {
        MACULA_TRY(const fs::path place, study.place());
        std::ofstream(place, std::ios::binary) << bytesOf(file);
        return study.take(place, promised);
    }
    std::vector<fs::path> writeOther(const char* name,
                                     const std::function<void(dicom::test::SyntheticSeries&)>& change) {
        dicom::test::SyntheticSeries other;
        change(other);
        return dicom::test::writeFiles(folder_ / name, other);
    }
    std::vector<fs::path> kept(const SpooledStudy& study) {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(study.folder())) files.push_back(entry.path());
        return files;
    }
    std::size_t arriving() {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(folder_ / "spool" / "arriving"))
            count += entry.path().extension() == ".dcm" ? 1 : 0;
        return count;
    }

    fs::path folder_;
    dicom::test::SyntheticSeries series_;
    std::vector<fs::path> files_;
};

TEST_F(SpoolTest, KeepsEachInstanceOnceAsItCame) {
    Spool spool = open();
    const auto study = studyIn(spool);
    for (const fs::path& file : files_) EXPECT_EQ(*receive(*study, file), Verdict::kept);
    EXPECT_EQ(*receive(*study, files_.front()), Verdict::hadAlready);
    EXPECT_EQ(study->instances().size(), files_.size());

    std::vector<std::string> sent, found;
    for (const fs::path& file : files_) sent.push_back(bytesOf(file));
    for (const fs::path& file : kept(*study)) {
        found.push_back(bytesOf(file));
        EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
        EXPECT_EQ(file.filename().string().find("2.25"), std::string::npos) << "a UID in a name";
    }
    std::ranges::sort(sent);
    std::ranges::sort(found);
    EXPECT_EQ(sent, found);
    EXPECT_EQ(fs::status(study->folder()).permissions(), fs::perms::owner_all);
    ASSERT_TRUE(study->finish({}));
    EXPECT_EQ(fs::status(spoolRecordFile(study->folder())).permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(arriving(), 0u);
}

TEST_F(SpoolTest, OfAnotherStudyOrPatientNothingIsKept) {
    Spool spool = open();
    const auto study = studyIn(spool);
    ASSERT_EQ(*receive(*study, files_.front()), Verdict::kept);
    const auto otherStudy = writeOther("study", [](auto& s) { s.studyUid = "2.25.7"; });
    const auto otherPatient = writeOther("patient", [](auto& s) {
        s.patientId = "SYN2";
        s.patientName = "SYNTHETIC^TWO";
    });
    EXPECT_EQ(*receive(*study, otherStudy[1]), Verdict::refused);
    EXPECT_EQ(*receive(*study, otherPatient[1]), Verdict::refused);
    EXPECT_EQ(*receive(*study, files_[2], {.sopInstanceUid = "2.25.99"}), Verdict::refused)
        << "not what was promised";
    EXPECT_EQ(study->ofOtherStudies(), 3u);
    EXPECT_EQ(kept(*study).size(), 1u);
    EXPECT_EQ(arriving(), 0u);
}

TEST_F(SpoolTest, ThePatientWhomTheArchiveNamesCounts) {
    Spool spool = open();
    const auto study = studyIn(spool);
    ASSERT_TRUE(study->expect(
        {.patientName = "SOMEBODY^ELSE", .patientId = "OTHER", .studyInstanceUid = series_.studyUid}));
    EXPECT_EQ(*receive(*study, files_.front()), Verdict::refused);
    ASSERT_TRUE(study->expect({.patientName = series_.patientName,
                               .patientId = series_.patientId,
                               .studyInstanceUid = series_.studyUid}));
    EXPECT_EQ(*receive(*study, files_.front()), Verdict::kept);
    const auto changed = study->expect(
        {.patientName = "SOMEBODY^ELSE", .patientId = "OTHER", .studyInstanceUid = series_.studyUid});
    EXPECT_FALSE(changed) << "files of another patient are there";
}

TEST_F(SpoolTest, WhatIsNoDicomIsRefused) {
    Spool spool = open();
    const auto study = studyIn(spool);
    const fs::path noise = folder_ / "noise";
    std::ofstream(noise) << "<html>Sign in first</html>";
    EXPECT_EQ(*receive(*study, noise), Verdict::refused);
    fs::copy_file(files_.front(), folder_ / "half");
    fs::resize_file(folder_ / "half", 300);  // within the header
    EXPECT_EQ(*receive(*study, folder_ / "half"), Verdict::refused);
    EXPECT_EQ(study->unreadable(), 2u);
    EXPECT_TRUE(kept(*study).empty());
}

TEST_F(SpoolTest, TheNextProgramGoesOnFromThere) {
    {
        Spool spool = open();
        const auto study = studyIn(spool);
        for (std::size_t i = 0; i < 5; ++i) ASSERT_EQ(*receive(*study, files_[i]), Verdict::kept);
        ASSERT_TRUE(study->finish({.source = "Hospital", .promised = files_.size()}));
    }
    Spool spool = open();
    ASSERT_EQ(spool.entries().size(), 1u);
    const SpoolEntry entry = spool.entries().front();
    EXPECT_EQ(entry.instances, 5u);
    EXPECT_EQ(entry.record.source, "Hospital");
    EXPECT_EQ(entry.record.promised, files_.size());
    EXPECT_FALSE(entry.record.isComplete);
    const auto study = studyIn(spool);
    EXPECT_EQ(study->instances().size(), 5u);
    EXPECT_EQ(*receive(*study, files_[0]), Verdict::hadAlready);
    EXPECT_EQ(*receive(*study, files_[5]), Verdict::kept);
}

TEST_F(SpoolTest, TwoProgramsDoNotFetchOneStudyAtOnce) {
    Spool spool = open();
    const auto study = studyIn(spool);
    Spool other = open();
    const auto second = other.study(series_.studyUid);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, ErrorCode::usage);
    EXPECT_TRUE(other.study("2.25.8")) << "another study";
}

TEST_F(SpoolTest, AFullDiskIsSaidBeforeAnythingIsWritten) {
    Spool spool = open({.leastFreeBytes = std::uintmax_t(1) << 60});
    const auto study = studyIn(spool);
    const auto place = study->place();
    ASSERT_FALSE(place);
    EXPECT_EQ(place.error().code, ErrorCode::outputNotWritable);
    EXPECT_EQ(arriving(), 0u);
}

TEST_F(SpoolTest, AnArchiveThatNeverEndsIsStopped) {
    Spool spool = open({.leastFreeBytes = 0, .mostInstancesOfStudy = 3});
    const auto study = studyIn(spool);
    for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(*receive(*study, files_[i]), Verdict::kept);
    EXPECT_FALSE(study->place());
}

TEST_F(SpoolTest, PurgesWhatWasUsedLongestAgo) {
    Spool spool = open();
    for (const char* uid : {"2.25.11", "2.25.12", "2.25.13"}) {
        const auto files = writeOther(uid, [&](auto& s) { s.studyUid = uid; });
        auto study = *spool.study(uid);
        for (const fs::path& file : files) ASSERT_EQ(*receive(*study, file), Verdict::kept);
        ASSERT_TRUE(study->finish({.source = "Hospital"}));
        const auto age = std::chrono::hours(std::string(uid).back() == '1'   ? 1
                                            : std::string(uid).back() == '2' ? 3
                                                                             : 2);
        fs::last_write_time(spoolRecordFile(study->folder()), fs::file_time_type::clock::now() - age);
    }
    const std::uintmax_t each = spool.entries().front().bytes;
    EXPECT_EQ(*spool.purge(0), 0u) << "what it has given out may be in use";
    spool = open();
    EXPECT_EQ(*spool.purge(2 * each + each / 2), 1u);
    EXPECT_FALSE(fs::exists(spool.folderOf("2.25.12")));
    EXPECT_EQ(spool.entries().size(), 2u);
    EXPECT_EQ(*spool.purge(0), 2u);
    EXPECT_TRUE(spool.entries().empty());
}

TEST_F(SpoolTest, SeveralThreadsReceiveAtOnce) {
    Spool spool = open();
    const auto study = studyIn(spool);
    std::atomic<int> told{0};
    study->onKept([&] { ++told; });
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&] {
            for (const fs::path& file : files_) ASSERT_TRUE(receive(*study, file));
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(study->instances().size(), files_.size());
    EXPECT_EQ(told, static_cast<int>(files_.size()));
    EXPECT_EQ(arriving(), 0u);
}

// A process that receives without end is killed at a random moment; the spool opens, and all it holds is
// whole.
TEST_F(SpoolTest, KilledAtAnyMomentItOpensAndHoldsWholeFiles) {
    std::mt19937 random(7);
    for (int round = 0; round < 100; ++round) {
        const pid_t child = fork();
        if (child == 0) {
            auto spool = Spool::open(folder_ / "spool", {.leastFreeBytes = 0});
            auto study = spool ? spool->study(series_.studyUid) : Error{};
            if (!study) _exit(1);
            for (std::size_t i = 0;; ++i) {
                if (!receive(**study, files_[i % files_.size()])) _exit(2);
                if (i % files_.size() == 0) static_cast<void>((*study)->finish({.source = "Hospital"}));
            }
        }
        usleep(std::uniform_int_distribution<useconds_t>(0, 20'000)(random));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself: " << status;

        Spool spool = open();
        const auto study = studyIn(spool);
        ASSERT_TRUE(study);
        EXPECT_EQ(arriving(), 0u);
        for (const fs::path& file : kept(*study)) {
            if (file.extension() != ".dcm") continue;
            const std::string bytes = bytesOf(file);
            const bool isOneOfThem =
                std::ranges::any_of(files_, [&](const fs::path& sent) { return bytesOf(sent) == bytes; });
            ASSERT_TRUE(isOneOfThem) << "a part of a file";
        }
        // The next one begins anew now and then, so that all states are met.
        if (round % 7 == 0) fs::remove_all(study->folder());
    }
}

}  // namespace

}  // namespace macula::study
