// The window on a display, in this process.
#include <gtest/gtest.h>

#include <QAction>
#include <QDropEvent>
#include <QMimeData>
#include <QStatusBar>
#include <QUrl>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

#include "base/paths.h"
#include "base/phantom.h"
#include "support.h"
#include "viewer/quality/quality_controller.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

TEST_F(WindowTest, ThePhantomConvergesThenStopsAndStartsAgainWhenDragged) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_EQ(last_->samplesPerPixel, 2u);
    EXPECT_EQ(last_->width, window_->viewport().pictureSize().width());
    EXPECT_EQ(last_->scale, 1);
    EXPECT_EQ(window_->fidelity().contains(QStringLiteral("denoised")), last_->denoised);

    // Nothing moves, nothing is drawn.
    const int before = frames_;
    QElapsedTimer idle;
    idle.start();
    waitUntil([&] { return idle.elapsed() > 500; });
    EXPECT_EQ(frames_, before);

    const scene::OrbitCamera camera = window_->viewport().camera();
    sendMouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton);
    sendMouse(QEvent::MouseMove, {160, 120}, Qt::NoButton, Qt::LeftButton);
    EXPECT_NE(window_->viewport().camera().azimuthDeg, camera.azimuthDeg);
    ASSERT_TRUE(waitUntil([&] { return frames_ > before; }));
    EXPECT_EQ(last_->stage, live::Stage::moving);
    EXPECT_EQ(last_->picture, live::OnScreen::preview);
    // As long as the hand holds on, no picture with all pixels begins.
    idle.restart();
    waitUntil([&] { return idle.elapsed() > 700; });
    EXPECT_EQ(last_->stage, live::Stage::moving);
    sendMouse(QEvent::MouseButtonRelease, {160, 120}, Qt::LeftButton, Qt::NoButton);
    EXPECT_TRUE(waitForConverged());
}

TEST_F(WindowTest, KeysMoveTheCameraAndPresetsStayUsable) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    Viewport& viewport = window_->viewport();
    pressKey(Qt::Key_L);
    EXPECT_NEAR(viewport.camera().azimuthDeg, 90.0, 1e-9);
    pressKey(Qt::Key_Right);
    EXPECT_NEAR(viewport.camera().azimuthDeg, 95.0, 1e-9);
    pressKey(Qt::Key_F);
    const glm::dvec3 target = viewport.camera().targetMm;
    const double distance = viewport.camera().distanceMm;
    pressKey(Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_GT(glm::distance(viewport.camera().targetMm, target), 1.0);
    pressKey(Qt::Key_Plus);
    EXPECT_LT(viewport.camera().distanceMm, distance);
    pressKey(Qt::Key_F);
    EXPECT_NEAR(glm::distance(viewport.camera().targetMm, target), 0.0, 1e-9);
    EXPECT_NEAR(viewport.camera().distanceMm, distance, 1e-9);
    EXPECT_NEAR(viewport.camera().azimuthDeg, 95.0, 1e-9);
    EXPECT_TRUE(waitForConverged());
}

// What fits is what is visible, not the box of the volume: it is looked at from nearer.
TEST_F(WindowTest, FitsWhatIsVisible) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    Viewport& viewport = window_->viewport();
    const auto corners = cornersOf(phantom::make().worldBox());
    const double aspect = double(viewport.window().width()) / viewport.window().height();
    const scene::OrbitCamera ofBox = scene::framed(corners, ViewDirection::anterior, 30.0, aspect);
    EXPECT_LT(viewport.camera().distanceMm, 0.99 * ofBox.distanceMm);
    EXPECT_EQ(viewport.camera().azimuthDeg, 0.0);
}

