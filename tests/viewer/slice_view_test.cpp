// A pane of slices under a real hand.
#include "viewer/slices/slice_view.h"

#include <QHelpEvent>
#include <QMenu>
#include <QToolTip>
#include <algorithm>
#include <numbers>

#include "scene/drawing/projection_windows.h"
#include "viewer/slice_view_fixture.h"
#include "viewer/slices/slice_popups.h"

namespace macula::viewer {
namespace {

using slices::Orientation;

TEST_F(SliceViewTest, WithoutAStudyItIsBlackAndTakesAnyEvent) {
    const auto view = pane(Orientation::axial);
    for (const int key : {Qt::Key_Up, Qt::Key_Home, Qt::Key_Plus, Qt::Key_Delete, Qt::Key_I, Qt::Key_3})
        QTest::keyClick(view.get(), Qt::Key(key));
    click(*view, {100, 100});
    turnWheel(*view, 1);
    view->setCine(true);
    view->fit();
    EXPECT_FALSE(view->isCineOn());
    EXPECT_FALSE(session_->canUndo());
    EXPECT_EQ(pictureOf(*view).pixel(5, 200), qRgb(0, 0, 0));
    EXPECT_EQ(view->accessibleName(), "Axial slices");
}

TEST_F(SliceViewTest, NothingIsMirrored) {
    showStudy();
    session_->change("Cross-hair",
                     [](scene::StudyState& next) { next.slices.crosshairMm = test::kBlockCentreMm; });
    // The patient's right is at the left of an axial and a coronal picture, anterior at the left of a
    // sagittal one, and the head is up.
    for (const Orientation orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        const auto view = pane(orientation);
        const glm::dvec2 white = middleOfWhite(pictureOf(*view));
        EXPECT_LT(white.x, 170.0) << int(orientation);
        EXPECT_LT(white.y, 170.0) << int(orientation);
        const QPoint expected = placeOf(*view, test::kBlockCentreMm);
        EXPECT_NEAR(white.x, expected.x(), 2.0) << int(orientation);
        EXPECT_NEAR(white.y, expected.y(), 2.0) << int(orientation);
    }
}

TEST_F(SliceViewTest, SegmentsLieOverTheirVoxelsAndTheProbeNamesThem) {
    showStudy();
    session_->change("Cross-hair",
                     [](scene::StudyState& next) { next.slices.crosshairMm = test::kBlockCentreMm; });
    VoxelSet set({4, 3, 14}, {10, 9, 18});  // the white block
    for (int k = 14; k <= 18; ++k)
        for (int j = 3; j <= 9; ++j)
            for (int i = 4; i <= 10; ++i) set.add({i, j, k});
    slices::ShownSegment block;
    block.voxels = std::make_shared<const VoxelSet>(std::move(set));
    block.label = "Block";
    block.rgb = {0, 200, 0};
    block.opacity = 1.0;
    for (const Orientation orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        const auto view = pane(orientation);
        const QImage before = pictureOf(*view);
        view->setSegments(std::make_shared<const slices::ShownSegments>(slices::ShownSegments{block}));
        ASSERT_TRUE(settled(*view));
        const QImage with = pictureOf(*view);
        int covered = 0;
        for (int y = 0; y < before.height(); ++y) {
            for (int x = 0; x < before.width(); ++x) {
                if (before.pixel(x, y) != qRgb(255, 255, 255)) continue;
                ASSERT_EQ(with.pixel(x, y), qRgb(0, 200, 0)) << int(orientation) << ": " << x << ' ' << y;
                ++covered;
            }
        }
        EXPECT_GT(covered, 100);
        move(*view, placeOf(*view, test::kBlockCentreMm), Qt::NoButton);
        EXPECT_TRUE(view->probedText().endsWith(", in Block")) << view->probedText().toStdString();
        move(*view, {395, 395}, Qt::NoButton);
        EXPECT_FALSE(view->probedText().contains("Block"));
        EXPECT_FALSE(view->notes().join(' ').contains("Segments")) << "they are where they were drawn";
        slices::ShownSegment moved = block;
        moved.isResampled = true;
        moved.hasFractions = true;
        view->setSegments(std::make_shared<const slices::ShownSegments>(slices::ShownSegments{block, moved}));
        ASSERT_TRUE(settled(*view));
        EXPECT_TRUE(view->notes().contains("Segments: nearest voxel of another grid"));
        EXPECT_TRUE(view->notes().contains("Segments: fractions of half or more"));
        view->setSegments(nullptr);
        ASSERT_TRUE(settled(*view));
        move(*view, placeOf(*view, test::kBlockCentreMm), Qt::NoButton);
        EXPECT_FALSE(view->probedText().contains("Block"));
        EXPECT_FALSE(view->notes().join(' ').contains("Segments"));
    }
}

TEST_F(SliceViewTest, AClickTakesTheOtherPanesThere) {
    showStudy();
    const auto axial = pane(Orientation::axial);
    const auto coronal = pane(Orientation::coronal);
    const auto sagittal = pane(Orientation::sagittal);
    click(*axial, placeOf(*axial, {6.0, -4.0, 0.0}));
    ASSERT_TRUE(settled(*coronal) && settled(*sagittal) && settled(*axial));
    EXPECT_DOUBLE_EQ(coronal->shownFrame()->plane.centreMm.y, -4.0);
    EXPECT_DOUBLE_EQ(sagittal->shownFrame()->plane.centreMm.x, 6.0);
    EXPECT_DOUBLE_EQ(axial->shownFrame()->plane.centreMm.z, 0.0);
    EXPECT_NEAR(crosshair().x, 6.0, 0.2);
    drag(*coronal, Qt::LeftButton, {200, 200}, placeOf(*coronal, {0.0, 0.0, 8.0}));
    ASSERT_TRUE(settled(*axial));
    EXPECT_DOUBLE_EQ(axial->shownFrame()->plane.centreMm.z, 8.0);
    session_->undo();  // the drag, as one
    ASSERT_TRUE(settled(*axial));
    EXPECT_DOUBLE_EQ(axial->shownFrame()->plane.centreMm.z, 0.0);
    session_->undo();
    EXPECT_FALSE(session_->canUndo());
}

// In the black beside the volume there is no slice for the other panes.
TEST_F(SliceViewTest, AClickBesideTheVolumeIsAtItsEdge) {
    showStudy();
    const auto axial = pane(Orientation::axial);
    const auto coronal = pane(Orientation::coronal);
    click(*axial, {200, 2});
    ASSERT_TRUE(settled(*coronal));
    EXPECT_DOUBLE_EQ(crosshair().y, -15.5) << "the outer side of the first voxels";
    EXPECT_NEAR(crosshair().x, 0.0, 0.2);
    EXPECT_DOUBLE_EQ(crosshair().z, 0.0) << "the slice stays";
    EXPECT_DOUBLE_EQ(coronal->shownFrame()->plane.centreMm.y, -15.0);
    EXPECT_LE(std::abs(coronal->shownFrame()->distanceMm(crosshair())), 0.5 + 1e-9);
    drag(*axial, Qt::LeftButton, {200, 200}, {200, 399});
    EXPECT_DOUBLE_EQ(crosshair().y, 15.5);
}

TEST_F(SliceViewTest, TheWheelGoesThroughSlicesInOneStepToUndo) {
    showStudy();
    const auto view = pane(Orientation::axial);
    turnWheel(*view, 1);
    EXPECT_DOUBLE_EQ(crosshair().z, 2.0) << "up is to the head";
    turnWheel(*view, -2);
    EXPECT_DOUBLE_EQ(crosshair().z, -2.0);
    turnWheel(*view, 1, Qt::ShiftModifier);
    EXPECT_DOUBLE_EQ(crosshair().z, 8.0);
    turnWheel(*view, 100);
    EXPECT_DOUBLE_EQ(crosshair().z, 20.0) << "the last slice is the end";
    session_->undo();
    EXPECT_FALSE(session_->canUndo());
    EXPECT_FALSE(state().slices.crosshairMm);
}

TEST_F(SliceViewTest, CtrlAndWheelZoomAboutThePointerAndFitComesBack) {
    showStudy();
    const auto view = pane(Orientation::axial);
    const slices::SliceFrame before = *view->shownFrame();
    turnWheel(*view, 3, Qt::ControlModifier, {120, 260});
    ASSERT_TRUE(settled(*view));
    const slices::SliceFrame after = *view->shownFrame();
    EXPECT_NEAR(after.mmPerPixel, before.mmPerPixel / std::pow(1.15, 3), 1e-9);
    const glm::dvec2 px = glm::dvec2(120, 260) * view->devicePixelRatioF();
    EXPECT_LT(glm::distance(before.worldFromPicture(px), after.worldFromPicture(px)), 1e-9);
    drag(*view, Qt::MiddleButton, {200, 200}, {240, 190});
    ASSERT_TRUE(settled(*view));
    EXPECT_LT(glm::distance(view->shownFrame()->pictureFromWorld(after.worldFromPicture(px)),
                            px + glm::dvec2(40, -10) * view->devicePixelRatioF()),
              1e-6);
    EXPECT_FALSE(session_->canUndo()) << "zoom and place are the pane's own";
    view->fit();
    ASSERT_TRUE(settled(*view));
    EXPECT_EQ(*view->shownFrame(), before);
}

// A slice that was dragged away is back by a key, a double right click, or the menu.
TEST_F(SliceViewTest, APictureIsNeverDraggedOutOfItsPaneAndFitsItAgain) {
    showStudy();
    for (const auto orientation : {Orientation::axial, Orientation::coronal, Orientation::sagittal}) {
        const auto view = pane(orientation);
        const slices::SliceFrame before = *view->shownFrame();
        for (const QPoint to : {QPoint(2000, 150), QPoint(-1500, 3000), QPoint(210, -2500)}) {
            turnWheel(*view, 2, Qt::ControlModifier);
            drag(*view, Qt::MiddleButton, {200, 200}, to);
            ASSERT_TRUE(settled(*view));
            const glm::dvec3 middle = view->shownFrame()->plane.centreMm;
            const Box box = session_->study().volume->worldBox();
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(middle[axis], box.low[axis] - 0.01);
                EXPECT_LE(middle[axis], box.high[axis] + 0.01);
            }
            QTest::keyClick(view.get(), Qt::Key_F);
            ASSERT_TRUE(settled(*view));
            EXPECT_EQ(*view->shownFrame(), before);
        }
    }
}

TEST_F(SliceViewTest, ADoubleRightClickAndTheMenuFitToo) {
    showStudy();
    const auto view = pane(Orientation::axial);
    const slices::SliceFrame before = *view->shownFrame();
    const auto openMenu = [&]() -> QMenu* {
        QTest::mouseClick(view.get(), Qt::RightButton, {}, {150, 150});
        return view->findChild<QMenu*>();
    };
    drag(*view, Qt::MiddleButton, {200, 200}, {260, 200});
    QMenu* menu = openMenu();
    ASSERT_NE(menu, nullptr);
    QMouseEvent second(QEvent::MouseButtonDblClick, QPointF(1, 1), menu->mapToGlobal(QPointF(1, 1)),
                       Qt::RightButton, Qt::RightButton, Qt::NoModifier);
    QApplication::sendEvent(menu, &second);
    EXPECT_FALSE(menu->isVisible());
    ASSERT_TRUE(settled(*view));
    EXPECT_EQ(*view->shownFrame(), before);
    EXPECT_FALSE(state().slices.window) << "the first click has changed nothing";
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);

