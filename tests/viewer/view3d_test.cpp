// The view in 3D, driven by keys and mouse: roll, flight, parallel rays, the cube, and the transfer function.
#include <gtest/gtest.h>

#include <QAction>
#include <QStatusBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "viewer/overlay/cube_and_scale.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class View3dTest : public WindowTest {
  protected:
    Viewport& viewport() { return window_->viewport(); }
    const scene::OrbitCamera& camera() { return viewport().camera(); }
    void openPhantom() {
        window_->open(std::nullopt);
        ASSERT_TRUE(waitForConverged());
    }
    void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held,
               Qt::KeyboardModifiers modifiers) {
        VulkanWindow& target = viewport().window();
        QMouseEvent event(type, at, target.mapToGlobal(at), button, held, modifiers);
        QCoreApplication::sendEvent(&target, &event);
    }
    void drag(QPointF from, QPointF to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
        mouse(QEvent::MouseButtonPress, from, button, button, modifiers);
        for (int step = 1; step <= 4; ++step)
            mouse(QEvent::MouseMove, from + (to - from) * (step / 4.0), Qt::NoButton, button, modifiers);
        mouse(QEvent::MouseButtonRelease, to, button, Qt::NoButton, modifiers);
    }
    void turnWheel(double notches, Qt::KeyboardModifiers modifiers) {
        VulkanWindow& target = viewport().window();
        const QPointF at(50, 50);
        QWheelEvent event(at, target.mapToGlobal(at), {}, QPoint(0, int(120 * notches)), Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&target, &event);
    }
    void releaseKey(int key) {
        QKeyEvent event(QEvent::KeyRelease, key, Qt::NoModifier);
        QCoreApplication::sendEvent(&viewport().window(), &event);
    }
    QAction& action(const char* name) {
        auto* found = window_->findChild<QAction*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    // Whether these marks stand over what is on screen. Smooth edges of a cube that is turned may differ a
    // little: its corners are rounded once more on their way through the camera of the picture.
    bool hasMarksOf(const MarkedPicture& of) {
        const auto marks = paintCubeAndScale(of);
        const QImage now = picture();
        if (!marks || now.size() != of.pixels) return false;
        for (std::size_t i = 0; i < marks->boxes.size(); ++i) {
            const VkRect2D& box = marks->boxes[i];
            for (int y = 0; y < int(box.extent.height); ++y) {
                for (int x = 0; x < int(box.extent.width); ++x) {
                    const std::byte* wanted =
                        &marks->rgba[4 * (std::size_t(box.offset.y + y) * marks->size.width +
                                          std::size_t(box.offset.x + x))];
                    const QRgb is = now.pixel(marks->places.at(i).x + x, marks->places.at(i).y + y);
                    constexpr int kLevels = 16;
                    if (std::abs(qRed(is) - int(wanted[0])) > kLevels ||
                        std::abs(qGreen(is) - int(wanted[1])) > kLevels ||
                        std::abs(qBlue(is) - int(wanted[2])) > kLevels)
                        return false;
                }
            }
        }
        return !marks->boxes.empty();
    }
};

TEST_F(View3dTest, HandsAndKeysRollAndFly) {
    openPhantom();
    pressKey(Qt::Key_BracketRight);
    EXPECT_NEAR(camera().rollDeg, 5.0, 1e-9);
    pressKey(Qt::Key_Left, Qt::ControlModifier);
    pressKey(Qt::Key_Left, Qt::ControlModifier);
    EXPECT_NEAR(camera().rollDeg, -5.0, 1e-9);
    const double height = viewport().window().height();
    drag({50, 50}, {50 + 0.25 * height, 60}, Qt::LeftButton, Qt::AltModifier);
    EXPECT_NEAR(camera().rollDeg, 40.0, 1e-6);
    EXPECT_EQ(camera().azimuthDeg, 0.0);
    pressKey(Qt::Key_A);
    EXPECT_EQ(camera().rollDeg, 0.0) << "a standard view is upright";

    const scene::OrbitCamera before = camera();
    turnWheel(2, Qt::AltModifier);
    EXPECT_EQ(camera().distanceMm, before.distanceMm);
    EXPECT_GT(camera().targetMm.y, before.targetMm.y + 1.0)
        << "from the front it goes backwards in the patient";
    turnWheel(-2, Qt::AltModifier);
    EXPECT_NEAR(camera().targetMm.y, before.targetMm.y, 1e-9);
    turnWheel(1, Qt::NoModifier);
    EXPECT_LT(camera().distanceMm, before.distanceMm);
    EXPECT_TRUE(waitForConverged());
    EXPECT_EQ(viewport().letters().right, "L");
}

