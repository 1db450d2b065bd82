// Lesions, Cobb angles, arrows, outlines and lines: how they are drawn, moved by their handles, and named.
#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>
#include <array>
#include <numbers>

#include "viewer/overlay/freehand_handles.h"
#include "viewer/overlay/measurement_handles.h"
#include "viewer/pick/distance_in_3d.h"
#include "viewer/slice_view_fixture.h"
#include "viewer/slices/measurement_list.h"
#include "viewer/slices/slice_popups.h"

namespace macula::viewer {
namespace {

using slices::Orientation;

slices::SlicePlane axialAt(double z) {
    return slices::planeOf(Orientation::axial, {0.0, 0.0, z});
}

glm::dvec3 normal() {
    return axialAt(0.0).normal();
}

// Both axes cross at a right angle.
void expectCrossing(const slices::Bidirectional& lesion) {
    const glm::dvec3 along = lesion.firstMm[1] - lesion.firstMm[0];
    const glm::dvec3 across = lesion.secondMm[1] - lesion.secondMm[0];
    EXPECT_NEAR(glm::dot(glm::normalize(along), glm::normalize(across)), 0.0, 1e-12);
    const double part = glm::dot(lesion.secondMm[0] - lesion.firstMm[0], along) / glm::dot(along, along);
    EXPECT_GE(part, -1e-12);
    EXPECT_LE(part, 1.0 + 1e-12);
    const glm::dvec3 side = glm::cross(normal(), along);
    EXPECT_LE(glm::dot(lesion.secondMm[0] - lesion.firstMm[0], side) *
                  glm::dot(lesion.secondMm[1] - lesion.firstMm[0], side),
              1e-9);
}

TEST(LesionDrawing, TheThirdPointSaysHowFarTheShortAxisReaches) {
    MeasurementDrawing drawing(SliceTool::bidirectional, axialAt(0.0), {0.0, 0.0, 0.0}, 0.1);
    drawing.move({40.0, 0.0, 0.0}, true);
    drawing.release({40.0, 0.0, 0.0});
    EXPECT_FALSE(drawing.isComplete()) << "nobody has said how wide it is";
    EXPECT_TRUE(std::holds_alternative<slices::Distance>(drawing.soFar()->shape));
    drawing.move({5.0, 3.0, 0.0});
    EXPECT_EQ(slices::axesOf(std::get<slices::Bidirectional>(drawing.soFar()->shape)).shortMm, 6.0);
    drawing.press({11.0, 0.0, 0.0});
    EXPECT_FALSE(drawing.isComplete()) << "on the line, it has no width";
    drawing.press({33.0, -9.0, 0.0});
    ASSERT_TRUE(drawing.isComplete());
    const auto lesion = std::get<slices::Bidirectional>(drawing.soFar()->shape);
    expectCrossing(lesion);
    EXPECT_DOUBLE_EQ(slices::axesOf(lesion).longMm, 40.0);
    EXPECT_DOUBLE_EQ(slices::axesOf(lesion).shortMm, 18.0);
    EXPECT_LT(glm::distance(0.5 * (lesion.secondMm[0] + lesion.secondMm[1]), glm::dvec3(20.0, 0.0, 0.0)),
              1e-12);
}

TEST(LesionHandles, KeepTheAxesPerpendicularAndCrossing) {
    const slices::Measurement drawn{.shape = slices::Bidirectional{.firstMm = {{{0, 0, 0}, {40, 0, 0}}},
                                                                   .secondMm = {{{20, -9, 0}, {20, 9, 0}}}},
                                    .normal = normal()};
    const auto moved = [&](std::size_t handle, const glm::dvec3& mm) {
        const auto lesion = std::get<slices::Bidirectional>(withHandleAt(drawn, handle, mm).shape);
        expectCrossing(lesion);
        return lesion;
    };
    // An end of the short axis moves it along the long one, and the other end keeps its distance.
    const auto along = moved(3, {30.0, 14.0, 0.0});
    EXPECT_LT(glm::distance(along.secondMm[1], glm::dvec3(30.0, 14.0, 0.0)), 1e-12);
    EXPECT_LT(glm::distance(along.secondMm[0], glm::dvec3(30.0, -9.0, 0.0)), 1e-12);
    EXPECT_EQ(moved(2, {-90.0, -4.0, 0.0}).secondMm[0].x, 0.0) << "not beyond the long axis";
    EXPECT_LT(glm::distance(moved(2, {20.0, 7.0, 0.0}).secondMm[0], glm::dvec3(20.0, 0.0, 0.0)), 1e-12)
        << "not to the other side";
    // An end of the long axis takes the short one with it, as long as it was.
    const auto turned = moved(1, {0.0, 30.0, 0.0});
    EXPECT_NEAR(slices::axesOf(turned).longMm, 30.0, 1e-12);
    EXPECT_NEAR(slices::axesOf(turned).shortMm, 18.0, 1e-12);
    EXPECT_LT(glm::distance(0.5 * (turned.secondMm[0] + turned.secondMm[1]), glm::dvec3(0.0, 15.0, 0.0)),
              1e-12);
    EXPECT_EQ(withHandleAt(drawn, 1, {0.0, 0.0, 0.0}), drawn) << "no length would be left";
    slices::Measurement node = drawn;
    std::get<slices::Bidirectional>(node.shape).isNode = true;
    EXPECT_TRUE(std::get<slices::Bidirectional>(withHandleAt(node, 3, {20, 14, 0}).shape).isNode);
    const slices::Measurement hostile{.shape = slices::Bidirectional{}, .normal = normal()};
    EXPECT_EQ(withHandleAt(hostile, 2, {1, 1, 0}), hostile);
}

TEST(CobbDrawing, HasTwoLinesByDragsOrClicks) {
    MeasurementDrawing dragged(SliceTool::cobb, axialAt(0.0), {0.0, 0.0, 0.0}, 0.1);
    dragged.release({10.0, 0.0, 0.0});
    EXPECT_TRUE(std::holds_alternative<slices::Distance>(dragged.soFar()->shape)) << "its first line";
    dragged.press({0.0, 20.0, 0.0});
    dragged.move({5.0, 25.0, 0.0}, true);
    EXPECT_NEAR(slices::angleDeg(std::get<slices::CobbAngle>(dragged.soFar()->shape)), 45.0, 1e-9);
    dragged.release({10.0, 20.0, 0.0});
    ASSERT_TRUE(dragged.isComplete());
    EXPECT_NEAR(slices::angleDeg(std::get<slices::CobbAngle>(dragged.soFar()->shape)), 0.0, 1e-9);
    const slices::Measurement cobb = *dragged.soFar();
    EXPECT_EQ(linesOf(cobb).size(), 2u) << "no line joins them";
    EXPECT_NEAR(slices::angleDeg(std::get<slices::CobbAngle>(withHandleAt(cobb, 3, {0, 30, 0}).shape)), 90.0,
                1e-9);
}

TEST(FreehandDrawing, FollowsADragAndDropsWhatOvershot) {
    MeasurementDrawing drawing(SliceTool::outline, axialAt(2.0), {20.0, 0.0, 2.0}, 0.3);
    // A bit more than once around a circle of 20 mm.
    for (int i = 1; i <= 370; ++i) {
        const double turn = i * std::numbers::pi / 180.0;
        drawing.move(
            {(20.0 + (i > 350 ? 0.05 * (i - 350) : 0.0)) * std::cos(turn), 20.0 * std::sin(turn), 2.0}, true);
    }
    EXPECT_FALSE(drawing.isComplete());
    drawing.release({20.0, 4.0, 2.0});
    ASSERT_TRUE(drawing.isComplete());
    const auto outline = std::get<slices::Outline>(drawing.soFar()->shape);
    EXPECT_NEAR(slices::areaMm2(outline), 400.0 * std::numbers::pi, 0.03 * 400.0 * std::numbers::pi);
    EXPECT_LT(outline.pointsMm.size(), 100u);
    for (const glm::dvec3& mm : outline.pointsMm) EXPECT_NEAR(mm.z, 2.0, 1e-9);
}

TEST(FreehandDrawing, GoesFromClickToClickUntilTheLastIsClickedAgain) {
    MeasurementDrawing line(SliceTool::line, axialAt(0.0), {0.0, 0.0, 0.0}, 0.3);
    line.release({0.1, 0.0, 0.0});
    line.press({3.0, 0.0, 0.0});
    line.release({3.0, 0.1, 0.0});
    line.move({3.0, 2.0, 0.0});
    EXPECT_NEAR(slices::lengthMm(std::get<slices::OpenLine>(line.soFar()->shape)), 5.0, 1e-9);
    line.press({3.0, 4.0, 0.0});
    line.release({3.0, 4.0, 0.0});
    EXPECT_FALSE(line.isComplete());
    line.press({3.0, 4.0, 0.0});
    ASSERT_TRUE(line.isComplete());
    EXPECT_NEAR(slices::lengthMm(std::get<slices::OpenLine>(line.soFar()->shape)), 7.0, 1e-9);

    MeasurementDrawing outline(SliceTool::outline, axialAt(0.0), {0.0, 0.0, 0.0}, 0.3);
    outline.press({4.0, 0.0, 0.0});
    outline.press({4.0, 0.0, 0.0});
    EXPECT_FALSE(outline.isComplete()) << "two points have no area";
    outline.press({4.0, 3.0, 0.0});
    outline.press({0.1, 0.0, 0.0});
    ASSERT_TRUE(outline.isComplete()) << "its first point closes it";
    EXPECT_NEAR(slices::areaMm2(std::get<slices::Outline>(outline.soFar()->shape)), 6.0, 1e-9);
}

TEST(FreehandHandles, BendALineAsFarAsTheNextOnesAndBack) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 80; ++i) points.emplace_back(i, 0.0, 0.0);
    EXPECT_EQ(freehandHandles(points, Freehand::open).size(), 8u);
    EXPECT_EQ(freehandHandles(points, Freehand::open).front(), points.front());
    EXPECT_EQ(freehandHandles(points, Freehand::open).back(), points.back());
    EXPECT_EQ(freehandHandles(points, Freehand::closed).size(), 9u);
    const glm::dvec3 by(0.0, 5.0, 0.0);
    for (const Freehand kind : {Freehand::open, Freehand::closed}) {
        for (std::size_t handle = 0; handle < 8; ++handle) {
            const auto bent = withFreehandMoved(points, handle, by, kind);
            const auto before = freehandHandles(points, kind);
            const auto after = freehandHandles(bent, kind);
            for (std::size_t other = 0; other < 8; ++other)
                EXPECT_LT(glm::distance(after[other] - before[other], other == handle ? by : glm::dvec3(0.0)),
                          1e-12);
            const auto back = withFreehandMoved(bent, handle, -by, kind);
            for (std::size_t i = 0; i < points.size(); ++i)
                EXPECT_LT(glm::distance(back[i], points[i]), 1e-12);
        }
    }
    const auto shifted = withFreehandMoved(points, 8, by, Freehand::closed);
    EXPECT_EQ(shifted[17], points[17] + by);
    EXPECT_EQ(withFreehandMoved(points, 8, by, Freehand::open), points);
    EXPECT_TRUE(freehandHandles({}, Freehand::closed).empty());
    EXPECT_TRUE(freehandHandles({{1, 1, 1}}, Freehand::open).empty());
    EXPECT_EQ(withFreehandMoved({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 2, by, Freehand::closed)[2].y, 6.0);
}

class DrawnMeasurementsTest : public SliceViewTest {
  protected:
    // The text beside what was measured last.
    QString textBeside() {
        MeasurementTexts texts;
        return texts.of(state().measurements.back(), session_->study().measured());
    }
};

TEST_F(DrawnMeasurementsTest, ALesionIsADragAndAClickAndMayBeANode) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::bidirectional);
    drag(*view, Qt::LeftButton, {100, 200}, {200, 200});
    EXPECT_TRUE(state().measurements.empty());
    move(*view, {150, 220}, Qt::NoButton);
    click(*view, {140, 230});
    ASSERT_EQ(state().measurements.size(), 1u);
    const auto axes = slices::axesOf(std::get<slices::Bidirectional>(state().measurements[0].shape));
    const double mmPerPx = view->shownFrame()->mmPerPixel * view->devicePixelRatioF();
    EXPECT_NEAR(axes.longMm, 100.0 * mmPerPx, 1e-9);
    EXPECT_NEAR(axes.shortMm, 60.0 * mmPerPx, 1e-9);
    EXPECT_EQ(view->selected(), 0u);
    const QString text = textBeside();
    EXPECT_TRUE(text.contains(QStringLiteral(" × "))) << text.toStdString();

    QTest::mousePress(view.get(), Qt::RightButton, {}, {150, 200});
    QTest::mouseRelease(view.get(), Qt::RightButton, {}, {150, 200});
    auto* menu = view->findChild<QMenu*>();
    ASSERT_NE(menu, nullptr);
    auto* node = menu->findChild<QAction*>(QStringLiteral("lymph-node"));
    ASSERT_NE(node, nullptr);
    EXPECT_FALSE(node->isChecked());
    node->trigger();
    menu->close();
    EXPECT_TRUE(std::get<slices::Bidirectional>(state().measurements[0].shape).isNode);
    EXPECT_EQ(textBeside(), text + QStringLiteral(", lymph node"));
    session_->undo();
    EXPECT_FALSE(std::get<slices::Bidirectional>(state().measurements[0].shape).isNode);
    session_->undo();
    EXPECT_TRUE(state().measurements.empty());
}

