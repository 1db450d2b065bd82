#include "viewer/loader_job.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QThread>
#include <filesystem>
#include <fstream>

#include "base/paths.h"
#include "base/phantom.h"

namespace macula::viewer {
namespace {

// Runs the event loop until `done` or a minute has passed.
template <class Done>
bool waitUntil(Done done) {
    QElapsedTimer waited;
    waited.start();
    while (!done()) {
        if (waited.elapsed() > 60'000) return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    return true;
}

class StudyLoaderTest : public testing::Test {
  protected:
    StudyLoaderTest() : application_(argc_, argv_) {}

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    QCoreApplication application_;
};

TEST_F(StudyLoaderTest, DeliversThePhantomOnTheThreadThatAsked) {
    StudyLoader loader;
    std::shared_ptr<const Volume> volume;
    QObject::connect(&loader, &StudyLoader::loaded, &loader, [&](const LoadedStudy& study) {
        EXPECT_EQ(QThread::currentThread(), application_.thread());
        volume = study.volume;
    });
    loader.open(std::nullopt);
    EXPECT_TRUE(loader.loading());
    ASSERT_TRUE(waitUntil([&] { return volume != nullptr; }));
    EXPECT_FALSE(loader.loading());
    EXPECT_EQ(volume->size(), phantom::Options{}.size);
}

TEST_F(StudyLoaderTest, AMissingFolderIsAnErrorWithAHint) {
    StudyLoader loader;
    std::optional<Error> error;
    QObject::connect(&loader, &StudyLoader::failed, &loader, [&](const Error& e) { error = e; });
    loader.open("/no/such/folder");
    ASSERT_TRUE(waitUntil([&] { return error.has_value(); }));
    EXPECT_EQ(error->code, ErrorCode::inputNotUsable);
    EXPECT_FALSE(error->message.empty());
    EXPECT_FALSE(error->hint.empty());
}

TEST_F(StudyLoaderTest, CancelEndsTheLoadAndNothingIsDelivered) {
    StudyLoader loader;
    int outcomes = 0;
    bool cancelled = false;
    QObject::connect(&loader, &StudyLoader::loaded, &loader, [&](const LoadedStudy&) { ++outcomes; });
    QObject::connect(&loader, &StudyLoader::failed, &loader, [&](const Error&) { ++outcomes; });
    QObject::connect(&loader, &StudyLoader::cancelled, &loader, [&] { cancelled = true; });
    loader.open(macula::test::sharedFolder() / "data");
    loader.cancel();
    EXPECT_TRUE(cancelled);
    EXPECT_FALSE(loader.loading());
    // The worker notices, and long before it would have been through.
    QElapsedTimer sinceCancelled;
    sinceCancelled.start();
    ASSERT_TRUE(waitUntil([&] { return loader.atRest(); }));
    EXPECT_LT(sinceCancelled.elapsed(), 5000);
    // The next load is not disturbed by what is left of the one before.
    loader.open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return outcomes > 0; }));
    EXPECT_EQ(outcomes, 1);
}

TEST(LoadStudy, GivesUpWhereverItIsCancelled) {
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
        const auto study = loadStudy(folder, progress);
        EXPECT_TRUE(reached) << stage;
        ASSERT_FALSE(study.ok()) << stage;
        EXPECT_EQ(study.error().code, ErrorCode::cancelled) << stage;
    }
}

// Two patients in one folder: the best series is the CT, but who opens a file of the other one means that.
class FileInAFolderOfTwo : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(folder_.isValid());
        root_ = folder_.path().toStdString();
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
        const auto study = loadStudy(source, progress);
        return study ? study->volume->modality() : study.error().message;
    }

    QTemporaryDir folder_;
    std::filesystem::path root_;
};

TEST_F(FileInAFolderOfTwo, ItsOwnSeriesIsOpened) {
    EXPECT_EQ(modalityOf(root_), "CT");
    EXPECT_EQ(modalityOf(root_ / "mr_head_sag_hfs0"), "MR");
    EXPECT_EQ(modalityOf(root_ / "ct_cta_rider0"), "CT");
    Progress progress;
    const auto study = loadStudy(root_ / "mr_head_sag_hfs0", progress);
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
    const auto study = loadStudy(root_ / "notes.txt", progress);
    ASSERT_FALSE(study.ok());
    EXPECT_EQ(study.error().code, ErrorCode::inputNotUsable);
    EXPECT_FALSE(study.error().hint.empty());
}

TEST(LoadStudy, OpensAVolumeFileAndNamesNobody) {
    const std::filesystem::path file =
        macula::test::sharedFolder() / "data/odd/mixed_flat_folder_truth_mr.nii.gz";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "shared data is not here";
    Progress progress;
    const auto study = loadStudy(file, progress);
    ASSERT_TRUE(study.ok()) << study.error().message;
    EXPECT_EQ(study->volume->size(), glm::ivec3(115, 90, 35));
    EXPECT_EQ(study->identity.series, "File mixed_flat_folder_truth_mr.nii.gz");
    EXPECT_TRUE(study->identity.patientName.empty());
    EXPECT_FALSE(study->identity.isOfNobody);
    EXPECT_TRUE(study->volumeTitles.empty());
}

TEST(LoadStudy, ADicomdirStandsForItsFolder) {
    const std::filesystem::path folder = macula::test::sharedFolder() / "data/odd/dicomdir_media";
    if (!std::filesystem::exists(folder / "DICOMDIR")) GTEST_SKIP() << "shared data is not here";
    Progress progress;
    const auto ofFolder = loadStudy(folder, progress);
    const auto ofFile = loadStudy(folder / "DICOMDIR", progress);
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
    const auto study = loadStudy(root_, progress);
    ASSERT_TRUE(study.ok());
    ASSERT_EQ(study->volumeTitles.size(), 2u);
    EXPECT_NE(study->volumeTitles[0], study->volumeTitles[1]);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto other = loadFoundVolume(study->found, i, progress);
        ASSERT_TRUE(other.ok());
        EXPECT_EQ(other->volumeIndex, i);
        const std::vector<std::string> lines = linesOf(other->identity);
        EXPECT_NE(study->volumeTitles[i].find(lines[0]), std::string::npos) << study->volumeTitles[i];
        EXPECT_NE(study->volumeTitles[i].find(lines[3]), std::string::npos) << study->volumeTitles[i];
        EXPECT_EQ(other->volume->modality(), lines[3].substr(0, 2));
    }
}

TEST_F(StudyLoaderTest, ANewLoadReplacesTheOneBefore) {
    StudyLoader loader;
    int failures = 0;
    std::shared_ptr<const Volume> volume;
    QObject::connect(&loader, &StudyLoader::failed, &loader, [&](const Error&) { ++failures; });
    QObject::connect(&loader, &StudyLoader::loaded, &loader,
                     [&](const LoadedStudy& study) { volume = study.volume; });
    loader.open("/no/such/folder");
    loader.open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return volume != nullptr; }));
    EXPECT_EQ(failures, 0);
}

TEST_F(StudyLoaderTest, MayBeDestroyedWhileLoading) {
    StudyLoader loader;
    loader.open(std::nullopt);
}

}  // namespace
}  // namespace macula::viewer
