#include "viewer/volume/study_loader.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>
#include <optional>
#include <thread>
#include <vector>

#include "base/paths.h"
#include "base/phantom.h"
#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "viewer/jobs/newest_posted.h"
#include "viewer/wait_until.h"

namespace macula::viewer {
namespace {

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
    QObject::connect(&loader, &StudyLoader::loaded, &loader, [&](const study::OpenedStudy& study) {
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
    QObject::connect(&loader, &StudyLoader::loaded, &loader, [&](const study::OpenedStudy&) { ++outcomes; });
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
    EXPECT_LT(sinceCancelled.elapsed(), 30'000);
    // The next load is not disturbed by what is left of the one before.
    loader.open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return outcomes > 0; }));
    EXPECT_EQ(outcomes, 1);
}

TEST_F(StudyLoaderTest, ANewLoadReplacesTheOneBefore) {
    StudyLoader loader;
    int failures = 0;
    std::shared_ptr<const Volume> volume;
    QObject::connect(&loader, &StudyLoader::failed, &loader, [&](const Error&) { ++failures; });
    QObject::connect(&loader, &StudyLoader::loaded, &loader,
                     [&](const study::OpenedStudy& study) { volume = study.volume; });
    loader.open("/no/such/folder");
    loader.open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return volume != nullptr; }));
    EXPECT_EQ(failures, 0);
}

TEST_F(StudyLoaderTest, MayBeDestroyedWhileLoading) {
    StudyLoader loader;
    loader.open(std::nullopt);
}

TEST_F(StudyLoaderTest, TellsOfTheWholeFolderBeforeTheVolumeIsThere) {
    const dicom::test::TemporaryFolder folder;
    dicom::test::write(dicom::test::smallVolume(), folder.path());
    StudyLoader loader;
    std::vector<std::shared_ptr<const study::FoundVolumes>> found;
    std::shared_ptr<const study::FoundVolumes> ofStudy;
    QObject::connect(&loader, &StudyLoader::found, &loader,
                     [&](const std::shared_ptr<const study::FoundVolumes>& f) {
                         EXPECT_EQ(ofStudy, nullptr);
                         found.push_back(f);
                     });
    QObject::connect(&loader, &StudyLoader::loaded, &loader,
                     [&](const study::OpenedStudy& study) { ofStudy = study.found; });
    loader.open(folder.path());
    EXPECT_EQ(loader.source(), folder.path());
    ASSERT_TRUE(waitUntil([&] { return ofStudy != nullptr; }));
    ASSERT_FALSE(found.empty());
    for (std::size_t i = 0; i + 1 < found.size(); ++i) EXPECT_FALSE(found[i]->isWhole());
    EXPECT_TRUE(found.back()->isWhole());
    EXPECT_EQ(found.back(), ofStudy);

    loader.open(study::PhaseSource{.found = ofStudy}, 0);
    EXPECT_FALSE(loader.source());
}

// A list of a large folder takes longer than the time between two glimpses of it.
TEST_F(StudyLoaderTest, ABusyThreadIsGivenTheNewestOnly) {
    QObject home;
    std::vector<int> taken;
    const NewestPosted<int> post(&home, [&](int value) { taken.push_back(value); });
    std::thread([&] {
        for (int value = 1; value <= 100; ++value) post(value);
    }).join();
    QCoreApplication::processEvents();
    EXPECT_EQ(taken, std::vector<int>{100});
    post(101);
    QCoreApplication::processEvents();
    EXPECT_EQ(taken, (std::vector<int>{100, 101}));
}

}  // namespace
}  // namespace macula::viewer