    drag(*view, Qt::MiddleButton, {200, 200}, {200, 260});
    menu = openMenu();
    ASSERT_NE(menu, nullptr);
    auto* fit = menu->findChild<QAction*>(QStringLiteral("fit-slice"));
    ASSERT_NE(fit, nullptr);
    EXPECT_TRUE(fit->text().endsWith(QLatin1String("\tF"))) << fit->text().toStdString();
    fit->trigger();
    ASSERT_TRUE(settled(*view));
    EXPECT_EQ(*view->shownFrame(), before);
}

TEST_F(SliceViewTest, AWindowIsNotDraggedWiderThanValuesAre) {
    showStudy();
    const auto view = pane(Orientation::axial);
    for (int i = 0; i < 5; ++i) drag(*view, Qt::RightButton, {10, 200}, {390, 200});
    ASSERT_TRUE(state().slices.window);
    EXPECT_DOUBLE_EQ(state().slices.window->width, 2000.0) << "twice from 0 to 1000 HU";
}

TEST_F(SliceViewTest, ARightDragSetsTheWindow) {
    showStudy();
    const auto view = pane(Orientation::coronal);
    const DisplayWindow series = test::sliceVolumeOptions().windows.front();
    const DisplayWindow expected = scene::dragged(series, {0.1, 0.0}, *session_->study().volume);
    drag(*view, Qt::RightButton, {200, 200}, {240, 200});
    ASSERT_TRUE(state().slices.window);
    EXPECT_NEAR(state().slices.window->width, expected.width, 1e-6);
    EXPECT_NEAR(state().slices.window->center, 500.0, 1e-6);
    drag(*view, Qt::RightButton, {200, 200}, {200, 160});
    EXPECT_LT(state().slices.window->center, 500.0) << "brighter up";
    session_->undo();
    EXPECT_NEAR(state().slices.window->center, 500.0, 1e-6);
    session_->undo();
    EXPECT_FALSE(state().slices.window);
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(SliceViewTest, ADistanceHasTheLengthThatWasDrawnAndCanBeUndone) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::distance);
    const double mmPerPx = view->shownFrame()->mmPerPixel * view->devicePixelRatioF();
    drag(*view, Qt::LeftButton, {100, 100}, {160, 180});
    ASSERT_EQ(state().measurements.size(), 1u);
    const auto length = [&](std::size_t i) {
        return slices::lengthMm(std::get<slices::Distance>(state().measurements.at(i).shape));
    };
    EXPECT_NEAR(length(0), 100.0 * mmPerPx, 1e-9);
    EXPECT_EQ(view->selected(), 0u);
    // By two clicks, with the pointer moving between them.
    click(*view, {220, 120});
    move(*view, {240, 130}, Qt::NoButton);
    EXPECT_EQ(state().measurements.size(), 1u);
    click(*view, {250, 160});
    ASSERT_EQ(state().measurements.size(), 2u);
    EXPECT_NEAR(length(1), 50.0 * mmPerPx, 1e-9);
    session_->undo();
    EXPECT_EQ(state().measurements.size(), 1u);
    session_->undo();
    EXPECT_TRUE(state().measurements.empty());
    EXPECT_FALSE(session_->canUndo());
    EXPECT_EQ(view->selected(), std::nullopt);
}

