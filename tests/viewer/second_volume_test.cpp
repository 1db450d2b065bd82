// A second volume with a study, on slices: panes that are linked, the flip, what lies over, and the bar. On
// Qt's platform without a screen.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLocale>
#include <QRegularExpression>
#include <QSlider>
#include <QTest>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/clip/edited_clip.h"
#include "viewer/language/language.h"
#include "viewer/second/second_volume_bar.h"
#include "viewer/second_fixture.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {
namespace {

using scene::SecondVolumeLink;
using scene::SecondVolumePlace;

constexpr QRgb kWhite = qRgb(255, 255, 255);

TEST_F(SecondVolumeTest, TheSamePlaceIsAtTheSamePlaceInBoth) {
    openLinked();
    ASSERT_TRUE(pair_->showsBoth());
    EXPECT_EQ(study().shownFrame(), second().shownFrame());
    EXPECT_LT(study().mapTo(&*pair_, QPoint(0, 0)).x(), second().mapTo(&*pair_, QPoint(0, 0)).x());
    EXPECT_EQ(colourOfBlock(study()), kWhite);
    EXPECT_EQ(colourOfBlock(second()), kWhite);
    EXPECT_NE(colourOfWater(second()), kWhite);
    // Where it would be if it were not linked.
    session_->change("Link",
                     [](scene::StudyState& next) { next.secondVolume->secondFromStudy = glm::dmat4(1.0); });
    ASSERT_TRUE(settled());
    EXPECT_NE(colourOfBlock(second()), kWhite);
}

TEST_F(SecondVolumeTest, WhosePictureItIsIsSaidEvenWithoutNames) {
    EXPECT_TRUE(study().tags().isEmpty()) << "there is one study only";
    openLinked();
    pair_->showNames(false);
    EXPECT_EQ(study().tags(), QStringList("Current: CT, 2024-03-01"));
    EXPECT_EQ(second().tags(), QStringList("Prior: CT, 2022-03-01"));
    for (SliceView* pane : {&study(), &second()}) {
        EXPECT_FALSE(pane->tags().join(' ').contains("Doe"));
        EXPECT_FALSE(pane->tags().join(' ').contains("Miller")) << "a description may name anybody";
    }
    EXPECT_TRUE(second().notes().join(' ').contains("Registered"));
    secondVolume_->setView(SecondVolumePlace::over);
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().tags(), QStringList({"Current: CT, 2024-03-01", "In colours: Prior: CT, 2022-03-01"}));
}

// A clip is of the study: it dims the study, and neither dims the second volume nor has handles there.
TEST_F(SecondVolumeTest, TheClipIsOverTheStudyAlone) {
    openLinked();
    const QImage secondBefore = pictureOf(second());
    const QImage studyBefore = pictureOf(study());
    study().showClip(true, true);
    second().showClip(true, true);
    EXPECT_EQ(pictureOf(second()), secondBefore);
    secondVolume_->setView(SecondVolumePlace::instead);
    ASSERT_TRUE(settled());
    const QImage inPlaceBefore = pictureOf(study());
    const auto clip = [this](bool clips) {
        session_->change("Clip", [&](scene::StudyState& next) {
            next.clip.reset();
            if (clips)
                next.clip =
                    *scene::withBallRemoved({}, test::kBlockCentreMm, 15.0, *session_->study().volume);
        });
    };
    clip(true);
    ASSERT_TRUE(settled());
    EXPECT_EQ(pictureOf(study()), inPlaceBefore) << "the second volume in the place of the study";
    moveTo(study(), placeOf(study(), test::kBlockCentreMm));
    EXPECT_EQ(study().cursor().shape(), Qt::CrossCursor) << "no handle";
    secondVolume_->setView(SecondVolumePlace::beside);
    ASSERT_TRUE(settled());
    EXPECT_EQ(pictureOf(second()), secondBefore);
    EXPECT_NE(pictureOf(study()), studyBefore);
}

TEST_F(SecondVolumeTest, SliceCrosshairZoomAndPlaceAreOne) {
    openLinked();
    turnWheel(second(), -2);
    ASSERT_TRUE(settled());
    EXPECT_DOUBLE_EQ(study().shownFrame()->plane.centreMm.z, test::kBlockCentreMm.z - 4.0);
    EXPECT_EQ(study().shownFrame(), second().shownFrame());
    turnWheel(second(), 3, Qt::ControlModifier);
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().shownFrame(), second().shownFrame());
    turnWheel(study(), -1, Qt::ControlModifier);
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().shownFrame(), second().shownFrame());
    const glm::dvec3 place(6.0, -4.0, 8.0);
    QTest::mouseClick(&second(), Qt::LeftButton, {}, placeOf(second(), place));
    ASSERT_TRUE(state().slices.crosshairMm);
    EXPECT_NEAR(state().slices.crosshairMm->x, place.x, 0.3) << "in the world of the study";
    EXPECT_NEAR(state().slices.crosshairMm->y, place.y, 0.3);
}