TEST_F(View3dTest, ParallelRaysAreSaidAndComeBackWithTheView) {
    openPhantom();
    const scene::OrbitCamera before = camera();
    EXPECT_FALSE(action("parallel-rays").isChecked());
    pressKey(Qt::Key_O);
    EXPECT_TRUE(action("parallel-rays").isChecked());
    EXPECT_EQ(camera().distanceMm, before.distanceMm);
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(isParallel(last_->camera));
    EXPECT_TRUE(window_->fidelity().contains(QStringLiteral("parallel rays")))
        << window_->fidelity().toStdString();
    EXPECT_GT(coloursInTheMiddle(), 100);
    const double heightMm = toCamera(camera()).parallelHeightMm;
    pressKey(Qt::Key_Plus);
    EXPECT_LT(toCamera(camera()).parallelHeightMm, heightMm);
    turnWheel(1, Qt::AltModifier);
    EXPECT_EQ(camera().targetMm, before.targetMm) << "nothing comes nearer";

    const auto view = scene::studyStateFromJson(toJson(window_->state()), "view.json");
    ASSERT_TRUE(view.ok());
    action("parallel-rays").trigger();
    EXPECT_FALSE(camera().isParallel);
    ASSERT_TRUE(window_->setState(*view).ok());
    EXPECT_TRUE(camera().isParallel);
    EXPECT_TRUE(action("parallel-rays").isChecked());
    EXPECT_NEAR(toCamera(camera()).parallelHeightMm, view->camera->parallelHeightMm, 1e-6);
    action("show-afresh").trigger();
    EXPECT_FALSE(camera().isParallel);
}

TEST_F(View3dTest, TheCubeIsOfThePictureAndAClickOnItTurnsThere) {
    window_->resize(760, 620);
    openPhantom();
    const auto shown = [&] { return viewport().pictureOnScreen(); };
    ASSERT_TRUE(shown());
    EXPECT_TRUE(waitUntil([&] { return hasMarksOf(*shown()); }));
    pressKey(Qt::Key_Right);
    pressKey(Qt::Key_Right);
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(waitUntil([&] { return hasMarksOf(*shown()); }));
    const double distanceMm = camera().distanceMm;

    // B takes them off at once, with no other picture, and puts them back; both can be undone.
    const int before = frames_;
    pressKey(Qt::Key_B);
    EXPECT_FALSE(window_->session().state().showsMarks);
    EXPECT_FALSE(action("cube-and-scale").isChecked());
    EXPECT_TRUE(waitUntil([&] { return !hasMarksOf(*shown()); }));
    window_->session().undo();
    EXPECT_TRUE(action("cube-and-scale").isChecked());
    EXPECT_TRUE(waitUntil([&] { return hasMarksOf(*shown()); }));
    EXPECT_EQ(frames_, before);

    // The side of the patient's left.
    std::optional<QPointF> left;
    const QSizeF size = viewport().window().size();
    for (int x = int(0.7 * size.width()); x < int(size.width()) && !left; ++x) {
        for (int y = int(0.7 * size.height()); y < int(size.height()) && !left; ++y) {
            const QPointF place(2.0 * x / size.width() - 1.0, 1.0 - 2.0 * y / size.height());
            if (cubeSideAt(*shown(), place) == ViewDirection::left) left = QPointF(x, y);
        }
    }
    ASSERT_TRUE(left);
    drag(*left, *left, Qt::LeftButton);
    EXPECT_NEAR(camera().azimuthDeg, 90.0, 1e-9);
    EXPECT_EQ(camera().distanceMm, distanceMm);
    // Elsewhere a click does nothing.
    drag({200, 200}, {200, 200}, Qt::LeftButton);
    EXPECT_NEAR(camera().azimuthDeg, 90.0, 1e-9);
    EXPECT_TRUE(waitForConverged());
}

