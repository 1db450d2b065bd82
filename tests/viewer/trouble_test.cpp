// What goes wrong outside of the window while somebody works in it: a sentence each, and the rest goes on.
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>

#include <QAction>
#include <QSpinBox>
#include <QTemporaryDir>
#include <csignal>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "scene/drawing/drawing_of.h"
#include "viewer/browser/study_browser.h"
#include "viewer/output/pictures_controller.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class TroubleTest : public WindowTest {
  protected:
    std::string fileOf(const char* name) { return folder_.filePath(QString::fromLatin1(name)).toStdString(); }
    // Another picture comes when somebody turns the volume.
    void expectThatItGoesOn() {
        pressKey(Qt::Key_Left);
        EXPECT_TRUE(waitForConverged());
        EXPECT_FALSE(window_->loading());
    }

    QTemporaryDir folder_;
    scene::SeriesWindows windows_;
};

TEST_F(TroubleTest, WithoutAHeadsetASentenceIsSaidOnceAndTheWindowGoesOn) {
    setenv("XR_RUNTIME_JSON", "/nonexistent/runtime.json", 1);
    showsInHeadset_ = true;  // macula-viewer --xr
    makeWindow();
    int ended = 0;
    QObject::connect(&*window_, &MainWindow::headsetEnded, &*window_, [&ended] { ++ended; });
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return ended == 1; }));
    EXPECT_TRUE(window_->hasStudy());
    EXPECT_FALSE(window_->message().isEmpty());
    const scene::StudyState before = window_->state();
    expectThatItGoesOn();
    // It can be tried again, and nothing that was chosen is lost.
    auto* again = window_->findChild<QAction*>(QStringLiteral("show-in-headset"));
    ASSERT_TRUE(again);
    again->trigger();
    ASSERT_TRUE(waitUntil([&] { return ended == 2; }));
    EXPECT_FALSE(window_->message().isEmpty());
    EXPECT_EQ(window_->state().preset, before.preset);
    window_->open(std::nullopt);  // another study begins no session
    ASSERT_TRUE(waitUntil([&] { return !window_->loading(); }));
    EXPECT_EQ(ended, 2);
    unsetenv("XR_RUNTIME_JSON");
}

TEST_F(TroubleTest, AFolderThatVanishesIsToldAndTheStudyOnScreenStays) {
    const std::filesystem::path folder = fileOf("export");
    dicom::test::write(dicom::test::smallVolume(), folder / "first", {.seriesNumber = 1});
    dicom::test::write(dicom::test::smallVolume(), folder / "second", {.seriesNumber = 2});
    window_->open(folder);
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy() && !window_->loading(); }));
    ASSERT_EQ(window_->session().study().found->volumes().size(), 2u);
    const std::size_t shown = window_->session().study().volumeIndex;
    const auto volume = window_->session().study().volume;

    std::filesystem::remove_all(folder);
    Q_EMIT window_->findChild<StudyBrowser*>()->chosen(1 - shown);
    ASSERT_TRUE(waitUntil([&] { return !window_->loading() && !window_->message().isEmpty(); }));
    EXPECT_TRUE(window_->message().contains(QLatin1String("still of the study")))
        << window_->message().toStdString();
    EXPECT_EQ(window_->session().study().volume, volume);
    EXPECT_EQ(window_->session().study().volumeIndex, shown);
    expectThatItGoesOn();

    window_->open(folder);  // and all of it
    ASSERT_TRUE(waitUntil([&] { return !window_->loading(); }));
    EXPECT_TRUE(window_->message().contains(QLatin1String("does not exist")))
        << window_->message().toStdString();
    EXPECT_EQ(window_->findChild<StudyBrowser*>()->found(), window_->session().study().found);
    expectThatItGoesOn();
}

// While it lives this process writes no file of more than so many bytes: as on a disk that is full.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) : before_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &limit_);
        const rlimit small{.rlim_cur = bytes, .rlim_max = limit_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &limit_);
        std::signal(SIGXFSZ, before_);
    }

  private:
    void (*before_)(int);
    rlimit limit_{};
};

TEST_F(TroubleTest, AFullDiskAtAnExportLeavesNoFileAndIsTold) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    auto* exporter = window_->findChild<PictureExport*>();
    ASSERT_NE(exporter, nullptr);
    const std::string file = fileOf("picture.exr");
    const StudyEditor& session = window_->session();
    const pictures::ViewPicture picture{
        .volume = session.study().volume,
        .seriesDigest = session.study().seriesDigest,
        .drawing =
            scene::drawingOf(session.state(), session.catalogue(), windows_, session.study().volume, nullptr),
        .camera = *window_->state().camera,
        .sizePx = {64, 64},
        .effort = {},
        .output = file,
        .isOfNobody = true};
    {
        const FullDisk full(1000);
        exporter->start(picture);
        ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty(); }));
    }
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path().toStdString()),
                            std::filesystem::directory_iterator()),
              0)
        << "something half written is left";
    expectThatItGoesOn();
}

TEST_F(TroubleTest, SessionsThatAnotherProgramHoldsAreToldAndTheWindowIsAsWithoutThem) {
    window_.reset();
    sessions_ = fileOf("sessions");
    makeWindow();
    window_.reset();  // now there is a database
    sqlite3* other = nullptr;
    ASSERT_EQ(sqlite3_open((*sessions_ / "sessions.db").c_str(), &other), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(other, "BEGIN EXCLUSIVE", nullptr, nullptr, nullptr), SQLITE_OK);
    makeWindow();
    window_->open(std::nullopt);
    EXPECT_TRUE(waitUntil([&] { return window_->notes().contains(QLatin1String("in use by another")); }))
        << window_->notes().toStdString();
    expectThatItGoesOn();
    EXPECT_EQ(sqlite3_close(other), SQLITE_OK);  // and rolls back
}

}  // namespace
}  // namespace macula::viewer
