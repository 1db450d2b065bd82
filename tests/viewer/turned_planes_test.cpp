// Planes that a person turns, the curve tool and its panel, and what a pane gives away, under a real hand.
#include <QClipboard>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <array>
#include <numbers>

#include "viewer/curve/curve_panel.h"
#include "viewer/curve/curve_view.h"
#include "viewer/panes/tool_box.h"
#include "viewer/slice_view_fixture.h"
#include "viewer/slices/measurement_list.h"
#include "viewer/slices/typed_window.h"

namespace macula::viewer {
namespace {

using slices::Orientation;

class TurnedPlanesTest : public SliceViewTest {
  protected:
    // Of the upper end of the pane's upright line, as long as nothing is turned and the cross-hair is in its
    // middle.
    static QPoint ring(const SliceView& view) { return {view.width() / 2, view.height() / 8}; }
    static QPoint turned(const SliceView& view, double deg) {
        const glm::dvec2 middle(view.width() / 2.0, view.height() / 2.0);
        const double radius = middle.y - view.height() / 8.0;
        const double angle = glm::radians(deg - 90.0);
        return {int(std::lround(middle.x + radius * std::cos(angle))),
                int(std::lround(middle.y + radius * std::sin(angle)))};
    }
    static void dragRing(SliceView& view, double deg, Qt::KeyboardModifiers modifiers) {
        QTest::mousePress(&view, Qt::LeftButton, modifiers, ring(view));
        for (const double share : {0.3, 0.7, 1.0}) {
            const QPoint place = turned(view, share * deg);
            QMouseEvent event(QEvent::MouseMove, place, view.mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                              modifiers);
            QApplication::sendEvent(&view, &event);
        }
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, turned(view, deg));
    }
    // Signed, about the axis.
    static double degBetween(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& axis) {
        return glm::degrees(std::atan2(glm::dot(glm::cross(a, b), axis), glm::dot(a, b)));
    }
};

TEST_F(TurnedPlanesTest, ARingTurnsTheOtherTwoPlanesAboutTheCrosshair) {
    showStudy();
    session_->change("Cross-hair",
                     [](scene::StudyState& next) { next.slices.crosshairMm = glm::dvec3(0.0, 0.0, 0.0); });
    const auto axial = pane(Orientation::axial);
    const auto coronal = pane(Orientation::coronal);
    const auto sagittal = pane(Orientation::sagittal);
    const slices::SliceFrame before = *axial->shownFrame();
    const glm::dvec3 coronalBefore = coronal->shownFrame()->plane.normal();
    dragRing(*axial, 28.0, Qt::ShiftModifier);  // in steps of 15 degrees
    ASSERT_TRUE(settled(*axial) && settled(*coronal) && settled(*sagittal));
    ASSERT_TRUE(state().slices.turn);
    EXPECT_LT(glm::distance(axial->shownFrame()->plane.right, before.plane.right), 1e-9)
        << "its own picture stays";
    const glm::dvec3 axis = before.plane.normal();
    const glm::dvec3 coronalNow = coronal->shownFrame()->plane.normal();
    EXPECT_NEAR(degBetween(coronalBefore, coronalNow, axis), 30.0, 1e-6) << "clockwise in the picture";
    EXPECT_NEAR(glm::dot(coronalNow, sagittal->shownFrame()->plane.normal()), 0.0, 1e-9);
    EXPECT_NEAR(coronal->shownFrame()->distanceMm(crosshair()), 0.0, 1e-9);
    EXPECT_TRUE(coronal->positionText().startsWith("Coronal, turned by 30.0°"))
        << coronal->positionText().toStdString();
    EXPECT_FALSE(axial->positionText().contains("turned"));

    // The wheel steps along the turned normal.
    turnWheel(*coronal, 1);
    ASSERT_TRUE(settled(*coronal));
    EXPECT_NEAR(std::abs(glm::dot(crosshair(), coronalNow)), 1.0, 1e-6);
    session_->undo();
    session_->undo();
    EXPECT_FALSE(state().slices.turn) << "one step";
}

TEST_F(TurnedPlanesTest, TheyCatchOnTheAxesAndStandStraightAgain) {
    showStudy();
    session_->change("Cross-hair",
                     [](scene::StudyState& next) { next.slices.crosshairMm = glm::dvec3(0.0, 0.0, 0.0); });
    const auto axial = pane(Orientation::axial);
    dragRing(*axial, 1.0, {});
    EXPECT_FALSE(state().slices.turn) << "less than the catch";
    dragRing(*axial, 20.0, {});
    ASSERT_TRUE(state().slices.turn);
    EXPECT_NEAR(glm::degrees(2.0 * std::acos(std::abs(state().slices.turn->w))), 20.0, 1.0);
    session_->undo();
    QTest::keyClick(axial.get(), Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(state().slices.turn);
    EXPECT_NEAR(glm::degrees(2.0 * std::acos(std::abs(state().slices.turn->w))), 15.0, 1e-6);
    ToolBox box(*session_);
    auto* straight = box.findChild<QAction*>("slices-straight");
    ASSERT_NE(straight, nullptr);
    EXPECT_TRUE(straight->isEnabled());
    straight->trigger();
    EXPECT_FALSE(state().slices.turn);
    EXPECT_FALSE(straight->isEnabled());
    session_->undo();
    EXPECT_TRUE(state().slices.turn);
}

// Two turns in two panes: a double oblique plane, in which the block lies where its centre is.
TEST_F(TurnedPlanesTest, DoubleObliquePlanesAreNotMirrored) {
    showStudy();
    const glm::dquat turn =
        glm::angleAxis(0.35, glm::dvec3(0, 0, 1)) * glm::angleAxis(0.25, glm::dvec3(1, 0, 0));
    session_->change("Turn", [&](scene::StudyState& next) {
        next.slices.crosshairMm = test::kBlockCentreMm;
        next.slices.turn = turn;
    });
    for (const Orientation orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        const auto view = pane(orientation);
        const glm::dvec2 white = middleOfWhite(pictureOf(*view));
        const QPoint expected = placeOf(*view, test::kBlockCentreMm);
        EXPECT_NEAR(white.x, expected.x(), 4.0) << int(orientation);
        EXPECT_NEAR(white.y, expected.y(), 4.0) << int(orientation);
        EXPECT_LT(white.x, 190.0) << int(orientation);
        EXPECT_GT(glm::dot(view->shownFrame()->plane.normal(), slices::planeOf(orientation, {}).normal()),
                  0.8);
    }
}

TEST_F(TurnedPlanesTest, TheCurveToolSetsMovesAndRemovesPoints) {
    showStudy();
    const auto axial = pane(Orientation::axial);
    axial->setTool(SliceTool::curve);
    const std::array places{QPoint(120, 200), QPoint(200, 230), QPoint(280, 200)};
    for (const QPoint& place : places) click(*axial, place);
    ASSERT_EQ(state().slices.curveMm.size(), 3u);
    EXPECT_LT(
        glm::distance(state().slices.curveMm[0], axial->shownFrame()->worldFromPicture(glm::dvec2(120, 200))),
        0.5);
    drag(*axial, Qt::LeftButton, places[1], {200, 260});
    ASSERT_EQ(state().slices.curveMm.size(), 3u) << "moved, not added";
    EXPECT_EQ(placeOf(*axial, state().slices.curveMm[1]).y(), 260);
    // On the curve between two points a click adds one there.
    const slices::Curve curve(state().slices.curveMm);
    const glm::dvec3 between = curve.at(0.25 * curve.lengthMm()).mm;
    click(*axial, placeOf(*axial, between));
    ASSERT_EQ(state().slices.curveMm.size(), 4u);
    EXPECT_LT(glm::distance(state().slices.curveMm[1], between), 0.5);
    session_->undo();
    // A vessel that runs through the planes: points at one place of several slices are in their order.
    session_->change("No curve", [](scene::StudyState& next) { next.slices.curveMm.clear(); });
    for (int slice = 0; slice < 3; ++slice) {
        click(*axial, {200, 200});
        turnWheel(*axial, 3);
        ASSERT_TRUE(settled(*axial));
    }
    ASSERT_EQ(state().slices.curveMm.size(), 3u);
    EXPECT_LT(state().slices.curveMm[0].z, state().slices.curveMm[1].z);
    EXPECT_LT(state().slices.curveMm[1].z, state().slices.curveMm[2].z);
    while (state().slices.curveMm.size() != 3u || state().slices.curveMm[0].z != state().slices.curveMm[2].z)
        session_->undo();
    click(*axial, placeOf(*axial, between));
    ASSERT_EQ(state().slices.curveMm.size(), 4u);
    QTest::keyClick(axial.get(), Qt::Key_Delete);
    EXPECT_EQ(state().slices.curveMm.size(), 3u);
    session_->undo();
    EXPECT_EQ(state().slices.curveMm.size(), 4u);
    session_->undo();
    session_->undo();
    EXPECT_EQ(placeOf(*axial, state().slices.curveMm[1]).y(), 230);
}

TEST_F(TurnedPlanesTest, ThePanelShowsTheCurvedPlaneAndGoesAlongIt) {
    showStudy();
    CurvePanel panel(*session_);
    panel.resize(700, 260);
    panel.show();
    EXPECT_FALSE(panel.view().picture());
    EXPECT_FALSE(panel.findChild<QPushButton*>("curve-follow")->isEnabled());
    session_->change("Curve", [](scene::StudyState& next) {
        next.slices.curveMm = {{-18.0, -9.0, 12.0}, {0.0, -9.0, 12.0}, {18.0, 5.0, -12.0}};
        next.slices.crosshairMm = glm::dvec3(0.0, -9.0, 12.0);
    });
    ASSERT_TRUE(waitUntil([&] { return panel.view().picture() && panel.isUpToDate(); }));
    const CurvePicture& picture = *panel.view().picture();
    EXPECT_EQ(picture.curved.size(), QSize(picture.frame->sizePx().x, picture.frame->sizePx().y));
    // The block is on the curve, 5 mm from its beginning.
    const auto column = int(5.0 / picture.frame->mmPerPixel());
    EXPECT_EQ(qGray(picture.curved.pixel(column, picture.curved.height() / 2)), 255);
    EXPECT_LT(qGray(picture.curved.pixel(picture.curved.width() - 5, picture.curved.height() / 2)), 10);

    QPointF place(0.0, panel.view().height() / 2.0);
    while (!panel.view().lengthAt(place) && place.x() < panel.width()) place.rx() += 1.0;
    place.rx() += 12.0;
    const auto mm = panel.view().worldAt(place);
    ASSERT_TRUE(mm);
    QTest::mouseClick(&panel.view(), Qt::LeftButton, {}, place.toPoint());
    EXPECT_LT(glm::distance(crosshair(), *mm), 1.0);
    ASSERT_TRUE(waitUntil([&] { return panel.isUpToDate(); }));
    const double at = panel.view().picture()->of.sectionAtMm;
    QTest::keyClick(&panel.view(), Qt::Key_Right);
    ASSERT_TRUE(waitUntil([&] {
        return panel.isUpToDate() && std::abs(panel.view().picture()->of.sectionAtMm - at - 1.0) < 0.05;
    }));

    panel.findChild<QPushButton*>("curve-across")->click();
    ASSERT_TRUE(state().slices.turn);
    const slices::Curve curve(state().slices.curveMm);
    const glm::dvec3 along = curve.at(curve.nearestMm(crosshair())).along;
    const glm::dvec3 axial = *state().slices.turn * glm::dvec3(0.0, 0.0, 1.0);
    EXPECT_NEAR(std::abs(glm::dot(along, axial)), 1.0, 1e-9);
    panel.findChild<QPushButton*>("curve-remove")->click();
    EXPECT_TRUE(state().slices.curveMm.empty());
    EXPECT_FALSE(panel.view().picture());
}

TEST_F(TurnedPlanesTest, TheListGoesToAMeasurementEvenOnATurnedPlane) {
    showStudy();
    const glm::dquat turn = glm::angleAxis(0.5, glm::dvec3(1.0, 0.0, 0.0));
    const slices::SlicePlane plane =
        slices::tilted(slices::planeOf(Orientation::axial, {2.0, 3.0, -4.0}), turn);
    session_->change("Drawn", [&](scene::StudyState& next) {
        next.measurements = {
            {.label = "straight", .shape = slices::Distance{{glm::dvec3(-5, 0, 8), {5, 0, 8}}}},
            {.label = "turned",
             .shape = slices::Ellipse{.plane = plane, .radiiMm = {3.0, 2.0}},
             .normal = plane.normal()}};
    });
    const auto axial = pane(Orientation::axial);
    MeasurementList list(*session_);
    list.resize(400, 200);
    list.show();
    ASSERT_EQ(list.topLevelItemCount(), 2);
    EXPECT_EQ(list.topLevelItem(0)->text(1), "10.0 mm");
    EXPECT_EQ(list.topLevelItem(0)->text(2), "15");
    const auto clickOn = [&](int row) {
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                          list.visualItemRect(list.topLevelItem(row)).center());
    };
    clickOn(1);
    ASSERT_TRUE(state().slices.turn);
    EXPECT_LT(glm::distance(crosshair(), plane.centreMm), 1e-9);
    ASSERT_TRUE(settled(*axial));
    EXPECT_NEAR(std::abs(glm::dot(axial->shownFrame()->plane.normal(), plane.normal())), 1.0, 1e-9);
    clickOn(0);
    EXPECT_FALSE(state().slices.turn) << "straight again: it was drawn on a straight plane";
    EXPECT_EQ(crosshair(), glm::dvec3(0, 0, 8));
    list.topLevelItem(0)->setText(0, "aorta");
    EXPECT_TRUE(waitUntil([&] { return state().measurements[0].label == "aorta"; }));
    list.setCurrentItem(list.topLevelItem(1));
    QTest::keyClick(&list, Qt::Key_Delete);
    ASSERT_EQ(state().measurements.size(), 1u);
    EXPECT_EQ(list.topLevelItemCount(), 1);
    session_->undo();
    EXPECT_EQ(list.topLevelItemCount(), 2);
}

TEST_F(TurnedPlanesTest, APaneIsCopiedAsItIsOnScreen) {
    showStudy();
    const auto axial = pane(Orientation::axial);
    QGuiApplication::clipboard()->clear();
    QTest::keyClick(axial.get(), Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QGuiApplication::clipboard()->image().size(), axial->grab().size());
}

TEST_F(TurnedPlanesTest, ValuesAreSeenInColours) {
    showStudy();
    session_->change("Cross-hair",
                     [](scene::StudyState& next) { next.slices.crosshairMm = test::kBlockCentreMm; });
    const auto axial = pane(Orientation::axial);
    session_->change("Colours",
                     [](scene::StudyState& next) { next.slices.colours = slices::ColourTable::green; });
    ASSERT_TRUE(settled(*axial));
    const slices::Rgb full = slices::colourOf(slices::ColourTable::green, 255);
    EXPECT_EQ(pictureOf(*axial).pixel(placeOf(*axial, test::kBlockCentreMm + glm::dvec3(1.5, 1.5, 0.0))),
              qRgb(full.red, full.green, full.blue));
}

TEST_F(TurnedPlanesTest, AWindowIsTypedAndTakenBack) {
    showStudy();
    QWidget parent;
    askForWindow(*session_, &parent);
    auto* dialog = parent.findChild<QDialog*>("window-dialog");
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QDoubleSpinBox*>("window-width")->setValue(300.0);
    dialog->findChild<QDoubleSpinBox*>("window-level")->setValue(-40.0);
    ASSERT_TRUE(state().slices.window);
    EXPECT_EQ(state().slices.window->width, 300.0);
    EXPECT_EQ(state().slices.window->center, -40.0);
    dialog->reject();
    EXPECT_FALSE(state().slices.window) << "taken back as one step";
    askForWindow(*session_, &parent);
    for (QDialog* each : parent.findChildren<QDialog*>("window-dialog")) {
        if (!each->isVisible()) continue;
        each->findChild<QDoubleSpinBox*>("window-width")->setValue(80.0);
        each->accept();
    }
    EXPECT_EQ(state().slices.window->width, 80.0);
    session_->undo();
    EXPECT_FALSE(state().slices.window);
}

}  // namespace
}  // namespace macula::viewer