TEST_F(DrawnMeasurementsTest, AnArrowAsksForItsWordsAtOnce) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::arrow);
    drag(*view, Qt::LeftButton, {200, 200}, {260, 150});
    ASSERT_EQ(state().measurements.size(), 1u);
    auto* editor = view->findChild<LabelEditor*>();
    ASSERT_NE(editor, nullptr);
    QTest::keyClicks(editor, QStringLiteral("Cyst?"));
    QTest::keyClick(editor, Qt::Key_Return);
    EXPECT_EQ(state().measurements[0].label, "Cyst?");
    EXPECT_EQ(textBeside(), QStringLiteral("Cyst?")) << "and nothing else";
    const auto& arrow = std::get<slices::Arrow>(state().measurements[0].shape);
    EXPECT_LT(glm::distance(placeOf(*view, arrow.tipMm).x() - 200.0, 0.0), 1.5);
    session_->undo();
    session_->undo();
    EXPECT_TRUE(state().measurements.empty());
}

TEST_F(DrawnMeasurementsTest, AnOutlineOfWaterHasItsAreaAndValues) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::outline);
    QTest::mousePress(view.get(), Qt::LeftButton, {}, {230, 230});
    for (const QPoint at : {QPoint(270, 230), QPoint(310, 230), QPoint(310, 260), QPoint(310, 290),
                            QPoint(270, 290), QPoint(230, 290), QPoint(230, 260)})
        move(*view, at, Qt::LeftButton);
    QTest::mouseRelease(view.get(), Qt::LeftButton, {}, {230, 240});
    ASSERT_EQ(state().measurements.size(), 1u);
    const double mmPerPx = view->shownFrame()->mmPerPixel * view->devicePixelRatioF();
    const auto values = slices::valuesIn(state().measurements[0], *session_->study().measured());
    ASSERT_TRUE(values);
    EXPECT_DOUBLE_EQ(values->mean, 0.0);
    EXPECT_NEAR(values->areaMm2, 4800.0 * mmPerPx * mmPerPx, 1e-6);
    // Its centre moves it, and a click on its line selects it.
    const auto handles = handlesOf(state().measurements[0]);
    view->setTool(SliceTool::crosshair);
    const QPoint centre = placeOf(*view, handles.back());
    drag(*view, Qt::LeftButton, centre, centre + QPoint(-10, -10));
    const auto moved = slices::valuesIn(state().measurements[0], *session_->study().measured());
    ASSERT_TRUE(moved);
    EXPECT_NEAR(moved->areaMm2, values->areaMm2, 1e-6);
    EXPECT_GT(glm::distance(handlesOf(state().measurements[0]).back(), handles.back()), 5.0 * mmPerPx);
    QTest::keyClick(view.get(), Qt::Key_Delete);
    EXPECT_TRUE(state().measurements.empty());
}

