// The parts of the 3D picture that need neither a window nor a device.
#include <gtest/gtest.h>

#include <QKeyEvent>

#include "viewer/slice_volume.h"
#include "viewer/viewport/picture_camera.h"
#include "viewer/viewport/picture_hand.h"

namespace macula::viewer {
namespace {

class PictureCameraTest : public testing::Test {
  protected:
    PictureCameraTest() {
        camera_.setVolume(test::sliceVolume());
        camera_.showFirst(ViewDirection::anterior);
        QObject::connect(&camera_, &PictureCamera::changed, [this] { ++changes_; });
        QObject::connect(&camera_, &PictureCamera::parallelChanged, [this](bool isParallel) {
            EXPECT_EQ(isParallel, camera_.now().isParallel);
            ++switches_;
        });
    }
    static std::shared_ptr<const std::vector<glm::dvec3>> smallOutline() {
        return std::make_shared<const std::vector<glm::dvec3>>(
            std::vector<glm::dvec3>{{-2, -2, -2}, {2, 2, 2}, {-2, 2, -2}, {2, -2, 2}});
    }

    double aspect_ = 1.0;
    PictureCamera camera_{[this] { return aspect_; }};
    int changes_ = 0;
    int switches_ = 0;
};

TEST_F(PictureCameraTest, WithoutAVolumeThereIsNothingToFit) {
    PictureCamera camera([] { return 1.0; });
    int changes = 0;
    QObject::connect(&camera, &PictureCamera::changed, [&] { ++changes; });
    camera.showFirst(ViewDirection::left);
    camera.fit();
    camera.centreOn(glm::dvec3(1.0));
    camera.refit();
    camera.takeOutline(smallOutline());
    EXPECT_EQ(changes, 0);
}

TEST_F(PictureCameraTest, TheFirstOutlineMovesACameraThatNobodyHasTouched) {
    const double far = camera_.now().distanceMm;
    camera_.takeOutline(smallOutline());
    EXPECT_LT(camera_.now().distanceMm, 0.5 * far);
    EXPECT_EQ(camera_.framedFrom(), ViewDirection::anterior);
    EXPECT_EQ(changes_, 1);
    camera_.takeOutline(std::make_shared<const std::vector<glm::dvec3>>());
    EXPECT_EQ(changes_, 1) << "of another preset";
    camera_.setVolume(test::sliceVolume());
    camera_.zoomBy(2.0);
    EXPECT_FALSE(camera_.framedFrom());
    const double closer = camera_.now().distanceMm;
    camera_.takeOutline(smallOutline());
    EXPECT_EQ(camera_.now().distanceMm, closer) << "a person has moved it";
}

TEST_F(PictureCameraTest, AProjectionFitsAllOfTheVolume) {
    const double far = camera_.now().distanceMm;
    camera_.setProjection(true);
    camera_.takeOutline(smallOutline());
    EXPECT_NEAR(camera_.now().distanceMm, far, 1e-9);
}

TEST_F(PictureCameraTest, AnotherAspectIsFittedUntilItIsMoved) {
    const double before = camera_.now().distanceMm;
    aspect_ = 0.25;
    camera_.refit();
    EXPECT_GT(camera_.now().distanceMm, before);
    EXPECT_EQ(changes_, 0);
    camera_.zoomBy(2.0);
    const double closer = camera_.now().distanceMm;
    aspect_ = 1.0;
    camera_.refit();
    EXPECT_EQ(camera_.now().distanceMm, closer);
}

TEST_F(PictureCameraTest, ParallelRaysAreNoMotion) {
    camera_.setParallel(true);
    EXPECT_EQ(switches_, 1);
    EXPECT_FALSE(camera_.framedFrom()) << "no side is told with parallel rays";
    camera_.setParallel(false);
    EXPECT_EQ(switches_, 2);
    EXPECT_EQ(camera_.framedFrom(), ViewDirection::anterior);
}

TEST_F(PictureCameraTest, ArrowsOrbitAndWithControlRoll) {
    int nudges = 0;
    CameraKeys keys(camera_, [&] { ++nudges; });
    const double azimuth = camera_.now().azimuthDeg;
    const QKeyEvent right(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier);
    EXPECT_FALSE(keys.roll(right));
    EXPECT_TRUE(keys.move(right));
    EXPECT_NE(camera_.now().azimuthDeg, azimuth);
    EXPECT_EQ(camera_.now().rollDeg, 0.0);
    EXPECT_TRUE(keys.roll(QKeyEvent(QEvent::KeyPress, Qt::Key_Right, Qt::ControlModifier)));
    EXPECT_GT(camera_.now().rollDeg, 0.0);
    EXPECT_FALSE(keys.look(QKeyEvent(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier)));
    EXPECT_EQ(nudges, 2);
}

// Takes hold on the right of the picture.
class RightTool : public PictureTool {
  public:
    bool press(const PicturePlace& place) override { return place.at.x > 0.0; }
    void move(const PicturePlace&) override { ++moves; }
    void release(const PicturePlace&) override { ++releases; }
    void giveUp() override { ++given; }
    bool changesPicture() const override { return true; }
    std::optional<Qt::CursorShape> point(const PicturePlace& place) override {
        return place.at.x > 0.0 ? std::optional(Qt::SizeHorCursor) : std::nullopt;
    }
    bool turnWheel(double, const PictureGeometry&) override { return false; }
    std::vector<ToolMark> marks(const PictureGeometry&) const override { return {ToolMark{}}; }

    int moves = 0;
    int releases = 0;
    int given = 0;
};

TEST(PictureTools, TheOneThatTakesHoldGetsTheDrag) {
    RightTool first;
    RightTool second;
    PictureTools tools;
    tools.set({&first, nullptr, &second});
    const PicturePlace left{.picture = {}, .at = {-0.5, 0.0}};
    const PicturePlace right{.picture = {}, .at = {0.5, 0.0}};
    EXPECT_FALSE(tools.press(left));
    EXPECT_FALSE(tools.wouldHold(left));
    EXPECT_EQ(tools.cursorAt(right), Qt::SizeHorCursor);
    EXPECT_EQ(tools.marks({}).size(), 2u);
    tools.move(right);
    EXPECT_EQ(first.moves, 0) << "nothing is held";
    ASSERT_TRUE(tools.press(right));
    tools.move(left);
    tools.release(left);
    EXPECT_EQ(first.moves, 1);
    EXPECT_EQ(first.releases, 1);
    EXPECT_EQ(second.moves, 0);
    EXPECT_FALSE(tools.isHolding());
    ASSERT_TRUE(tools.press(right));
    tools.set({&second});
    EXPECT_EQ(first.given, 1);
    EXPECT_FALSE(tools.isHolding());
}

}  // namespace
}  // namespace macula::viewer
