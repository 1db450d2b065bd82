// The cube and the scale over the picture in 3D: how long the bar is, where the cube is, what is clicked.
#include "viewer/overlay/cube_and_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "scene/camera/orbit_camera.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

class CubeAndScale : public test::OffscreenTest {
  protected:
    static MarkedPicture pictureOf(const scene::OrbitCamera& camera, QSize pixels = {800, 600},
                                   double ratio = 1.0) {
        return {toCamera(camera), pixels, ratio};
    }
    static scene::OrbitCamera parallel(double heightMm) {
        scene::OrbitCamera camera{.isParallel = true};
        camera.distanceMm = 0.5 * heightMm / std::tan(glm::radians(15.0));
        return camera;
    }
    // As cubeSideAt takes it, of a device pixel from the top left corner.
    static QPointF placeOf(const MarkedPicture& picture, QPointF px) {
        return {2.0 * px.x() / picture.pixels.width() - 1.0, 1.0 - 2.0 * px.y() / picture.pixels.height()};
    }
    static QPointF cubeMiddle(const MarkedPicture& picture) {
        const auto marks = paintCubeAndScale(picture);
        const QPoint corner = cornerOf(*marks);
        return {corner.x() + 0.5 * marks->size.width, corner.y() + 36.0 * picture.pixelRatio};
    }
    // The upper left one of all that is painted, in the picture.
    static QPoint cornerOf(const live::PictureText& marks) {
        const VkOffset2D at = marks.places.at(0);
        const VkOffset2D in = marks.boxes.at(0).offset;
        return {at.x - in.x, at.y - in.y};
    }
};

// 300 mm over 600 pixels: two pixels for a millimetre. 5 cm are the longest round length in 108 pixels.
TEST_F(CubeAndScale, TheBarIsAsLongAsItSays) {
    const auto bar = scaleBarOf(pictureOf(parallel(300)));
    ASSERT_TRUE(bar);
    EXPECT_NEAR(bar->lengthMm, 50.0, 1e-9);
    EXPECT_NEAR(bar->lengthPx, 100.0, 1e-9);
    EXPECT_EQ(bar->text, QStringLiteral("5 cm"));
    // Twice as near, and on a screen of twice the pixels.
    EXPECT_NEAR(scaleBarOf(pictureOf(parallel(150)))->lengthMm, 20.0, 1e-9);
    EXPECT_NEAR(scaleBarOf(pictureOf(parallel(300), {1600, 1200}, 2.0))->lengthPx, 200.0, 1e-9);
    // Seen by an eye: that of the plane of what it turns around.
    scene::OrbitCamera eye{.targetMm = {10, 20, 30}, .distanceMm = 700};
    const double mmPerPx = 2.0 * 700.0 * std::tan(glm::radians(15.0)) / 600.0;
    const auto seen = scaleBarOf(pictureOf(eye));
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->lengthPx * mmPerPx, seen->lengthMm, 1e-9);
    EXPECT_LE(seen->lengthPx, 108.0);
    EXPECT_GT(seen->lengthPx, 108.0 / 2.5);
    // Wherever it is seen from.
    eye.azimuthDeg = 77;
    eye.rollDeg = 140;
    EXPECT_NEAR(scaleBarOf(pictureOf(eye))->lengthPx, seen->lengthPx, 1e-9);
}

TEST_F(CubeAndScale, StandInTheLowerRightCorner) {
    for (const double ratio : {1.0, 1.5, 2.0}) {
        const MarkedPicture picture = pictureOf(parallel(300), QSize(800, 600) * ratio, ratio);
        const auto marks = paintCubeAndScale(picture);
        ASSERT_TRUE(marks);
        EXPECT_EQ(marks->rgba.size(), 4u * marks->size.width * marks->size.height);
        EXPECT_EQ(marks->of.width, std::uint32_t(picture.pixels.width()));
        const QPoint corner = cornerOf(*marks);
        EXPECT_EQ(corner.x() + int(marks->size.width), picture.pixels.width() - std::lround(8 * ratio));
        EXPECT_EQ(corner.y() + int(marks->size.height), picture.pixels.height() - std::lround(8 * ratio));
        std::set<std::byte> levels;
        for (std::size_t i = 0; i < marks->rgba.size(); i += 4) {
            levels.insert(marks->rgba[i]);
            ASSERT_EQ(marks->rgba[i + 3], std::byte(255)) << "opaque";
        }
        EXPECT_GT(levels.size(), 5u);
    }
}