TEST_F(SecondVolumeTest, TheFlipShowsTheSecondInTheSamePlanesAndGoesBack) {
    openLinked();
    secondVolume_->setView(SecondVolumePlace::hidden);
    ASSERT_TRUE(settled());
    EXPECT_FALSE(pair_->showsBoth());
    const QImage before = pictureOf(study());
    const auto frame = study().shownFrame();
    secondVolume_->flip();
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().tags(), QStringList("Prior: CT, 2022-03-01"));
    EXPECT_EQ(study().shownFrame(), frame);
    EXPECT_EQ(colourOfBlock(study()), kWhite);
    EXPECT_NE(pictureOf(study()), before) << "at least its edge says whose it is";
    secondVolume_->flip();
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().tags(), QStringList("Current: CT, 2024-03-01"));
    EXPECT_EQ(pictureOf(study()), before);
    // From two columns it goes back to two columns.
    secondVolume_->setView(SecondVolumePlace::beside);
    secondVolume_->flip();
    EXPECT_FALSE(pair_->showsBoth());
    secondVolume_->flip();
    EXPECT_TRUE(pair_->showsBoth());
}

TEST_F(SecondVolumeTest, EachHasItsOwnWindow) {
    openLinked();
    QTest::keyClick(&second(), Qt::Key_3);
    ASSERT_TRUE(state().secondVolume->window);
    EXPECT_DOUBLE_EQ(state().secondVolume->window->center, -600.0);
    EXPECT_FALSE(state().slices.window);
    QTest::keyClick(&study(), Qt::Key_4);
    EXPECT_DOUBLE_EQ(state().slices.window->center, 400.0);
    EXPECT_DOUBLE_EQ(state().secondVolume->window->center, -600.0);
    ASSERT_TRUE(settled());
    EXPECT_GT(qRed(colourOfWater(second())), 200) << "through a window for lungs";
    EXPECT_LT(qRed(colourOfWater(study())), 100) << "through one for bone";
}

TEST_F(SecondVolumeTest, OverTheStudyItIsInColoursAndTheProbeTellsBoth) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.worldFromVoxel = kMoved * options.worldFromVoxel;
    options.unitsFromStored = {.slope = 0.005, .intercept = -5.0};  // 5 in the block, else 0
    options.unit = Unit::suvBodyWeight;
    options.modality = "PT";
    options.windows.clear();
    openLinked(studyOf(test::sliceVolume(std::move(options)), "pet", "20240301"));
    secondVolume_->setView(SecondVolumePlace::over);
    session_->change("Opacity", [](scene::StudyState& next) {
        next.secondVolume->opacity = 1.0;
        next.secondVolume->window =
            DisplayWindow{.center = 5.0, .width = 10.0, .explanation = {}, .function = "LINEAR_EXACT"};
    });
    ASSERT_TRUE(settled());
    const QRgb hot = colourOfBlock(study());
    EXPECT_EQ(qRed(hot), 255) << "the middle of hot iron";
    EXPECT_LT(qGreen(hot), 10);
    EXPECT_EQ(qBlue(hot), 0);
    const QRgb water = colourOfWater(study());
    EXPECT_EQ(qRed(water), qBlue(water)) << "where nothing is taken up, the study is seen";
    moveTo(study(), placeOf(study(), test::kBlockCentreMm));
    EXPECT_TRUE(study().probedText().startsWith("1000 HU")) << study().probedText().toStdString();
    EXPECT_TRUE(study().overProbedText().contains("5 ")) << study().overProbedText().toStdString();

    session_->change("Opacity", [](scene::StudyState& next) { next.secondVolume->opacity = 0.0; });
    ASSERT_TRUE(settled());
    EXPECT_EQ(colourOfBlock(study()), kWhite);
}

TEST_F(SecondVolumeTest, NotesAreOfTheVolumeThatIsShown) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.worldFromVoxel = kMoved * options.worldFromVoxel;
    options.provenance.interpolatedSlices = {{.first = 10, .last = 10}};
    study::OpenedStudy lowIsBright = studyOf(test::sliceVolume(std::move(options)), "mono", "20240301");
    lowIsBright.isLowBright = true;
    openLinked(lowIsBright);
    EXPECT_TRUE(second().notes().contains("Low values are white, as in the images"));
    EXPECT_FALSE(second().notes().contains("Inverted"));
    EXPECT_FALSE(study().notes().contains("Low values are white, as in the images"));
    EXPECT_TRUE(second().notes().contains("Some of its slices are interpolated"));
    secondVolume_->setView(SecondVolumePlace::over);
    ASSERT_TRUE(settled());
    EXPECT_TRUE(study().notes().contains("In colours: some slices are interpolated"));
    session_->change("Inverted", [](scene::StudyState& next) { next.slices.isInverted = true; });
    ASSERT_TRUE(settled());
    EXPECT_TRUE(study().notes().contains("Inverted"));
}

