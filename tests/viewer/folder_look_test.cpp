// A watched folder is looked at on a thread that nobody waits for.
#include "viewer/watch/folder_look.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support.h"
#include "synthetic.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr WatchPace kQuickly{.every = 10ms, .quiet = 100ms};

class FolderLookTest : public test::OffscreenTest {
  protected:
    QString path() const { return QString::fromStdString((folder_ / "incoming").string()); }

    dicom::test::TemporaryFolder folder_;
};

TEST_F(FolderLookTest, AStudyThatComesIsToldOnce) {
    fs::create_directory(folder_ / "incoming");
    FolderLook look(path(), kQuickly, nullptr);
    std::vector<study::ArrivedStudy> came;
    QObject::connect(&look, &FolderLook::arrived,
                     [&](const study::ArrivedStudy& study) { came.push_back(study); });
    ASSERT_TRUE(waitUntil([&] { return look.looks() > 0; }));
    const dicom::test::SyntheticSeries series;
    dicom::test::writeFiles(folder_ / "incoming" / "study", series);
    ASSERT_TRUE(waitUntil([&] { return !came.empty(); }));
    EXPECT_EQ(came[0].images, std::size_t(series.size.z));
    const std::size_t looks = look.looks();
    ASSERT_TRUE(waitUntil([&] { return look.looks() > looks + 5; }));
    EXPECT_EQ(came.size(), 1u);
}

TEST_F(FolderLookTest, AFolderThatIsNotThereIsSaidSoUntilItIs) {
    FolderLook look(path(), kQuickly, nullptr);
    int changes = 0;
    QObject::connect(&look, &FolderLook::absenceChanged, [&] { ++changes; });
    ASSERT_TRUE(waitUntil([&] { return look.isAbsent(); }));
    fs::create_directory(folder_ / "incoming");
    ASSERT_TRUE(waitUntil([&] { return !look.isAbsent(); }));
    EXPECT_EQ(changes, 2);
}

TEST_F(FolderLookTest, MayEndAtAnyMoment) {
    const dicom::test::SyntheticSeries series;
    dicom::test::writeFiles(folder_ / "incoming", series);
    for (int i = 0; i < 50; ++i) {
        FolderLook look(path(), {.every = 0ms, .quiet = 0ms}, nullptr);
        const std::size_t looks = std::size_t(i) % 3;
        ASSERT_TRUE(waitUntil([&] { return look.looks() >= looks; }));
        settle();
    }
}

}  // namespace
}  // namespace macula::viewer