TEST_F(View3dTest, AHandShiftsAndWidensTheTransferFunctionAsOneStep) {
    openPhantom();
    const auto before = window_->session().state().preset;
    const scene::OrbitCamera camera = viewport().camera();
    const double height = viewport().window().height();
    const auto lastValue = [&] { return window_->session().state().preset->opacity.back().value; };
    const double value = lastValue();
    mouse(QEvent::MouseButtonPress, {50, 50}, Qt::RightButton, Qt::RightButton, Qt::AltModifier);
    mouse(QEvent::MouseMove, {50 + 0.1 * height, 50}, Qt::NoButton, Qt::RightButton, Qt::AltModifier);
    EXPECT_GT(lastValue(), value);
    EXPECT_TRUE(window_->statusBar()->currentMessage().contains(QStringLiteral("HU")));
    mouse(QEvent::MouseMove, {50 + 0.2 * height, 40}, Qt::NoButton, Qt::RightButton, Qt::AltModifier);
    mouse(QEvent::MouseButtonRelease, {50, 40}, Qt::RightButton, Qt::NoButton, Qt::AltModifier);
    EXPECT_TRUE(window_->statusBar()->currentMessage().isEmpty());
    EXPECT_EQ(viewport().camera().distanceMm, camera.distanceMm);
    window_->session().undo();
    EXPECT_EQ(window_->session().state().preset, before);
    EXPECT_FALSE(window_->session().canUndo());

    // The same with a key held down, where the window system keeps Alt for itself.
    pressKey(Qt::Key_T);
    drag({50, 50}, {50 + 0.1 * height, 50}, Qt::LeftButton);
    EXPECT_GT(lastValue(), value);
    EXPECT_EQ(viewport().camera().azimuthDeg, camera.azimuthDeg);
    releaseKey(Qt::Key_T);
    drag({50, 50}, {90, 50}, Qt::LeftButton);
    EXPECT_NE(viewport().camera().azimuthDeg, camera.azimuthDeg);
}

// The button is still down, and what it held is gone.
TEST_F(View3dTest, ADragDoesNotGoOnOverTheNextStudy) {
    openPhantom();
    for (const auto& [button, modifiers] :
         {std::pair(Qt::RightButton, Qt::KeyboardModifiers(Qt::AltModifier)),
          std::pair(Qt::LeftButton, Qt::KeyboardModifiers())}) {
        const scene::OrbitCamera before = camera();
        const auto presetBefore = window_->session().state().preset;
        mouse(QEvent::MouseButtonPress, {50, 50}, button, button, modifiers);
        mouse(QEvent::MouseMove, {80, 60}, Qt::NoButton, button, modifiers);
        EXPECT_TRUE(window_->session().state().preset != presetBefore ||
                    toCamera(camera()) != toCamera(before));
        window_->showStudy(smallStudy(Unit::hounsfield));
        EXPECT_TRUE(window_->statusBar()->currentMessage().isEmpty());
        const scene::OrbitCamera now = camera();
        const auto preset = window_->session().state().preset;
        mouse(QEvent::MouseMove, {120, 90}, Qt::NoButton, button, modifiers);
        mouse(QEvent::MouseButtonRelease, {120, 90}, button, Qt::NoButton, modifiers);
        EXPECT_EQ(window_->session().state().preset, preset);
        EXPECT_EQ(toCamera(camera()), toCamera(now));
        EXPECT_FALSE(window_->session().canUndo());
    }
}

class ParallelModelTest : public View3dTest {
  protected:
    ParallelModelTest() { usesModel_ = true; }
};

// The model is drawn with parallel rays too: what follows the hand has all pixels, and none of it is a fovea.
TEST_F(ParallelModelTest, WithParallelRaysTheModelFollowsTheHand) {
    std::vector<live::FrameShown> seen;
    QObject::connect(&*window_, &MainWindow::frameShown, &*window_,
                     [&](const live::FrameShown& frame) { seen.push_back(frame); });
    const auto hasSeen = [&](live::OnScreen picture) {
        return std::ranges::any_of(seen, [&](const auto& frame) { return frame.picture == picture; });
    };
    openPhantom();
    ASSERT_TRUE(waitUntil([&] { return window_->modelState().startsWith(QLatin1String("Preview sharp")); }));
    seen.clear();
    pressKey(Qt::Key_O);
    ASSERT_TRUE(waitUntil([&] { return !seen.empty() && isParallel(seen.back().camera); }));
    seen.clear();
    mouse(QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton, {});
    for (int x = 106; x < 130; x += 6) {
        const std::size_t before = seen.size();
        mouse(QEvent::MouseMove, QPointF(x, 100), Qt::NoButton, Qt::LeftButton, {});
        ASSERT_TRUE(waitUntil([&] { return seen.size() > before; }));
    }
    EXPECT_TRUE(window_->fidelity().startsWith(QStringLiteral("Preview, ")))
        << window_->fidelity().toStdString();
    EXPECT_TRUE(window_->fidelity().contains(QStringLiteral("parallel rays")));
    for (const live::FrameShown& frame : seen) {
        if (frame.stage != live::Stage::moving) continue;  // traced before the hand came
        EXPECT_EQ(frame.picture, live::OnScreen::model);
        EXPECT_FALSE(frame.foveaAgeMs);
    }
    mouse(QEvent::MouseButtonRelease, {130, 100}, Qt::LeftButton, Qt::NoButton, {});
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(hasSeen(live::OnScreen::fading));
    EXPECT_FALSE(hasSeen(live::OnScreen::preview));
    // Seen by an eye again, the model is there at once.
    seen.clear();
    pressKey(Qt::Key_O);
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(hasSeen(live::OnScreen::model));
}