TEST_F(SecondVolumeTest, MeasurementsAreOfTheStudy) {
    openLinked();
    second().setTool(SliceTool::distance);
    QTest::mousePress(&second(), Qt::LeftButton, {}, QPoint(60, 60));
    QTest::mouseRelease(&second(), Qt::LeftButton, {}, QPoint(160, 160));
    QTest::mouseClick(&second(), Qt::LeftButton, {}, QPoint(160, 160));
    EXPECT_TRUE(state().measurements.empty());
    EXPECT_TRUE(second().notes().join(' ').contains("of the study alone"));
}

// Names over the 3D picture are those of the study; what else is in it is said below them.
TEST_F(SecondVolumeTest, A3dPictureSaysWhatElseIsInIt) {
    scene::Drawing drawing;
    EXPECT_EQ(linesOver({"DOE, JANE"}, drawing), LinesOver{.names = {"DOE, JANE"}});
    Additions additions;
    additions.remark = Text("with PT");
    drawing.additions = std::make_shared<const Additions>(additions);
    EXPECT_EQ(linesOver({"DOE, JANE"}, drawing), (LinesOver{.names = {"DOE, JANE"}, .notes = {"With PT"}}));
    EXPECT_EQ(linesOver({}, drawing), LinesOver{.notes = {"With PT"}}) << "also where nobody is named";
    drawing.settings.look = trace::Look::mip;
    EXPECT_EQ(linesOver({"DOE, JANE"}, drawing), LinesOver{.names = {"DOE, JANE"}})
        << "projections show the study alone";
    drawing.settings.look = trace::Look::cinematic;
    drawing.additions = std::make_shared<const Additions>();
    EXPECT_EQ(linesOver({}, drawing), LinesOver{});
}

TEST_F(SecondVolumeTest, ListsOfTheBarAreInTheLanguageOfTheWindow) {
    useLanguage(Language::german);
    const SecondVolumeBar bar(*session_, *secondVolume_);
    useLanguage(Language::english);
    QLocale::setDefault(QLocale::c());
    const auto* views = bar.findChild<QComboBox*>("beside-view");
    const auto* colours = bar.findChild<QComboBox*>("beside-colours");
    ASSERT_TRUE(views != nullptr && colours != nullptr);
    EXPECT_EQ(views->itemText(int(SecondVolumePlace::beside)), QStringLiteral("Nebeneinander"));
    EXPECT_EQ(colours->itemText(0), QStringLiteral("Glühendes Eisen"));
}

TEST_F(SecondVolumeTest, TheBarShowsTheStateAndProposesOthers) {
    SecondVolumeBar bar(*session_, *secondVolume_);
    EXPECT_TRUE(bar.isHidden());
    openLinked();
    EXPECT_FALSE(bar.isHidden());
    auto* views = bar.findChild<QComboBox*>("beside-view");
    auto* links = bar.findChild<QComboBox*>("beside-link");
    auto* opacity = bar.findChild<QSlider*>("beside-opacity");
    auto* white = bar.findChild<QDoubleSpinBox*>("beside-white");
    ASSERT_TRUE(views != nullptr && links != nullptr && opacity != nullptr && white != nullptr);
    EXPECT_EQ(views->currentIndex(), int(SecondVolumePlace::beside));
    EXPECT_EQ(links->currentIndex(), int(SecondVolumeLink::registered));
    EXPECT_DOUBLE_EQ(white->value(), 1000.0);
    EXPECT_FALSE(state().secondVolume->window) << "showing proposes nothing";
    int left = 0;  // letters would choose from the list that was left
    QObject::connect(&bar, &SecondVolumeBar::listLeft, &bar, [&left] { ++left; });
    Q_EMIT views->activated(int(SecondVolumePlace::over));
    EXPECT_EQ(left, 1);
    EXPECT_EQ(state().secondVolume->view, SecondVolumePlace::over);
    opacity->setValue(25);
    EXPECT_DOUBLE_EQ(state().secondVolume->opacity, 0.25);
    opacity->setValue(50);
    session_->undo();
    EXPECT_DOUBLE_EQ(state().secondVolume->opacity, 0.25) << "each change by keys is one of its own";
    white->setValue(800.0);
    EXPECT_DOUBLE_EQ(state().secondVolume->window->width, 800.0);
    white->setValue(-5000.0);  // below black
    EXPECT_DOUBLE_EQ(state().secondVolume->window->width, 800.0);
    Q_EMIT links->activated(int(SecondVolumeLink::byHand));
    EXPECT_EQ(state().secondVolume->view, SecondVolumePlace::beside) << "nothing is laid over by hand";
    EXPECT_EQ(views->currentIndex(), int(SecondVolumePlace::beside));
    for (QWidget* control : bar.findChildren<QWidget*>(QRegularExpression("^beside-")))
        EXPECT_FALSE(control->accessibleName().isEmpty() || control->toolTip().isEmpty())
            << control->objectName().toStdString();
    bar.findChild<QAction*>("close-beside")->trigger();
    EXPECT_TRUE(bar.isHidden());
}

}  // namespace
}  // namespace macula::viewer
