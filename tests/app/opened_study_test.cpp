#include "app/study/opened_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/study/found_volumes.h"
#include "base/paths.h"
#include "base/phantom.h"
#include "dicom/support.h"

namespace macula::app {
namespace {

TEST(OpenStudy, GivesUpWhereverItIsCancelled) {
    const std::filesystem::path folder = macula::test::sharedFolder() / "data/ct_cta_rider";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "shared data is not here";
    // At the first word of each stage of the work: what is left of it must not be done.
    for (const char* stage : {"Reading", "Decoding"}) {
        const CancelToken token;
        bool reached = false;
        Progress progress(
            [&](const ProgressUpdate& update) {
                if (update.stage.find(stage) == std::string::npos) return;
                reached = true;
                token.cancel();
            },
            token);
        const auto study = openStudy(folder, progress);
        EXPECT_TRUE(reached) << stage;
        ASSERT_FALSE(study.ok()) << stage;
        EXPECT_EQ(study.error().code, ErrorCode::cancelled) << stage;
    }
}

// Some things are said of a series, of its stack and of its volume.
TEST(OpenStudy, TellsNothingTwice) {
    const std::filesystem::path folder = macula::test::sharedFolder() / "data/odd/dicomdir_media";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "shared data is not here";
    Progress progress;
    const auto study = openStudy(folder, progress);
    ASSERT_TRUE(study.ok()) << study.error().message;
    std::vector<std::string> messages = study->messages;
    EXPECT_FALSE(messages.empty());
    std::ranges::sort(messages);
    EXPECT_EQ(std::ranges::adjacent_find(messages), messages.end());
}

// Two patients in one folder: the best series is the CT, but who opens a file of the other one means that.
class FileInAFolderOfTwo : public testing::Test {
  protected:
    void SetUp() override {
        root_ = folder_.path();
        const std::filesystem::path data = macula::test::sharedFolder() / "data";
        if (!std::filesystem::exists(data)) GTEST_SKIP() << "shared data is not here";
        for (const char* name : {"ct_cta_rider", "mr_head_sag_hfs"}) {
            int index = 0;
            for (const auto& entry : std::filesystem::recursive_directory_iterator(data / name)) {
                if (!entry.is_regular_file()) continue;
                std::string copy = name;
                copy += std::to_string(index++);
                std::filesystem::copy_file(entry.path(), root_ / copy);
            }
        }
    }
    static std::string modalityOf(const std::filesystem::path& source) {
        Progress progress;
        const auto study = openStudy(source, progress);
        return study ? study->volume->modality() : study.error().message;
    }

    dicom::test::TemporaryFolder folder_;
    std::filesystem::path root_;
};

TEST_F(FileInAFolderOfTwo, ItsOwnSeriesIsOpened) {
    EXPECT_EQ(modalityOf(root_), "CT");
    EXPECT_EQ(modalityOf(root_ / "mr_head_sag_hfs0"), "MR");
    EXPECT_EQ(modalityOf(root_ / "ct_cta_rider0"), "CT");
    Progress progress;
    const auto study = openStudy(root_ / "mr_head_sag_hfs0", progress);
    ASSERT_TRUE(study.ok());
    EXPECT_FALSE(study->whyThisSeries.empty());
}

TEST_F(FileInAFolderOfTwo, ARelativeNameWithoutAFolderWorks) {
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(root_);
    const std::string modality = modalityOf("mr_head_sag_hfs0");
    std::filesystem::current_path(before);
    EXPECT_EQ(modality, "MR");
}

TEST_F(FileInAFolderOfTwo, AFileThatIsNoImageOpensNothing) {
    std::ofstream(root_ / "notes.txt") << "not DICOM";
    Progress progress;
    const auto study = openStudy(root_ / "notes.txt", progress);
    ASSERT_FALSE(study.ok());
    EXPECT_EQ(study.error().code, ErrorCode::inputNotUsable);
    EXPECT_FALSE(study.error().hint.empty());
}

TEST(OpenStudy, OpensAVolumeFileAndNamesNobody) {
    const std::filesystem::path file =
        macula::test::sharedFolder() / "data/odd/mixed_flat_folder_truth_mr.nii.gz";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "shared data is not here";
    Progress progress;
    const auto study = openStudy(file, progress);
    ASSERT_TRUE(study.ok()) << study.error().message;
    EXPECT_EQ(study->volume->size(), glm::ivec3(115, 90, 35));
    EXPECT_EQ(study->identity.series, "File mixed_flat_folder_truth_mr.nii.gz");
    EXPECT_TRUE(study->identity.patientName.empty());
    EXPECT_FALSE(study->identity.isOfNobody);
    EXPECT_TRUE(study->volumeTitles.empty());
}

TEST(OpenStudy, ADicomdirStandsForItsFolder) {
    const std::filesystem::path folder = macula::test::sharedFolder() / "data/odd/dicomdir_media";
    if (!std::filesystem::exists(folder / "DICOMDIR")) GTEST_SKIP() << "shared data is not here";
    Progress progress;
    const auto ofFolder = openStudy(folder, progress);
    const auto ofFile = openStudy(folder / "DICOMDIR", progress);
    ASSERT_EQ(ofFile.ok(), ofFolder.ok());
    if (ofFile.ok()) {
        EXPECT_EQ(ofFile->identity, ofFolder->identity);
        EXPECT_EQ(ofFile->volumeTitles, ofFolder->volumeTitles);
    } else {
        EXPECT_EQ(ofFile.error().message, ofFolder.error().message);
    }
}

TEST_F(FileInAFolderOfTwo, EachVolumeIsListedWithItsPatient) {
    Progress progress;
    const auto study = openStudy(root_, progress);
    ASSERT_TRUE(study.ok());
    ASSERT_EQ(study->volumeTitles.size(), 2u);
    EXPECT_NE(study->volumeTitles[0], study->volumeTitles[1]);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto other = openFoundVolume(study->found, i, progress);
        ASSERT_TRUE(other.ok());
        EXPECT_EQ(other->volumeIndex, i);
        const std::vector<std::string> lines = linesOf(other->identity);
        EXPECT_NE(study->volumeTitles[i].find(lines[0]), std::string::npos) << study->volumeTitles[i];
        EXPECT_NE(study->volumeTitles[i].find(lines[3]), std::string::npos) << study->volumeTitles[i];
        EXPECT_EQ(other->volume->modality(), lines[3].substr(0, 2));
    }
}

}  // namespace
}  // namespace macula::app