// What was chosen comes back from its text, camera and all; a view of another series is refused.
TEST_F(WindowTest, AViewComesBackAsItWas) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    scene::StudyState state = window_->state();
    EXPECT_EQ(state.seriesDigest, "phantom");
    state.settings.look = trace::Look::average;
    state.windows.at(std::size_t(trace::Look::average)) =
        DisplayWindow{.center = 40.0, .width = 400.0, .explanation = {}, .function = "LINEAR_EXACT"};
    state.camera->positionMm += glm::dvec3(100.0, 0.0, 50.0);
    const auto read = scene::studyStateFromJson(toJson(state), "view.json");
    ASSERT_TRUE(read.ok());
    ASSERT_TRUE(window_->setState(*read).ok());
    const scene::StudyState now = window_->state();
    EXPECT_LE(staleAfter(*read, now), scene::Stale::camera) << "whose last bits may differ";
    EXPECT_LT(glm::distance(now.camera->positionMm, state.camera->positionMm), 1e-6);

    scene::StudyState bright = state;
    bright.settings.exposure = 3.0;
    bright.leavesTableOut = true;
    ASSERT_TRUE(window_->setState(bright).ok());
    EXPECT_EQ(window_->state().settings.exposure, 3.0);

    scene::StudyState ofAnother = state;
    ofAnother.seriesDigest = "another";
    EXPECT_FALSE(window_->setState(ofAnother).ok());
    EXPECT_EQ(window_->state().settings.look, trace::Look::average);

    // How the next study is drawn nobody has chosen yet; how the window is arranged stays.
    window_->session().change(QStringLiteral("Panes"),
                              [](scene::StudyState& next) { next.layout = scene::Layout::coronal; });
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return window_->state().settings.exposure == 1.0; }));
    EXPECT_EQ(window_->state().settings.look, trace::Look::cinematic);
    EXPECT_EQ(window_->state().layout, scene::Layout::coronal);
    EXPECT_FALSE(window_->state().leavesTableOut);
    EXPECT_EQ(window_->state().windows.at(std::size_t(trace::Look::average)), std::nullopt);
}

// A device that is there at once leaves no word that it is being started.
TEST_F(WindowTest, WithoutAStudyItSaysSoOnceTheDeviceIsThere) {
    bool isReady = false;
    const auto listening = QObject::connect(
        &window_->viewport(), &Viewport::rendered, &*window_,
        [&](const live::RenderEvent& event) { isReady |= std::holds_alternative<live::DeviceReady>(event); });
    ASSERT_TRUE(waitUntil([&] { return isReady; }));
    QObject::disconnect(listening);
    QElapsedTimer since;
    since.start();
    waitUntil([&] { return since.elapsed() > 400; });
    EXPECT_EQ(window_->fidelity(), QStringLiteral("No study is open"));
}

// One that no menu has must not look like none, and must go when somebody says so.
TEST_F(WindowTest, AClipOfItsOwnGoesWithNoClip) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    auto* noClip = window_->findChild<QAction*>(QStringLiteral("no-clip"));
    ASSERT_NE(noClip, nullptr);
    EXPECT_TRUE(noClip->isChecked());
    scene::StudyState clipped = window_->state();
    clipped.clip = ClipPreset{.name = "own", .title = "Own", .clip = {}, .planesAt = {glm::dvec3(0.5)}};
    clipped.clip->clip.planes = {{glm::dvec3(1.0, 0.0, 0.0), 0.0}};
    ASSERT_TRUE(window_->setState(clipped).ok());
    EXPECT_TRUE(window_->hidesSomething());
    EXPECT_FALSE(noClip->isChecked());
    noClip->trigger();
    EXPECT_FALSE(window_->hidesSomething());
    EXPECT_TRUE(noClip->isChecked());
}

TEST_F(WindowTest, AMissingFolderIsToldInTheWindowAndTheStudyStays) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
    window_->open("/no/such/folder");
    ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty(); }));
    EXPECT_TRUE(window_->hasStudy());
    EXPECT_TRUE(waitForConverged());
}

TEST_F(WindowTest, LoadingCanBeCancelled) {
    const dicom::test::TemporaryFolder folder;
    dicom::test::write(dicom::test::smallVolume(), folder.path());
    int cancelled = 0;
    QObject::connect(&*window_, &MainWindow::loadingCancelled, &*window_, [&] { ++cancelled; });
    window_->open(folder.path());
    EXPECT_TRUE(window_->loading());
    window_->cancelLoading();
    EXPECT_TRUE(waitUntil([&] { return cancelled > 0; }));
    EXPECT_FALSE(window_->loading());
    ASSERT_TRUE(waitUntil([&] { return window_->loaderAtRest(); }));
    QCoreApplication::processEvents();
    EXPECT_EQ(cancelled, 1);
    EXPECT_FALSE(window_->hasStudy());
    EXPECT_TRUE(window_->message().isEmpty());
    // And it can be opened all the same.
    window_->open(folder.path());
    EXPECT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
}