TEST_F(View3dTest, TheBackgroundIsChosenKeptAndTakenBack) {
    openPhantom();
    const auto corner = [&] { return picture().pixel(1, picture().height() / 2); };
    const QRgb usual = corner();
    EXPECT_LT(qGreen(usual), 12) << "nearly black";
    EXPECT_TRUE(action("background-usual").isChecked());
    action("background-white").trigger();
    EXPECT_EQ(window_->state().background, scene::BackgroundColour(255, 255, 255));
    EXPECT_TRUE(waitUntil([&] { return corner() == qRgb(255, 255, 255); }));
    const auto saved = scene::studyStateFromJson(toJson(window_->state()), "view.json");
    ASSERT_TRUE(saved.ok());

    window_->session().undo();
    EXPECT_TRUE(action("background-usual").isChecked());
    EXPECT_TRUE(waitUntil([&] { return corner() == usual; }));
    ASSERT_TRUE(window_->setState(*saved).ok());
    EXPECT_TRUE(action("background-white").isChecked());
    EXPECT_TRUE(waitUntil([&] { return corner() == qRgb(255, 255, 255); }));

    window_->session().change(QStringLiteral("Background"), [](scene::StudyState& next) {
        next.background = scene::BackgroundColour(10, 200, 60);
    });
    for (const char* name : {"background-usual", "background-black", "background-grey", "background-white"})
        EXPECT_FALSE(action(name).isChecked()) << name;
    EXPECT_TRUE(waitUntil([&] { return corner() == qRgb(10, 200, 60); }));
    window_->open(std::nullopt);
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(waitUntil([&] { return corner() == qRgb(10, 200, 60); })) << "the next study has it too";
}

// As programs open it: nobody has said from where.
class FirstViewTest : public View3dTest {
  protected:
    FirstViewTest() { firstView_.reset(); }
    // A ball in so many slices of 4 mm, 24 voxels wide.
    static study::OpenedStudy ballOf(int slices) {
        std::vector<std::uint16_t> voxels;
        for (int k = 0; k < slices; ++k)
            for (int j = 0; j < 24; ++j)
                for (int i = 0; i < 24; ++i)
                    voxels.push_back(std::hypot(i - 11.5, j - 11.5, k - 0.5 * (slices - 1)) < 8.0 ? 2024
                                                                                                  : 24);
        auto volume =
            Volume::create({.size = {24, 24, slices},
                            .worldFromVoxel = affine({4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-46, -46, 0}),
                            .unitsFromStored = {1.0, -1024.0},
                            .unit = Unit::hounsfield,
                            .modality = "CT"},
                           std::move(voxels));
        return {.volume = std::make_shared<const Volume>(*std::move(volume)),
                .identity = {.series = Text("Ball"), .isOfNobody = true},
                .description = Text("Ball")};
    }
    // Whether the camera stands where such a view does, as near as what is seen fits.
    bool looksFrom(ViewDirection from) {
        return std::abs(camera().azimuthDeg - obliquenessOf(from).azimuthDeg) < 1e-9 &&
               std::abs(camera().elevationDeg - obliquenessOf(from).elevationDeg) < 1e-9;
    }
};

TEST_F(FirstViewTest, IsObliqueOfAShortStackAndTurnedOfABody) {
    window_->showStudy(ballOf(8));
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(looksFrom(ViewDirection::oblique)) << camera().azimuthDeg << ", " << camera().elevationDeg;
    EXPECT_EQ(viewport().framedFrom(), ViewDirection::oblique);
    EXPECT_EQ(viewport().firstFrom(), ViewDirection::oblique);

    // Who has moved it is brought back there.
    pressKey(Qt::Key_A);
    EXPECT_TRUE(looksFrom(ViewDirection::anterior));
    action("show-afresh").trigger();
    EXPECT_TRUE(looksFrom(ViewDirection::oblique));

    window_->showStudy(ballOf(24));
    ASSERT_TRUE(waitForConverged());
    EXPECT_TRUE(looksFrom(ViewDirection::turned)) << camera().azimuthDeg << ", " << camera().elevationDeg;
}

}  // namespace
}  // namespace macula::viewer