TEST_F(SliceViewTest, AnEndIsDraggedAndASelectedMeasurementRemoved) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::distance);
    drag(*view, Qt::LeftButton, {100, 200}, {150, 200});
    const auto drawn = state().measurements;
    drag(*view, Qt::LeftButton, {152, 203}, {150, 260});
    ASSERT_EQ(state().measurements.size(), 1u);
    const auto& moved = std::get<slices::Distance>(state().measurements[0].shape);
    EXPECT_EQ(moved.endsMm[0], std::get<slices::Distance>(drawn[0].shape).endsMm[0]);
    EXPECT_LT(glm::distance(moved.endsMm[1], view->shownFrame()->worldFromPicture(glm::dvec2(150, 260) *
                                                                                  view->devicePixelRatioF())),
              1e-9);
    session_->undo();
    EXPECT_EQ(state().measurements, drawn);
    click(*view, {125, 203});  // its line
    ASSERT_EQ(view->selected(), 0u);
    QTest::keyClick(view.get(), Qt::Key_Delete);
    EXPECT_TRUE(state().measurements.empty());
    session_->undo();
    EXPECT_EQ(state().measurements, drawn);
}

TEST_F(SliceViewTest, AnAngleIsThreeClicksAndAnEllipseOfWaterHasItsValues) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::angle);
    click(*view, {100, 200});
    click(*view, {160, 200});
    click(*view, {160, 260});
    ASSERT_EQ(state().measurements.size(), 1u);
    EXPECT_NEAR(slices::angleDeg(std::get<slices::Angle>(state().measurements[0].shape)), 90.0, 1e-6);
    view->setTool(SliceTool::ellipse);
    const double mmPerPx = view->shownFrame()->mmPerPixel * view->devicePixelRatioF();
    drag(*view, Qt::LeftButton, {230, 230}, {310, 290});
    ASSERT_EQ(state().measurements.size(), 2u);
    const auto& ellipse = std::get<slices::Ellipse>(state().measurements[1].shape);
    EXPECT_NEAR(ellipse.radiiMm.x, 40.0 * mmPerPx, 1e-9);
    EXPECT_NEAR(ellipse.radiiMm.y, 30.0 * mmPerPx, 1e-9);
    const auto values = slices::valuesIn(ellipse, *session_->study().volume);
    ASSERT_TRUE(values);
    EXPECT_DOUBLE_EQ(values->mean, 0.0);
    EXPECT_DOUBLE_EQ(values->high, 0.0);
    EXPECT_NEAR(values->areaMm2, std::numbers::pi * 1200.0 * mmPerPx * mmPerPx, 1e-6);
}

