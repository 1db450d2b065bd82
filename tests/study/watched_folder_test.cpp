// What appears in a folder is told once it is whole; what was there, or still grows, is not.
#include "study/watch/watched_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "dicom/support.h"
#include "dicom/synthetic.h"

namespace macula::study {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class WatchedFolderTest : public ::testing::Test {
  protected:
    // The studies that are told after so much time of the test's own clock.
    std::vector<ArrivedStudy> after(std::chrono::milliseconds time) {
        now_ += time;
        Progress progress;
        const auto looked = watched_.look(now_, progress);
        EXPECT_TRUE(looked) << looked.error().message;
        return looked ? *looked : std::vector<ArrivedStudy>();
    }
    static std::string bytesOf(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    dicom::test::TemporaryFolder outside_;
    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    WatchedFolder::Clock::time_point now_ = WatchedFolder::Clock::now();
    WatchedFolder watched_{folder_.path(), 6s};
};

TEST_F(WatchedFolderTest, WhatIsThereIsKnownAndWhatComesIsToldOnceItIsQuiet) {
    dicom::test::writeFiles(folder_ / "before", series_);
    EXPECT_TRUE(after(0s).empty());
    EXPECT_TRUE(after(60s).empty());
    series_.studyUid = "2.25.77";
    dicom::test::writeFiles(folder_ / "after", series_);
    EXPECT_TRUE(after(1s).empty());
    EXPECT_TRUE(after(5s).empty()) << "too early";
    const auto arrived = after(1s);
    ASSERT_EQ(arrived.size(), 1u);
    EXPECT_EQ(arrived[0].identity.studyInstanceUid, "2.25.77");
    EXPECT_EQ(arrived[0].identity.patientName, "SYNTHETIC^ONE");
    EXPECT_EQ(arrived[0].images, std::size_t(series_.size.z));
    EXPECT_EQ(arrived[0].modalities, std::set<std::string>{"CT"});
    EXPECT_EQ(arrived[0].folder, folder_.path());
    EXPECT_EQ(arrived[0].file.parent_path(), folder_ / "after");
    EXPECT_TRUE(after(60s).empty()) << "once";
}

TEST_F(WatchedFolderTest, AStudyThatStillComesWaits) {
    const auto files = dicom::test::writeFiles(outside_.path(), series_);
    EXPECT_TRUE(after(0s).empty());
    for (const fs::path& file : files) {
        fs::copy_file(file, folder_ / file.filename().string());
        EXPECT_TRUE(after(4s).empty()) << "each new image begins the wait again";
    }
    const auto arrived = after(6s);
    ASSERT_EQ(arrived.size(), 1u);
    EXPECT_EQ(arrived[0].images, files.size());
}

TEST_F(WatchedFolderTest, AFileIsNotReadWhileItGrows) {
    const auto files = dicom::test::writeFiles(outside_.path(), series_);
    const std::string whole = bytesOf(files[0]);
    EXPECT_TRUE(after(0s).empty());
    for (std::size_t i = 1; i < files.size(); ++i)
        fs::copy_file(files[i], folder_ / files[i].filename().string());
    for (std::size_t part = 1; part <= 4; ++part) {
        std::ofstream(folder_ / "growing", std::ios::binary) << whole.substr(0, part * whole.size() / 8);
        EXPECT_TRUE(after(4s).empty()) << part;
    }
    EXPECT_TRUE(after(8s).empty()) << "quiet, but cut off: a share may be slow";
    std::ofstream(folder_ / "growing", std::ios::binary) << whole;
    EXPECT_TRUE(after(1s).empty());
    const auto arrived = after(6s);
    ASSERT_EQ(arrived.size(), 1u);
    EXPECT_EQ(arrived[0].images, files.size());
}

TEST_F(WatchedFolderTest, AFileThatStaysCutOffDoesNotHoldAStudyForEver) {
    const auto files = dicom::test::writeFiles(outside_.path(), series_);
    EXPECT_TRUE(after(0s).empty());
    for (const fs::path& file : files) fs::copy_file(file, folder_ / file.filename().string());
    fs::resize_file(folder_ / files[0].filename().string(), fs::file_size(files[0]) - 8);
    EXPECT_TRUE(after(1s).empty());
    EXPECT_TRUE(after(30s).empty());
    EXPECT_EQ(after(60s).size(), 1u);
}

TEST_F(WatchedFolderTest, StudiesAreToldApartAndOthersAreNoStudies) {
    EXPECT_TRUE(after(0s).empty());
    std::ofstream(folder_ / "report.txt") << "no image";
    dicom::test::Shell report{.sopClassUid = "1.2.840.10008.5.1.4.1.1.88.11", .modality = "SR"};
    dicom::test::writeShell(folder_ / "report.dcm", report);
    for (const char* uid : {"2.25.78", "2.25.79"}) {
        series_.studyUid = uid;
        dicom::test::writeFiles(folder_ / uid, series_);
    }
    after(1s);
    EXPECT_EQ(after(7s).size(), 2u) << "a report alone opens nothing";
}

TEST_F(WatchedFolderTest, MoreOfAStudyIsToldAgain) {
    const auto files = dicom::test::writeFiles(outside_.path(), series_);
    EXPECT_TRUE(after(0s).empty());
    fs::copy_file(files[0], folder_ / "a");
    after(1s);
    EXPECT_EQ(after(6s).size(), 1u);
    fs::copy_file(files[1], folder_ / "b");
    after(1s);
    const auto more = after(6s);
    ASSERT_EQ(more.size(), 1u);
    EXPECT_EQ(more[0].images, 1u);
}

TEST_F(WatchedFolderTest, AShareThatIsUnmountedAndComesBackIsNotNew) {
    const fs::path share = folder_ / "share";
    WatchedFolder watched(share, 6s);
    Progress progress;
    EXPECT_FALSE(watched.look(now_, progress)) << "not there";
    dicom::test::writeFiles(share, series_);
    const auto look = [&](std::chrono::seconds at) {
        auto looked = watched.look(now_ + at, progress);
        EXPECT_TRUE(looked);
        return looked ? looked->size() : 99u;
    };
    EXPECT_EQ(look(1s), 0u);
    EXPECT_EQ(look(20s), 0u) << "it was there when the folder was";
    fs::rename(share, folder_ / "away");
    EXPECT_FALSE(watched.look(now_ + 21s, progress));
    fs::create_directory(share);
    EXPECT_EQ(look(22s), 0u);
    fs::remove(share);
    fs::rename(folder_ / "away", share);
    EXPECT_EQ(look(23s), 0u);
    EXPECT_EQ(look(60s), 0u);
    series_.studyUid = "2.25.80";
    dicom::test::writeFiles(share / "new", series_);
    EXPECT_EQ(look(61s), 0u);
    EXPECT_EQ(look(68s), 1u);
}

TEST_F(WatchedFolderTest, ACancelledLookLosesNothing) {
    EXPECT_TRUE(after(0s).empty());
    dicom::test::writeFiles(folder_ / "new", series_);
    after(1s);
    CancelToken token;
    token.cancel();
    Progress cancelled({}, token);
    static_cast<void>(watched_.look(now_ + 7s, cancelled));
    EXPECT_EQ(after(8s).size(), 1u);
}

}  // namespace
}  // namespace macula::study
