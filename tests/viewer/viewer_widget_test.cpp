// The volume as a widget by itself, in this process and in the window of another program.
#include "viewer/volume/viewer_widget.h"  // before Qt, see vulkan_window.h

#include <gtest/gtest.h>

#include <QApplication>
#include <QProcess>
#include <QScreen>
#include <QSet>

#include "viewer/slices/slice_view.h"
#include "viewer/volume/study_loader.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class ViewerWidgetTest : public testing::Test {
  protected:
    void SetUp() override {
        if (const std::string why = test::ensureDisplay(); !why.empty()) GTEST_SKIP() << why;
        application_.emplace(argc_, argv_);
        auto catalogue = scene::builtInCatalogue();
        ASSERT_TRUE(catalogue.ok());
        session_.emplace(*std::move(catalogue));
    }
    void TearDown() override {
        session_.reset();
        application_.reset();
    }
    // With a device of its own.
    std::unique_ptr<ViewerWidget> makeWidget() {
        auto instance = createInstanceForWindows();
        if (!instance) {
            ADD_FAILURE() << instance.error().message;
            return nullptr;
        }
        auto widget = std::make_unique<ViewerWidget>(*session_, *std::move(instance));
        widget->viewport().setUsesModel(false);
        widget->viewport().setSampleLimit(2);
        QObject::connect(widget.get(), &ViewerWidget::frameShown, widget.get(),
                         [this](const live::FrameShown& frame) { last_ = frame; });
        widget->resize(200, 160);
        widget->show();
        return widget;
    }
    void openPhantom() {
        StudyLoader loader;
        QObject::connect(&loader, &StudyLoader::loaded, &loader,
                         [this](const study::OpenedStudy& study) { session_->show(study); });
        loader.open(std::nullopt);
        ASSERT_TRUE(waitUntil([&] { return session_->hasStudy(); }));
    }
    bool waitForConverged() {
        last_.reset();
        return waitUntil([&] { return last_ && last_->stage == live::Stage::converged; });
    }

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    std::optional<QApplication> application_;
    std::optional<StudyEditor> session_;
    std::optional<live::FrameShown> last_;
};

TEST_F(ViewerWidgetTest, ShowsWhatPanelsChooseAndItsStateComesBackAsText) {
    const auto widget = makeWidget();
    ASSERT_NE(widget, nullptr);
    EXPECT_FALSE(widget->setState({}).ok()) << "no study is open";
    openPhantom();
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(last_->look, trace::Look::cinematic);

    // Another panel chooses a look; the host turns the camera.
    session_->change(QStringLiteral("Look"),
                     [](scene::StudyState& next) { next.settings.look = trace::Look::mip; });
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(last_->look, trace::Look::mip);
    widget->viewport().showFrom(ViewDirection::left);
    ASSERT_TRUE(waitForConverged());

    const std::string text = toJson(widget->state());
    const Camera camera = toCamera(widget->viewport().camera());
    session_->undo();
    widget->viewport().showFrom(ViewDirection::superior);
    EXPECT_NE(toJson(widget->state()), text);

    const auto read = scene::studyStateFromJson(text, {});
    ASSERT_TRUE(read.ok());
    ASSERT_TRUE(widget->setState(*read).ok());
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(last_->look, trace::Look::mip);
    EXPECT_LT(glm::distance(toCamera(widget->viewport().camera()).positionMm, camera.positionMm), 1e-6);

    scene::StudyState ofAnother = *read;
    ofAnother.seriesDigest = std::string(64, '0');
    EXPECT_FALSE(widget->setState(ofAnother).ok());
}

TEST_F(ViewerWidgetTest, IsMadeForAStudyThatIsOpenAndGoesBeforeItsSession) {
    openPhantom();
    {
        const auto widget = makeWidget();
        ASSERT_NE(widget, nullptr);
        EXPECT_TRUE(waitForConverged());
    }
    const auto another = makeWidget();
    ASSERT_NE(another, nullptr);
    EXPECT_TRUE(waitForConverged());
}

TEST_F(ViewerWidgetTest, AProgramOfSomebodyElseShowsAStudy) {
    // A picture of many colours at the left of the middle: the slice and the volume of the phantom have them,
    // and an empty window has not.
    const auto colours = [] {
        const QImage seen = QGuiApplication::primaryScreen()->grabWindow(0, 400, 100, 400, 300).toImage();
        QSet<QRgb> all;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x) all.insert(seen.pixel(x, y));
        return all.size();
    };
    ASSERT_LT(colours(), 50) << "something else is on the display: nothing would be shown by this";
    QProcess host;
    host.setProgram(QStringLiteral(MACULA_HOST_PROGRAM));
    host.start();
    ASSERT_TRUE(host.waitForStarted());
    EXPECT_TRUE(waitUntil([&] { return host.state() != QProcess::Running || colours() > 200; }));
    EXPECT_EQ(host.state(), QProcess::Running) << host.readAllStandardError().toStdString();
    host.terminate();
    EXPECT_TRUE(host.waitForFinished());
}

}  // namespace
}  // namespace macula::viewer