TEST_F(SliceViewTest, WhatIsBegunOnOneSliceDoesNotEndOnAnother) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::distance);
    click(*view, {100, 200});
    QTest::keyClick(view.get(), Qt::Key_Escape);
    click(*view, {200, 200});
    turnWheel(*view, 1);
    ASSERT_TRUE(settled(*view));
    click(*view, {300, 200});
    EXPECT_TRUE(state().measurements.empty());
}

// Slices are counted from the feet, images of most series from the head: a report names the image.
TEST_F(SliceViewTest, TellsTheNumberOfTheImageWhereItIsAnother) {
    study::OpenedStudy study{.volume = test::sliceVolume()};
    for (int k = 0; k < 21; ++k) study.imageNumbers.push_back(k == 10 ? 0 : 21 - k);
    session_->show(std::move(study), {});
    const auto axial = pane(Orientation::axial);
    const auto coronal = pane(Orientation::coronal);
    EXPECT_EQ(axial->positionText(), "Axial S 0.0 mm, slice 11 of 21") << "of this there is no image";
    QTest::keyClick(axial.get(), Qt::Key_End);
    ASSERT_TRUE(settled(*axial));
    EXPECT_EQ(axial->positionText(), "Axial S 20.0 mm, slice 21 of 21, image 1");
    EXPECT_FALSE(coronal->positionText().contains("image")) << "none was taken so";
}