TEST_F(DrawnMeasurementsTest, ALineByClicksEndsWithADoubleClick) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::line);
    bool isMaximized = false;
    QObject::connect(view.get(), &SliceView::maximizeAsked, [&] { isMaximized = true; });
    click(*view, {100, 200});
    click(*view, {160, 200});
    click(*view, {160, 280});
    QTest::mouseDClick(view.get(), Qt::LeftButton, {}, {160, 280});
    ASSERT_EQ(state().measurements.size(), 1u);
    EXPECT_FALSE(isMaximized);
    const double mmPerPx = view->shownFrame()->mmPerPixel * view->devicePixelRatioF();
    EXPECT_NEAR(slices::lengthMm(std::get<slices::OpenLine>(state().measurements[0].shape)), 140.0 * mmPerPx,
                1e-6);
}

// The list has a row for each kind, and goes to it.
TEST_F(DrawnMeasurementsTest, AreListedWithTheirValues) {
    showStudy();
    const auto view = pane(Orientation::axial);
    session_->change("all", [](scene::StudyState& next) {
        next.measurements = {
            {.label = "L1",
             .shape = slices::Bidirectional{.firstMm = {{{-5, 0, 0}, {5, 0, 0}}},
                                            .secondMm = {{{0, -2, 0}, {0, 2, 0}}}},
             .normal = normal()},
            {.label = "Words", .shape = slices::Arrow{{1, 1, 0}, {4, 4, 0}}, .normal = normal()},
            {.shape = slices::OpenLine{{{0, 0, 0}, {3, 4, 0}}}, .normal = normal()},
            {.shape = slices::CobbAngle{{glm::dvec3(0, 0, 0), {5, 0, 0}, {0, 2, 0}, {5, 7, 0}}},
             .normal = normal()},
            {.shape = slices::Outline{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}}, .normal = normal()}};
    });
    ASSERT_TRUE(settled(*view));
    MeasurementList list(*session_);
    list.show();
    ASSERT_EQ(list.topLevelItemCount(), 5);
    EXPECT_EQ(list.topLevelItem(0)->text(0), QStringLiteral("L1"));
    EXPECT_EQ(list.topLevelItem(0)->text(1), QStringLiteral("10.0 × 4.0 mm"));
    EXPECT_EQ(list.topLevelItem(1)->text(0), QStringLiteral("Words"));
    EXPECT_EQ(list.topLevelItem(1)->text(1), QString());
    EXPECT_EQ(list.topLevelItem(2)->text(1), QStringLiteral("5.0 mm"));
    EXPECT_EQ(list.topLevelItem(3)->text(1), QStringLiteral("45.0°"));
    EXPECT_TRUE(list.topLevelItem(4)->text(1).endsWith(QStringLiteral("8.00 mm²")));
    const QImage picture = pictureOf(*view);  // paints all of them
    EXPECT_FALSE(picture.isNull());
}