TEST_F(WindowTest, NothingOfTheStudyBeforeStaysWhenTheNextOneCannotBeShown) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_FALSE(window_->description().isEmpty());
    EXPECT_EQ(window_->viewport().letters().left, "R");  // seen from the front
    EXPECT_EQ(window_->viewport().letters().right, "L");
    EXPECT_GT(coloursInTheMiddle(), 100);

    std::optional<Error> error;
    QObject::connect(&*window_, &MainWindow::failed, &*window_, [&](const Error& e) { error = e; });
    const int before = frames_;
    window_->showStudy(studyThatCannotBeShown());
    // From the first moment on, the device has not even heard of it.
    EXPECT_EQ(window_->description(), QStringLiteral("Second"));
    EXPECT_TRUE(window_->viewport().letters().left.empty());
    ASSERT_TRUE(waitUntil([&] { return error.has_value(); }));
    EXPECT_EQ(frames_, before);
    EXPECT_EQ(window_->description(), QStringLiteral("Second"));
    EXPECT_EQ(window_->fidelity(), QStringLiteral("No picture"));
    EXPECT_TRUE(window_->viewport().letters().right.empty());
    EXPECT_TRUE(waitUntil([&] { return coloursInTheMiddle() == 1; }));

    // Nor does it come back with the window.
    window_->hide();
    QCoreApplication::processEvents();
    window_->show();
    ASSERT_TRUE(waitUntil([&] { return window_->viewport().window().isExposed(); }));
    QElapsedTimer idle;
    idle.start();
    waitUntil([&] { return idle.elapsed() > 500; });
    EXPECT_EQ(coloursInTheMiddle(), 1);
    EXPECT_EQ(frames_, before);

    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_FALSE(window_->description().isEmpty());
    EXPECT_EQ(window_->viewport().letters().left, "R");
}

TEST_F(WindowTest, TheNotesOfTheStudyStayWhenAnotherCannotBeOpened) {
    auto study = smallStudy(Unit::hounsfield);
    study.messages = {Text("A slope was missing.")};
    window_->showStudy(study);
    EXPECT_TRUE(window_->notes().contains(QStringLiteral("A slope was missing.")));
    window_->open("/no/such/folder");
    EXPECT_TRUE(window_->notes().contains(QStringLiteral("A slope was missing.")));
    ASSERT_TRUE(waitUntil([&] { return !window_->message().isEmpty(); }));
    EXPECT_TRUE(window_->notes().contains(QStringLiteral("A slope was missing.")));
    window_->showStudy(smallStudy(Unit::hounsfield));
    EXPECT_FALSE(window_->notes().contains(QStringLiteral("A slope was missing.")));
}