TEST_F(SliceViewTest, KeysGoThroughSlicesWindowsAndBlackForWhite) {
    showStudy();
    const auto view = pane(Orientation::axial);
    const auto press = [&](Qt::Key key) { QTest::keyClick(view.get(), key); };
    press(Qt::Key_Up);
    EXPECT_DOUBLE_EQ(crosshair().z, 2.0);
    press(Qt::Key_PageDown);
    EXPECT_DOUBLE_EQ(crosshair().z, -8.0);
    press(Qt::Key_Home);
    ASSERT_TRUE(settled(*view));
    EXPECT_EQ(view->positionText(), "Axial I 20.0 mm, slice 1 of 21");
    press(Qt::Key_End);
    ASSERT_TRUE(settled(*view));
    EXPECT_EQ(view->positionText(), "Axial S 20.0 mm, slice 21 of 21");
    press(Qt::Key_3);
    ASSERT_TRUE(state().slices.window);
    EXPECT_DOUBLE_EQ(state().slices.window->center, -600.0);
    press(Qt::Key_1);
    EXPECT_FALSE(state().slices.window);
    press(Qt::Key_I);
    EXPECT_TRUE(state().slices.isInverted);
    ASSERT_TRUE(settled(*view));
    EXPECT_TRUE(view->notes().contains("Inverted"));
    const QImage inverted = pictureOf(*view);
    EXPECT_EQ(inverted.pixel(placeOf(*view, {10.0, 8.0, 20.0})), qRgb(255, 255, 255)) << "water";
    EXPECT_EQ(inverted.pixel(60, 10), qRgb(0, 0, 0)) << "outside of the volume";
    const double before = view->shownFrame()->mmPerPixel;
    press(Qt::Key_Plus);
    ASSERT_TRUE(settled(*view));
    EXPECT_LT(view->shownFrame()->mmPerPixel, before);
}