// Seen from the front with parallel rays of 100 mm: what lies 25 mm to the left of the middle is half way to
// the edge.
TEST_F(DrawnMeasurementsTest, ADistanceIn3dIsTheStraightLineBetweenTwoPlaces) {
    showStudy();
    DistanceIn3d tool(*session_);
    const PictureGeometry picture{.camera = {.positionMm = {0, -300, 0},
                                             .targetMm = {0, 0, 0},
                                             .up = {0, 0, 1},
                                             .parallelHeightMm = 100.0},
                                  .aspect = 1.0,
                                  .sizePx = {400, 400}};
    tool.setOut(true);
    EXPECT_TRUE(tool.marks(picture).empty());
    EXPECT_FALSE(tool.add({25, 10, 25}));
    ASSERT_EQ(tool.marks(picture).size(), 1u);
    EXPECT_NEAR(tool.marks(picture)[0].place.x, 0.5, 1e-9);
    EXPECT_NEAR(tool.marks(picture)[0].place.y, 0.5, 1e-9);
    EXPECT_FALSE(tool.add({25, 10, 25})) << "it has no length";
    const auto made = tool.add({-5, 50, 25});
    ASSERT_TRUE(made);
    ASSERT_EQ(state().measurements.size(), 1u);
    EXPECT_EQ(state().measurements[0], *made);
    EXPECT_DOUBLE_EQ(slices::lengthMm(std::get<slices::Distance>(made->shape)), 50.0);
    EXPECT_NEAR(glm::dot(made->normal, glm::dvec3(-30, 40, 0)), 0.0, 1e-9) << "a plane can show all of it";
    const auto marks = tool.marks(picture);
    EXPECT_GT(marks.size(), 5u);
    for (const ToolMark& mark : marks) {
        EXPECT_NEAR(mark.place.y, 0.5, 1e-9);
        EXPECT_LE(mark.place.x, 0.5 + 1e-9);
        EXPECT_GE(mark.place.x, -0.1 - 1e-9);
    }
    tool.setOut(false);
    EXPECT_TRUE(tool.marks(picture).empty());
    session_->undo();
    EXPECT_TRUE(state().measurements.empty());
}

}  // namespace
}  // namespace macula::viewer
