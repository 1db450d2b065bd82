// Handles and scissors in the window, over a picture that is drawn.
#include "viewer/window_fixture.h"

#include <gtest/gtest.h>

#include <QAction>
#include <stdexcept>

#include "scene/camera/picture_rays.h"
#include "scene/clip/kept_box.h"
#include "viewer/clip/clip_editing.h"
#include "viewer/clip/scissor_tool.h"

namespace macula::viewer {
namespace {

class ClipWindowTest : public WindowTest {
  protected:
    void openPhantom() {
        window_->open(std::nullopt);
        ASSERT_TRUE(waitUntil([&] { return window_->hasStudy(); }));
        ASSERT_TRUE(waitForConverged());
    }
    QAction& action(const char* name) {
        auto* found = window_->findChild<QAction*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    // -1 to 1, right and up are positive.
    QPointF pixelOf(const glm::dvec2& place) {
        const VulkanWindow& target = window_->viewport().window();
        return {0.5 * (place.x + 1.0) * target.width(), 0.5 * (1.0 - place.y) * target.height()};
    }
    QPointF pixelOf(const glm::dvec3& mm) {
        const PictureGeometry picture = window_->viewport().geometry();
        return pixelOf(*scene::PictureRays::of(picture.camera, picture.aspect)->placeOf(mm));
    }
    void drag(QPointF from, QPointF to) {
        sendMouse(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        sendMouse(QEvent::MouseMove, 0.5 * (from + to), Qt::NoButton, Qt::LeftButton);
        sendMouse(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
        sendMouse(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }
    const scene::StudyState& chosen() { return window_->session().state(); }
    Camera camera() { return toCamera(window_->viewport().camera()); }
};

TEST_F(ClipWindowTest, AFaceIsDraggedInThePictureAndTheCameraStays) {
    openPhantom();
    const Volume& volume = *window_->session().study().volume;
    const QImage without = picture();
    pressKey(Qt::Key_K);
    EXPECT_TRUE(action("handles-of-clip").isChecked());
    EXPECT_TRUE(waitUntil([&] { return picture() != without; })) << "handles are over the picture";
    ASSERT_TRUE(waitUntil([&] { return window_->viewport().isCameraOnScreen(); }));
    const Camera before = camera();
    glm::dvec3 left = volume.worldBox().centre();
    left.x = volume.worldBox().high.x;
    glm::dvec3 to = left;
    to.x = 20.0;
    drag(pixelOf(left), pixelOf(to));
    ASSERT_TRUE(chosen().clip);
    EXPECT_NEAR(scene::keptBox(chosen().clip, volume)->high.x, 20.0, 6.0) << "L is at the right";
    EXPECT_EQ(camera(), before);
    ASSERT_TRUE(
        waitUntil([&] { return last_ && last_->remarks.english().find("clipped") != std::string::npos; }));
    window_->session().undo();
    EXPECT_FALSE(window_->session().canUndo());
    pressKey(Qt::Key_K);
    drag(pixelOf(left), pixelOf(to));
    EXPECT_FALSE(chosen().clip);
    EXPECT_NE(camera(), before) << "without handles the camera moves";
    EXPECT_FALSE(window_->session().canUndo());
}

TEST_F(ClipWindowTest, AHandleIsLetGoWhenAnotherStudyIsShown) {
    openPhantom();
    pressKey(Qt::Key_K);
    const Volume& volume = *window_->session().study().volume;
    glm::dvec3 left = volume.worldBox().centre();
    left.x = volume.worldBox().high.x;
    glm::dvec3 to = left;
    to.x = 20.0;
    const QPointF from = pixelOf(left);
    const QPointF half = 0.5 * (from + pixelOf(to));
    const QPointF end = pixelOf(to);
    sendMouse(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    sendMouse(QEvent::MouseMove, half, Qt::NoButton, Qt::LeftButton);
    ASSERT_TRUE(chosen().clip);
    window_->showStudy(smallStudy(Unit::hounsfield));
    const Camera now = camera();
    sendMouse(QEvent::MouseMove, end, Qt::NoButton, Qt::LeftButton);
    sendMouse(QEvent::MouseButtonRelease, end, Qt::LeftButton, Qt::NoButton);
    EXPECT_FALSE(chosen().clip);
    EXPECT_FALSE(window_->session().canUndo());
    EXPECT_EQ(camera(), now);
}

TEST_F(ClipWindowTest, ScissorsRemoveWhatIsDrawnAroundAndItComesBack) {
    openPhantom();
    ASSERT_TRUE(waitUntil([&] { return window_->viewport().isCameraOnScreen(); }));
    const Camera before = camera();
    pressKey(Qt::Key_X);
    EXPECT_TRUE(window_->scissors().isOut());
    const QPointF corners[] = {pixelOf(glm::dvec2(-0.3, -0.3)), pixelOf(glm::dvec2(0.3, -0.3)),
                               pixelOf(glm::dvec2(0.3, 0.3)), pixelOf(glm::dvec2(-0.3, 0.3))};
    sendMouse(QEvent::MouseButtonPress, corners[0], Qt::LeftButton, Qt::LeftButton);
    for (const QPointF& corner : corners) sendMouse(QEvent::MouseMove, corner, Qt::NoButton, Qt::LeftButton);
    sendMouse(QEvent::MouseButtonRelease, corners[3], Qt::LeftButton, Qt::NoButton);
    ASSERT_EQ(chosen().cuts.scissors.size(), 1u);
    EXPECT_EQ(chosen().cuts.scissors[0].camera, before);
    EXPECT_EQ(camera(), before);
    ASSERT_TRUE(waitUntil([&] { return !window_->cutting() && window_->hidesSomething(); }));
    ASSERT_TRUE(waitUntil(
        [&] { return last_ && last_->remarks.english().find("cut with scissors") != std::string::npos; }));
    EXPECT_EQ(last_->remarks.english().find("table"), std::string::npos);
    EXPECT_FALSE(action("no-clip").isChecked());
    const auto again = scene::studyStateFromJson(toJson(window_->state()), {});
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->cuts, chosen().cuts);

    pressKey(Qt::Key_U, Qt::ControlModifier);
    EXPECT_FALSE(window_->hidesSomething());
    EXPECT_TRUE(chosen().cuts.isNothing());
    window_->session().undo();
    ASSERT_TRUE(waitUntil([&] { return !window_->cutting() && window_->hidesSomething(); }));
    window_->session().undo();
    EXPECT_FALSE(window_->hidesSomething());
    EXPECT_FALSE(window_->session().canUndo());
    pressKey(Qt::Key_X);
    EXPECT_FALSE(window_->scissors().isOut());
}

// What is drawn around on screen is not what another camera sees there.
TEST_F(ClipWindowTest, ScissorsWaitForThePictureOfTheCamera) {
    openPhantom();
    ASSERT_TRUE(waitUntil([&] { return window_->viewport().isCameraOnScreen(); }));
    pressKey(Qt::Key_X);
    pressKey(Qt::Key_Left);
    const Camera turned = camera();
    ASSERT_FALSE(window_->viewport().isCameraOnScreen());
    const auto cut = [&] {
        const QPointF corners[] = {pixelOf(glm::dvec2(-0.3, -0.3)), pixelOf(glm::dvec2(0.3, -0.3)),
                                   pixelOf(glm::dvec2(0.3, 0.3)), pixelOf(glm::dvec2(-0.3, 0.3))};
        sendMouse(QEvent::MouseButtonPress, corners[0], Qt::LeftButton, Qt::LeftButton);
        for (const QPointF& corner : corners)
            sendMouse(QEvent::MouseMove, corner, Qt::NoButton, Qt::LeftButton);
        sendMouse(QEvent::MouseButtonRelease, corners[3], Qt::LeftButton, Qt::NoButton);
    };
    cut();
    EXPECT_TRUE(chosen().cuts.scissors.empty());
    EXPECT_EQ(camera(), turned) << "nor does the camera move";
    ASSERT_TRUE(waitUntil([&] { return window_->viewport().isCameraOnScreen(); }));
    cut();
    ASSERT_EQ(chosen().cuts.scissors.size(), 1u);
    EXPECT_EQ(chosen().cuts.scissors[0].camera, turned);
}

}  // namespace
}  // namespace macula::viewer