TEST_F(SliceViewTest, TheOldPictureKeepsItsTextUntilTheNextIsThere) {
    showStudy();
    const auto view = pane(Orientation::axial);
    const QString before = view->positionText();
    EXPECT_EQ(before, "Axial S 0.0 mm, slice 11 of 21");
    QObject::connect(view.get(), &SliceView::pictureShown, view.get(), [&] {
        const double z = view->shownFrame()->plane.centreMm.z;
        EXPECT_EQ(view->positionText(), QStringLiteral("Axial S %1 mm, slice %2 of 21")
                                            .arg(QString::number(z, 'f', 1))
                                            .arg(int(z / 2.0) + 11));
    });
    for (int notch = 0; notch < 5; ++notch) view->moveBy(1);
    EXPECT_FALSE(view->isUpToDate());
    EXPECT_EQ(view->positionText(), before);
    EXPECT_DOUBLE_EQ(view->shownFrame()->plane.centreMm.z, 0.0);
    ASSERT_TRUE(settled(*view));
    EXPECT_DOUBLE_EQ(view->shownFrame()->plane.centreMm.z, 10.0);
    // Of another study nothing of this one stays.
    showStudy();
    EXPECT_FALSE(view->shownFrame());
    EXPECT_EQ(view->positionText(), QString());
    EXPECT_TRUE(settled(*view));
}

TEST_F(SliceViewTest, CineIsOneStepToUndoAndEndsWhenHidden) {
    showStudy();
    const auto view = pane(Orientation::sagittal);
    QTest::keyClick(view.get(), Qt::Key_Space);
    ASSERT_TRUE(view->isCineOn());
    ASSERT_TRUE(waitUntil([&] { return std::abs(crosshair().x) >= 3.0; }));
    view->hide();
    EXPECT_FALSE(view->isCineOn());
    session_->undo();
    EXPECT_FALSE(session_->canUndo());
    EXPECT_FALSE(state().slices.crosshairMm);
}

TEST_F(SliceViewTest, ADoubleClickAsksForTheWholeWindowAndMeasuresNothing) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::distance);
    int asked = 0;
    QObject::connect(view.get(), &SliceView::maximizeAsked, view.get(), [&] { ++asked; });
    click(*view, {200, 200});
    QTest::mouseDClick(view.get(), Qt::LeftButton, {}, {200, 200});
    EXPECT_EQ(asked, 1);
    click(*view, {300, 300});
    EXPECT_TRUE(state().measurements.empty()) << "that click begins one";
}

TEST_F(SliceViewTest, NamesAreOverThePictureUnlessTheyAreHidden) {
    showStudy();
    const auto view = pane(Orientation::axial);
    const QRect corner(0, 0, 120, 40);
    const QImage without = pictureOf(*view).copy(corner);
    view->setLines({"DOE, JOHN", "\u202e1970-01-01"});
    EXPECT_NE(pictureOf(*view).copy(corner), without);
    view->showNames(false);
    EXPECT_EQ(pictureOf(*view).copy(corner), without);
}

TEST_F(SliceViewTest, ItsToolTipDoesNotComeOverThePicture) {
    showStudy();
    const auto view = pane(Orientation::axial);
    EXPECT_FALSE(view->toolTip().isEmpty()) << "for who hears the window";
    const QPoint at(200, 200);
    QHelpEvent asked(QEvent::ToolTip, at, view->mapToGlobal(at));
    QCoreApplication::sendEvent(view.get(), &asked);
    QCoreApplication::processEvents();
    EXPECT_FALSE(QToolTip::isVisible());
}