TEST_F(WindowTest, ADroppedFolderIsOpened) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QStringLiteral("/no/such/folder"))});
    for (QObject* target :
         {static_cast<QObject*>(&window_->viewport().window()), static_cast<QObject*>(&*window_)}) {
        QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(target, &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent drop({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(target, &drop);
        EXPECT_TRUE(window_->loading());
        ASSERT_TRUE(waitUntil([&] { return !window_->loading(); }));
        EXPECT_FALSE(window_->message().isEmpty());
    }
}

TEST_F(WindowTest, HidingAndShowingKeepsThePicture) {
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    const QImage before = picture();
    const live::FrameShown shown = *last_;
    EXPECT_GT(coloursInTheMiddle(), 100);
    for (int i = 0; i < 2; ++i) {
        window_->hide();
        QCoreApplication::processEvents();
        window_->show();
        ASSERT_TRUE(waitUntil([&] { return window_->viewport().window().isExposed(); }));
        EXPECT_TRUE(waitUntil([&] { return picture() == before; }));
        EXPECT_EQ(last_->stage, live::Stage::converged);
        EXPECT_EQ(last_->samplesPerPixel, shown.samplesPerPixel);
    }
    window_->resize(window_->size() + QSize(64, 32));
    EXPECT_TRUE(waitForConverged());
    EXPECT_EQ(last_->width, window_->viewport().pictureSize().width());
    EXPECT_GT(last_->width, shown.width);
}

TEST_F(WindowTest, StatusTextsKeepApartInANarrowWindow) {
    ASSERT_TRUE(waitUntil([&] { return window_->viewport().window().isExposed(); }));
    QStatusBar& bar = *window_->statusBar();
    ElidingLabel* fidelity = nullptr;
    std::vector<QWidget*> shown;
    for (QWidget* child : bar.findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
        if (child->isVisible()) shown.push_back(child);
        auto* label = qobject_cast<ElidingLabel*>(child);
        if (!label) continue;
        if (label->fullText() == window_->fidelity()) {
            fidelity = label;
        } else {
            label->setFullText(QStringLiteral("CT 512×512×300, 0.70×0.70×1.00 mm"));
        }
    }
    ASSERT_TRUE(fidelity);
    ASSERT_GE(shown.size(), 4u);
    const QString longest = QStringLiteral(
        "Cinematic, table left out, clipped, coarse preview, denoised, 1/10 of the pixels each way");
    fidelity->setFullText(longest);
    const auto expectApart = [&] {
        for (std::size_t i = 0; i < shown.size(); ++i) {
            EXPECT_TRUE(bar.rect().contains(shown[i]->geometry())) << i << " of " << bar.width();
            for (std::size_t k = 0; k < i; ++k) {
                EXPECT_FALSE(shown[i]->geometry().intersects(shown[k]->geometry())) << i << " and " << k;
            }
        }
    };
    for (const int width : {400, 1100, 360}) {
        // As a hand that goes on pulling: labels give way as they get less room.
        ASSERT_TRUE(waitUntil(
            [&] {
                window_->resize(width, window_->height());
                return std::abs(window_->width() - width) <= 40;
            },
            60));
        EXPECT_TRUE(waitUntil(
            [&] { return fidelity->width() >= std::min(fidelity->sizeHint().width(), bar.width() / 2 - 40); },
            5));
        expectApart();
    }
}

TEST_F(WindowTest, ConvergingGoesOnFromThePictureThereIsAndCanBeStopped) {
    auto* start = window_->findChild<QAction*>(QStringLiteral("converge-now"));
    auto* stop = window_->findChild<QAction*>(QStringLiteral("stop-converging"));
    ASSERT_TRUE(start && stop);
    start->trigger();
    EXPECT_FALSE(stop->isEnabled()) << "there is no picture";
    EXPECT_FALSE(window_->message().isEmpty());
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    start->trigger();
    EXPECT_TRUE(stop->isEnabled());
    last_.reset();
    ASSERT_TRUE(waitUntil([&] { return last_ && last_->noiseTarget == ConvergeNow::kNoiseTarget; }));
    EXPECT_EQ(last_->picture, live::OnScreen::traced) << "it does not begin anew";
    stop->trigger();
    EXPECT_FALSE(stop->isEnabled());
    EXPECT_TRUE(waitForConverged());
    EXPECT_TRUE(window_->message().isEmpty());
}

// Whatever is under way, it ends with the window: no frame comes after, and no thread stays.
TEST_F(WindowTest, MayBeClosedAtAnyMoment) {
    const auto threads = [] {
        const std::filesystem::directory_iterator tasks("/proc/self/task");
        return std::distance(begin(tasks), end(tasks));
    };
    const auto close = [&] {
        window_.reset();
        const int before = frames_;
        QCoreApplication::processEvents();
        EXPECT_EQ(frames_, before);
        last_.reset();
    };
    // The first one leaves those of libraries, which are made once.
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    close();
    const auto atRest = threads();
    usesModel_ = true;
    const std::pair<const char*, std::function<bool()>> moments[] = {
        {"at once", [] { return true; }},
        {"exposed", [&] { return waitUntil([&] { return window_->viewport().window().isExposed(); }); }},
        {"loading",
         [&] {
             window_->open(std::nullopt);
             return window_->loading();
         }},
        {"loaded",
         [&] {
             window_->open(std::nullopt);
             return waitUntil([&] { return window_->hasStudy(); });
         }},
        {"first picture",
         [&] {
             window_->open(std::nullopt);
             return waitUntil([&] { return last_.has_value(); });
         }},
        {"in motion", [&] {
             window_->open(std::nullopt);
             if (!waitUntil([&] { return last_.has_value(); })) return false;
             sendMouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton);
             sendMouse(QEvent::MouseMove, {160, 120}, Qt::NoButton, Qt::LeftButton);
             return waitUntil([&] { return last_->stage == live::Stage::moving; });
         }}};
    for (const auto& [name, reach] : moments) {
        SCOPED_TRACE(name);
        makeWindow();
        ASSERT_TRUE(reach());
        close();
        EXPECT_TRUE(waitUntil([&] { return threads() <= atRest; })) << threads() << " of " << atRest;
    }
}

}  // namespace
}  // namespace macula::viewer