// A box around all of it would hide what is looked at.
TEST_F(CubeAndScale, CoverOfThePictureWhatTheyPaint) {
    scene::OrbitCamera turned = parallel(300);
    turned.azimuthDeg = 35;
    turned.elevationDeg = 25;
    for (const double ratio : {1.0, 2.0}) {
        const auto marks = paintCubeAndScale(pictureOf(turned, QSize(800, 600) * ratio, ratio));
        ASSERT_TRUE(marks);
        ASSERT_EQ(marks->places.size(), marks->boxes.size());
        EXPECT_LT(marks->boxes.size(), 200u) << "each is a copy";
        std::set<std::pair<int, int>> covered;
        for (std::size_t i = 0; i < marks->boxes.size(); ++i) {
            const VkRect2D& box = marks->boxes[i];
            EXPECT_EQ(marks->places[i].x - box.offset.x, cornerOf(*marks).x());
            EXPECT_EQ(marks->places[i].y - box.offset.y, cornerOf(*marks).y());
            ASSERT_LE(box.offset.x + int(box.extent.width), int(marks->size.width));
            ASSERT_LE(box.offset.y + int(box.extent.height), int(marks->size.height));
            for (int y = 0; y < int(box.extent.height); ++y)
                for (int x = 0; x < int(box.extent.width); ++x)
                    EXPECT_TRUE(covered.insert({box.offset.x + x, box.offset.y + y}).second) << "twice";
        }
        EXPECT_LT(double(covered.size()), 0.6 * marks->size.width * marks->size.height);
        const int middle = int(marks->size.width) / 2;
        EXPECT_TRUE(covered.contains({middle, int(36 * ratio)})) << "the cube";
        EXPECT_FALSE(covered.contains({int(6 * ratio), int(36 * ratio)})) << "beside it";
        for (int y = 0; y < int(marks->size.height); ++y) {
            for (int x = 0; x < int(marks->size.width); ++x) {
                const std::size_t at = 4 * (std::size_t(y) * marks->size.width + std::size_t(x));
                if (marks->rgba[at] == std::byte(12)) continue;  // paper
                ASSERT_TRUE(covered.contains({x, y})) << x << " " << y;
            }
        }
    }
}

TEST_F(CubeAndScale, AnotherCameraHasOtherMarks) {
    scene::OrbitCamera camera = parallel(300);
    const auto front = paintCubeAndScale(pictureOf(camera))->rgba;
    EXPECT_EQ(paintCubeAndScale(pictureOf(camera))->rgba, front);
    camera.azimuthDeg = 30;
    EXPECT_NE(paintCubeAndScale(pictureOf(camera))->rgba, front);
    camera.azimuthDeg = 0;
    camera.isParallel = false;
    EXPECT_NE(paintCubeAndScale(pictureOf(camera))->rgba, front) << "it says where the bar is true";
}

// In a second line; the cube stands as much higher, and is clicked there.
TEST_F(CubeAndScale, TheScaleSaysThatPixelsAreNotCalibrated) {
    for (const bool isParallel : {true, false}) {
        scene::OrbitCamera camera = parallel(300);
        camera.isParallel = isParallel;
        MarkedPicture picture = pictureOf(camera);
        const auto calibrated = paintCubeAndScale(picture);
        ASSERT_TRUE(calibrated && scaleBarOf(picture));
        const QString text = scaleBarOf(picture)->text;
        picture.isCalibrated = false;
        const auto estimate = paintCubeAndScale(picture);
        ASSERT_TRUE(estimate);
        EXPECT_EQ(scaleBarOf(picture)->text, QStringLiteral("≈ ") + text);
        EXPECT_GE(estimate->size.width, calibrated->size.width);
        EXPECT_GT(estimate->size.height, calibrated->size.height);
        EXPECT_EQ(cornerOf(*estimate).y() + int(estimate->size.height),
                  cornerOf(*calibrated).y() + int(calibrated->size.height));
        EXPECT_GT(estimate->boxes.back().extent.height, calibrated->boxes.back().extent.height);
        EXPECT_EQ(cubeSideAt(picture, placeOf(picture, cubeMiddle(picture))), ViewDirection::anterior);
    }
}

TEST_F(CubeAndScale, WhatIsClickedIsTheSideThatIsSeen) {
    scene::OrbitCamera camera = parallel(300);
    const MarkedPicture front = pictureOf(camera);
    EXPECT_EQ(cubeSideAt(front, placeOf(front, cubeMiddle(front))), ViewDirection::anterior);
    camera.azimuthDeg = 40;
    const MarkedPicture turned = pictureOf(camera);
    const QPointF middle = cubeMiddle(turned);
    EXPECT_EQ(cubeSideAt(turned, placeOf(turned, middle - QPointF(8, 0))), ViewDirection::anterior);
    EXPECT_EQ(cubeSideAt(turned, placeOf(turned, middle + QPointF(22, 0))), ViewDirection::left);
    EXPECT_EQ(cubeSideAt(turned, placeOf(turned, middle + QPointF(60, 0))), std::nullopt);
    EXPECT_EQ(cubeSideAt(turned, {0.0, 0.0}), std::nullopt);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(cubeSideAt(turned, {nan, nan}), std::nullopt);
}

TEST_F(CubeAndScale, NoneWhereTheyWouldCoverThePictureOrMeanNothing) {
    EXPECT_EQ(paintCubeAndScale(pictureOf(parallel(300), {320, 240})), nullptr);
    EXPECT_EQ(paintCubeAndScale(pictureOf(parallel(300), {0, 0})), nullptr);
    EXPECT_EQ(cubeSideAt(pictureOf(parallel(300), {0, 0}), {0.9, -0.9}), std::nullopt);
    EXPECT_EQ(paintCubeAndScale(pictureOf(parallel(300), {800, 600}, 0.0)), nullptr);
    MarkedPicture nowhere = pictureOf(parallel(300));
    nowhere.camera.positionMm = nowhere.camera.targetMm;
    EXPECT_EQ(paintCubeAndScale(nowhere), nullptr);
    EXPECT_EQ(scaleBarOf(nowhere), std::nullopt);
    nowhere.camera.positionMm.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(paintCubeAndScale(nowhere), nullptr);
}

}  // namespace
}  // namespace macula::viewer