TEST_F(SliceViewTest, ALabelIsTypedWhereTheMeasurementLies) {
    showStudy();
    const auto view = pane(Orientation::axial);
    view->setTool(SliceTool::distance);
    drag(*view, Qt::LeftButton, {100, 100}, {160, 180});
    ASSERT_EQ(state().measurements.size(), 1u);
    int asked = 0;
    QObject::connect(view.get(), &SliceView::maximizeAsked, view.get(), [&] { ++asked; });
    const auto editor = [&] { return view->findChild<LabelEditor*>(); };
    QTest::mouseDClick(view.get(), Qt::LeftButton, {}, {100, 100});
    ASSERT_NE(editor(), nullptr);
    EXPECT_EQ(asked, 0) << "a measurement was meant";
    QTest::keyClicks(editor(), "L3, 2 of 3");  // digits and letters are no windows and tools here
    QTest::keyClick(editor(), Qt::Key_Return);
    EXPECT_EQ(state().measurements.front().label, "L3, 2 of 3");
    EXPECT_FALSE(state().slices.window);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(editor(), nullptr);
    session_->undo();
    EXPECT_EQ(state().measurements.front().label, "");
    session_->redo();

    // Enter on the one that is chosen; Esc leaves it.
    QTest::keyClick(view.get(), Qt::Key_Return);
    ASSERT_NE(editor(), nullptr);
    EXPECT_EQ(editor()->text(), "L3, 2 of 3");
    QTest::keyClicks(editor(), "another");
    QTest::keyClick(editor(), Qt::Key_Escape);
    EXPECT_EQ(state().measurements.front().label, "L3, 2 of 3");
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);

    // No longer than what is kept, and no half letters.
    QTest::keyClick(view.get(), Qt::Key_Return);
    editor()->setText(QString(180, QChar(0x00e4)));
    QTest::keyClick(editor(), Qt::Key_Return);
    EXPECT_EQ(QString::fromStdString(state().measurements.front().label), QString(100, QChar(0x00e4)));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);

    // One that is gone meanwhile takes its words along.
    QTest::keyClick(view.get(), Qt::Key_Return);
    session_->change("Removed", [](scene::StudyState& next) { next.measurements.clear(); });
    editor()->setText("late");
    QTest::keyClick(editor(), Qt::Key_Return);
    EXPECT_TRUE(state().measurements.empty());
    QTest::keyClick(view.get(), Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(editor(), nullptr) << "nothing is chosen";
}

TEST_F(SliceViewTest, ARightClickOffersWindowsAndADragDoesNot) {
    showStudy();
    OwnWindowList own(std::nullopt);
    ASSERT_TRUE(own.add({.name = "Kidney & more",
                         .window = {.center = 60.0, .width = 300.0, .explanation = {}, .function = {}},
                         .unit = session_->study().volume->unitName()})
                    .ok());
    ASSERT_TRUE(own.add({.name = "Of another unit",
                         .window = {.center = 1.0, .width = 2.0, .explanation = {}, .function = {}},
                         .unit = "mm"})
                    .ok());
    const auto view = pane(Orientation::axial);
    view->setOwnWindows(&own);
    drag(*view, Qt::RightButton, {200, 200}, {240, 200});
    EXPECT_EQ(view->findChild<QMenu*>(), nullptr);
    session_->undo();
    QTest::mousePress(view.get(), Qt::RightButton, {}, {200, 200});
    move(*view, {201, 200}, Qt::RightButton);
    QTest::mouseRelease(view.get(), Qt::RightButton, {}, {201, 200});
    EXPECT_FALSE(state().slices.window) << "a click that shakes is no drag";
    QMenu* menu = view->findChild<QMenu*>();
    ASSERT_NE(menu, nullptr);
    QAction* kidney = nullptr;
    for (QAction* action : menu->actions()) {
        EXPECT_FALSE(action->text().startsWith("Of another unit"));
        if (action->text().startsWith("Kidney && more")) kidney = action;
    }
    ASSERT_NE(kidney, nullptr);
    // Each with its numbers, those of the series and of all values too.
    const QString unit = QString::fromStdString(session_->study().volume->unitName());
    EXPECT_TRUE(kidney->text().startsWith(QStringLiteral("Kidney && more: W 300 L 60") +
                                          (unit.isEmpty() ? QString() : QLatin1Char(' ') + unit)))
        << kidney->text().toStdString();
    const auto isWindow = [](const QAction* action) {
        return action->text().contains(QLatin1String(": W "));
    };
    EXPECT_GE(std::ranges::count_if(menu->actions(), isWindow), 3);
    kidney->trigger();
    ASSERT_TRUE(state().slices.window);
    EXPECT_EQ(state().slices.window->width, 300.0);
    menu->close();
    session_->undo();
    QTest::keyClick(view.get(), Qt::Key_1, Qt::AltModifier);
    ASSERT_TRUE(state().slices.window);
    EXPECT_EQ(state().slices.window->center, 60.0);
    session_->undo();
    for (const int digit : {2, 9}) QTest::keyClick(view.get(), Qt::Key(Qt::Key_0 + digit), Qt::AltModifier);
    EXPECT_FALSE(session_->canUndo()) << "there are no such windows";
}

}  // namespace
}  // namespace macula::viewer
