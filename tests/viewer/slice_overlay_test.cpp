// What is drawn over the picture of a slice: where the cross-hair leaves texts free.
#include "viewer/overlay/slice_overlay.h"

#include <gtest/gtest.h>

#include <QImage>

#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

constexpr QSize kPane(400, 300);
constexpr int kMarginPx = 8;

class SliceOverlayTest : public test::OffscreenTest {
  protected:
    static SliceOverlay coronal() {
        SliceOverlay overlay;
        overlay.orientation = slices::Orientation::coronal;
        overlay.frame.plane = slices::planeOf(slices::Orientation::coronal, {});
        overlay.frame.sizePx = {kPane.width(), kPane.height()};
        return overlay;
    }
    static QImage painted(const SliceOverlay& overlay) {
        QImage image(kPane, QImage::Format_RGB32);
        image.fill(QColor(60, 60, 60));
        QPainter painter(&image);
        paintOverlay(painter, kPane, overlay);
        return image;
    }
    // Both with the cross-hair through the middle and without.
    static bool isFreeIn(const SliceOverlay& overlay, const QRect& place) {
        SliceOverlay crossed = overlay;
        crossed.crosshairMm = glm::dvec3(0.0);
        return painted(crossed).copy(place) == painted(overlay).copy(place);
    }
};

// An I with a line through it is a line.
TEST_F(SliceOverlayTest, TheCrossHairLeavesLettersOfTheSidesFree) {
    const SliceOverlay overlay = coronal();
    const int middle = kPane.width() / 2;
    EXPECT_TRUE(isFreeIn(overlay, {middle - 3, kPane.height() - kMarginPx - 16, 7, 12})) << "I";
    EXPECT_TRUE(isFreeIn(overlay, {middle - 3, kMarginPx + 4, 7, 12})) << "S";
    EXPECT_TRUE(isFreeIn(overlay, {kMarginPx, kPane.height() / 2 - 4, 8, 9})) << "R";
    EXPECT_FALSE(isFreeIn(overlay, {middle - 3, 200, 7, 12})) << "elsewhere it is seen";
    EXPECT_FALSE(isFreeIn(overlay, {300, kPane.height() / 2 - 4, 8, 9}));
}

TEST_F(SliceOverlayTest, TheCrossHairLeavesLinesOfTextFree) {
    SliceOverlay overlay = coronal();
    const QRect below(kPane.width() / 2 - 3, kMarginPx + 4, 7, 3 * 12);
    EXPECT_FALSE(isFreeIn(overlay, below));
    overlay.names = QStringList(6, QString(200, QLatin1Char('n')));
    EXPECT_TRUE(isFreeIn(overlay, below));
}

// Half a warning warns of something else: what does not fit into one line goes on in the next.
TEST_F(SliceOverlayTest, WhatMustNotBeCutOffGoesOnInTheNextLine) {
    const QString first = QStringList(10, QStringLiteral("wide")).join(QLatin1Char(' '));
    const auto differs = [&](auto part, int top, int bottom) {
        SliceOverlay one = coronal();
        SliceOverlay other = coronal();
        (one.*part) = {first + QStringLiteral(" and so it goes on: ends well")};
        (other.*part) = {first + QStringLiteral(" and so it goes on: ends badly")};
        const QRect place(0, top, kPane.width(), bottom - top);
        return painted(one).copy(place) != painted(other).copy(place);
    };
    EXPECT_TRUE(differs(&SliceOverlay::notes, 0, 80));
    EXPECT_TRUE(differs(&SliceOverlay::tags, 0, 80));
    EXPECT_TRUE(differs(&SliceOverlay::facts, kPane.height() - 80, kPane.height()));
    // Descriptions would hide the picture: they stay in one line, whose end is seen.
    EXPECT_TRUE(differs(&SliceOverlay::names, 0, 80));
    SliceOverlay one = coronal();
    SliceOverlay other = coronal();
    one.names = {first + QStringLiteral(" one ") + first};
    other.names = {first + QStringLiteral(" other ") + first};
    EXPECT_EQ(painted(one), painted(other));
}

// One word that is longer than the pane, and a text of hundreds, leave the picture free.
TEST_F(SliceOverlayTest, TextsWithoutEndTakeFourLines) {
    SliceOverlay overlay = coronal();
    overlay.notes = {QString(500, QLatin1Char('w')),
                     QStringList(300, QStringLiteral("wide")).join(QLatin1Char(' '))};
    const QRect below(0, 8 * 16, kPane.width(), kPane.height() - 8 * 16);
    SliceOverlay cut = coronal();
    cut.notes = {QString(500, QLatin1Char('w')), QString(300, QLatin1Char('w'))};
    EXPECT_EQ(painted(overlay).copy(below), painted(cut).copy(below));
    overlay.notes.clear();
    overlay.tags = {QString(), QStringLiteral(" ")};
    EXPECT_EQ(painted(overlay), painted(coronal()));
}

// Beside the scale, and nowhere else: what is drawn in the rest of the pane is the same.
TEST_F(SliceOverlayTest, TheScaleSaysThatPixelsAreNotCalibrated) {
    const SliceOverlay calibrated = coronal();
    SliceOverlay estimate = coronal();
    estimate.isCalibrated = false;
    EXPECT_NE(painted(calibrated), painted(estimate));
    const QRect corner(kPane.width() / 2, kPane.height() - 40, kPane.width() / 2, 40);
    EXPECT_NE(painted(calibrated).copy(corner), painted(estimate).copy(corner));
    const QRect above(0, 0, kPane.width(), kPane.height() - 40);
    EXPECT_EQ(painted(calibrated).copy(above), painted(estimate).copy(above));
}

TEST_F(SliceOverlayTest, ACrossHairOutsideOfThePaneIsNotDrawn) {
    SliceOverlay overlay = coronal();
    overlay.crosshairMm = glm::dvec3(1e6, 1e6, 1e6);
    SliceOverlay without = coronal();
    EXPECT_EQ(painted(overlay), painted(without));
}

}  // namespace
}  // namespace macula::viewer
