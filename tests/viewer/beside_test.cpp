// A second volume with a study: panes that are linked, the flip, what lies over, and who is asked. On Qt's
// platform without a screen.
#include "viewer/beside/beside_study.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QRegularExpression>
#include <QSlider>
#include <QTest>
#include <QThread>
#include <QWheelEvent>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "app/clip/edited_clip.h"
#include "base/phantom.h"
#include "viewer/beside/beside_bar.h"
#include "viewer/beside/slice_pair.h"
#include "viewer/offscreen.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/slice_volume.h"
#include "viewer/volume/shown_additions.h"

namespace macula::viewer {
namespace {

using app::BesideLink;
using app::BesideView;
using slices::Orientation;

// Turned by a quarter about the patient's long axis, and moved: not to be mistaken for anything else.
const glm::dmat4 kMoved = affine({0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {40, -30, 100});

app::OpenedStudy studyOf(std::shared_ptr<const Volume> volume, std::string digest, std::string date) {
    app::OpenedStudy study;
    study.volume = std::move(volume);
    study.seriesDigest = std::move(digest);
    study.identity = {.patientName = "Doe^Jane",
                      .patientId = "17",
                      .birthDate = "19700101",
                      .sex = "F",
                      .studyDate = std::move(date),
                      .studyDescription = "Thorax",
                      .series = "CT, series 3: Miller"};
    return study;
}

class BesideTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        session_.emplace(app::Catalogue{});
        beside_.emplace(*session_);
        pair_.emplace(*session_, Orientation::axial);
        QObject::connect(&*beside_, &BesideStudy::secondChanged, &*beside_, [this] {
            pair_->setSecond(beside_->second());
            follow();
        });
        QObject::connect(&*session_, &ViewerSession::changed, &*beside_, [this] { follow(); });
        QObject::connect(&*beside_, &BesideStudy::failed, &*beside_, [this](const Error& e) { error_ = e; });
        QObject::connect(&*beside_, &BesideStudy::askedAboutPatient, &*beside_,
                         [this](const QStringList& differs) { asked_ = differs; });
        pair_->resize(800, 400);
        pair_->show();
        current_ = studyOf(test::sliceVolume(), "current", "20240301");
        session_->show(current_, {});
        ASSERT_TRUE(settled());
    }
    void TearDown() override {
        pair_.reset();
        beside_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }
    // As the window does it.
    void follow() {
        const auto* state = beside_->state();
        pair_->setBoth(state != nullptr && state->view == BesideView::beside);
    }

    // The same body, elsewhere in the scanner.
    static app::OpenedStudy prior() {
        VolumeOptions options = test::sliceVolumeOptions();
        options.worldFromVoxel = kMoved * options.worldFromVoxel;
        return studyOf(test::sliceVolume(std::move(options)), "prior", "20220301");
    }
    // With the right link, which takes a while to find by itself.
    void openLinked(app::OpenedStudy second = prior()) {
        beside_->offer(second);
        beside_->cancel();
        session_->change("Link", [](app::StudyState& next) {
            next.beside->link = BesideLink::registered;
            next.beside->secondFromStudy = kMoved;
            next.layout = app::Layout::fourPanes;
            next.slices.crosshairMm = test::kBlockCentreMm;
        });
        ASSERT_TRUE(settled());
    }

    SliceView& study() { return pair_->study(); }
    SliceView& second() { return pair_->second(); }
    bool settled() {
        settle();  // sizes come with events
        return test::waitFor(
            [&] { return study().isUpToDate() && (!pair_->showsBoth() || second().isUpToDate()); });
    }
    static QImage pictureOf(SliceView& view) {
        return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
    static QPoint placeOf(const SliceView& view, const glm::dvec3& mm) {
        const glm::dvec2 px = view.shownFrame()->pictureFromWorld(mm) / view.devicePixelRatioF();
        return {int(std::floor(px.x)), int(std::floor(px.y))};
    }
    // Beside the middle, where the cross-hair leaves the picture free.
    static QRgb colourAt(SliceView& view, const glm::dvec3& mm) {
        return pictureOf(view).pixel(placeOf(view, mm));
    }
    static QRgb colourOfBlock(SliceView& view) {
        return colourAt(view, test::kBlockCentreMm + glm::dvec3(1, 1, 0));
    }
    static QRgb colourOfWater(SliceView& view) { return colourAt(view, glm::dvec3(11, 6, 12)); }
    static void turnWheel(QWidget& over, int notches, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint at(150, 200);
        QWheelEvent event(at, over.mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&over, &event);
    }
    static void moveTo(QWidget& to, QPoint place) {
        QMouseEvent event(QEvent::MouseMove, place, to.mapToGlobal(place), Qt::NoButton, Qt::NoButton, {});
        QApplication::sendEvent(&to, &event);
    }
    const app::StudyState& state() const { return session_->state(); }

    std::optional<ViewerSession> session_;
    std::optional<BesideStudy> beside_;
    std::optional<SlicePair> pair_;
    app::OpenedStudy current_;
    std::optional<Error> error_;
    std::optional<QStringList> asked_;
};

constexpr QRgb kWhite = qRgb(255, 255, 255);

TEST_F(BesideTest, TheSamePlaceIsAtTheSamePlaceInBoth) {
    openLinked();
    ASSERT_TRUE(pair_->showsBoth());
    EXPECT_EQ(study().shownFrame(), second().shownFrame());
    EXPECT_LT(study().mapTo(&*pair_, QPoint(0, 0)).x(), second().mapTo(&*pair_, QPoint(0, 0)).x());
    EXPECT_EQ(colourOfBlock(study()), kWhite);
    EXPECT_EQ(colourOfBlock(second()), kWhite);
    EXPECT_NE(colourOfWater(second()), kWhite);
    // Where it would be if it were not linked.
    session_->change("Link", [](app::StudyState& next) { next.beside->secondFromStudy = glm::dmat4(1.0); });
    ASSERT_TRUE(settled());
    EXPECT_NE(colourOfBlock(second()), kWhite);
}

TEST_F(BesideTest, WhosePictureItIsIsSaidEvenWithoutNames) {
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
    beside_->setView(BesideView::over);
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().tags(), QStringList({"Current: CT, 2024-03-01", "In colours: Prior: CT, 2022-03-01"}));
}

// A clip is of the study: it dims the study, and neither dims the second volume nor has handles there.
TEST_F(BesideTest, TheClipIsOverTheStudyAlone) {
    openLinked();
    const QImage secondBefore = pictureOf(second());
    const QImage studyBefore = pictureOf(study());
    study().showClip(true, true);
    second().showClip(true, true);
    EXPECT_EQ(pictureOf(second()), secondBefore);
    beside_->setView(BesideView::instead);
    ASSERT_TRUE(settled());
    const QImage inPlaceBefore = pictureOf(study());
    const auto clip = [this](bool clips) {
        session_->change("Clip", [&](app::StudyState& next) {
            next.clip.reset();
            if (clips)
                next.clip = *app::withBallRemoved({}, test::kBlockCentreMm, 15.0, *session_->study().volume);
        });
    };
    clip(true);
    ASSERT_TRUE(settled());
    EXPECT_EQ(pictureOf(study()), inPlaceBefore) << "the second volume in the place of the study";
    moveTo(study(), placeOf(study(), test::kBlockCentreMm));
    EXPECT_EQ(study().cursor().shape(), Qt::CrossCursor) << "no handle";
    beside_->setView(BesideView::beside);
    ASSERT_TRUE(settled());
    EXPECT_EQ(pictureOf(second()), secondBefore);
    EXPECT_NE(pictureOf(study()), studyBefore);
}

TEST_F(BesideTest, SliceCrosshairZoomAndPlaceAreOne) {
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

TEST_F(BesideTest, TheFlipShowsTheSecondInTheSamePlanesAndGoesBack) {
    openLinked();
    beside_->setView(BesideView::hidden);
    ASSERT_TRUE(settled());
    EXPECT_FALSE(pair_->showsBoth());
    const QImage before = pictureOf(study());
    const auto frame = study().shownFrame();
    beside_->flip();
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().tags(), QStringList("Prior: CT, 2022-03-01"));
    EXPECT_EQ(study().shownFrame(), frame);
    EXPECT_EQ(colourOfBlock(study()), kWhite);
    EXPECT_NE(pictureOf(study()), before) << "at least its edge says whose it is";
    beside_->flip();
    ASSERT_TRUE(settled());
    EXPECT_EQ(study().tags(), QStringList("Current: CT, 2024-03-01"));
    EXPECT_EQ(pictureOf(study()), before);
    // From two columns it goes back to two columns.
    beside_->setView(BesideView::beside);
    beside_->flip();
    EXPECT_FALSE(pair_->showsBoth());
    beside_->flip();
    EXPECT_TRUE(pair_->showsBoth());
}

TEST_F(BesideTest, EachHasItsOwnWindow) {
    openLinked();
    QTest::keyClick(&second(), Qt::Key_3);
    ASSERT_TRUE(state().beside->window);
    EXPECT_DOUBLE_EQ(state().beside->window->center, -600.0);
    EXPECT_FALSE(state().slices.window);
    QTest::keyClick(&study(), Qt::Key_4);
    EXPECT_DOUBLE_EQ(state().slices.window->center, 400.0);
    EXPECT_DOUBLE_EQ(state().beside->window->center, -600.0);
    ASSERT_TRUE(settled());
    EXPECT_GT(qRed(colourOfWater(second())), 200) << "through a window for lungs";
    EXPECT_LT(qRed(colourOfWater(study())), 100) << "through one for bone";
}

TEST_F(BesideTest, OverTheStudyItIsInColoursAndTheProbeTellsBoth) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.worldFromVoxel = kMoved * options.worldFromVoxel;
    options.unitsFromStored = {.slope = 0.005, .intercept = -5.0};  // 5 in the block, else 0
    options.unit = Unit::suvBodyWeight;
    options.modality = "PT";
    options.windows.clear();
    openLinked(studyOf(test::sliceVolume(std::move(options)), "pet", "20240301"));
    beside_->setView(BesideView::over);
    session_->change("Opacity", [](app::StudyState& next) {
        next.beside->opacity = 1.0;
        next.beside->window =
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

    session_->change("Opacity", [](app::StudyState& next) { next.beside->opacity = 0.0; });
    ASSERT_TRUE(settled());
    EXPECT_EQ(colourOfBlock(study()), kWhite);
}

TEST_F(BesideTest, NotesAreOfTheVolumeThatIsShown) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.worldFromVoxel = kMoved * options.worldFromVoxel;
    options.provenance.interpolatedSlices = {{.first = 10, .last = 10}};
    app::OpenedStudy lowIsBright = studyOf(test::sliceVolume(std::move(options)), "mono", "20240301");
    lowIsBright.isLowBright = true;
    openLinked(lowIsBright);
    EXPECT_TRUE(second().notes().contains("Low values are white, as in the images"));
    EXPECT_FALSE(second().notes().contains("Inverted"));
    EXPECT_FALSE(study().notes().contains("Low values are white, as in the images"));
    EXPECT_TRUE(second().notes().contains("Some of its slices are interpolated"));
    beside_->setView(BesideView::over);
    ASSERT_TRUE(settled());
    EXPECT_TRUE(study().notes().contains("In colours: some slices are interpolated"));
    session_->change("Inverted", [](app::StudyState& next) { next.slices.isInverted = true; });
    ASSERT_TRUE(settled());
    EXPECT_TRUE(study().notes().contains("Inverted"));
}

TEST_F(BesideTest, ByHandNothingIsComparedAndTheWheelMovesTheSecondAlone) {
    beside_->offer(prior());
    beside_->cancel();  // the registration
    ASSERT_TRUE(beside_->state());
    EXPECT_EQ(beside_->state()->link, BesideLink::byHand);
    ASSERT_TRUE(settled());
    EXPECT_TRUE(second().notes().join(' ').contains("Not registered"));
    beside_->setView(BesideView::over);
    EXPECT_EQ(beside_->state()->view, BesideView::beside) << "nobody knows where it lies";
    const auto before = state();
    turnWheel(second(), 1);
    EXPECT_EQ(state().slices, before.slices);
    EXPECT_NEAR(state().beside->secondFromStudy[3].z - before.beside->secondFromStudy[3].z, 2.0, 1e-9);
    turnWheel(second(), 1000);
    EXPECT_LT(state().beside->secondFromStudy[3].z - before.beside->secondFromStudy[3].z, 3.0)
        << "it stays in sight";
    QTest::mouseClick(&second(), Qt::LeftButton, {}, QPoint(60, 60));
    EXPECT_EQ(state().slices.crosshairMm, before.slices.crosshairMm) << "this is no place in the study";
}

TEST_F(BesideTest, MeasurementsAreOfTheStudy) {
    openLinked();
    second().setTool(SliceTool::distance);
    QTest::mousePress(&second(), Qt::LeftButton, {}, QPoint(60, 60));
    QTest::mouseRelease(&second(), Qt::LeftButton, {}, QPoint(160, 160));
    QTest::mouseClick(&second(), Qt::LeftButton, {}, QPoint(160, 160));
    EXPECT_TRUE(state().measurements.empty());
    EXPECT_TRUE(second().notes().join(' ').contains("of the study alone"));
}

TEST_F(BesideTest, AnotherPatientIsAskedAboutAndSaid) {
    app::OpenedStudy other = prior();
    other.identity.patientId = "18";
    other.identity.birthDate = "19800101";
    beside_->offer(other);
    ASSERT_TRUE(asked_);
    EXPECT_EQ(*asked_, QStringList({"ID", "date of birth"})) << "no values";
    EXPECT_EQ(beside_->second(), nullptr) << "nothing is shown before the answer";
    EXPECT_FALSE(state().beside);
    beside_->refusePatient();
    beside_->acceptPatient();
    EXPECT_EQ(beside_->second(), nullptr) << "it was refused";

    beside_->offer(other);
    beside_->acceptPatient();
    beside_->cancel();
    ASSERT_TRUE(settled());
    EXPECT_TRUE(second().notes().join(' ').contains("ANOTHER PATIENT"));
    beside_->flip();
    ASSERT_TRUE(settled());
    EXPECT_TRUE(study().notes().join(' ').contains("ANOTHER PATIENT"));
}

TEST_F(BesideTest, WhereImagesDoNotTellWhoItIsThePaneSaysSo) {
    app::OpenedStudy file = prior();
    file.identity = {.series = "File brain.nii"};
    beside_->offer(file);
    beside_->cancel();
    EXPECT_FALSE(asked_);
    ASSERT_TRUE(settled());
    EXPECT_TRUE(second().notes().join(' ').contains("do not tell whether both are of one patient"));
    EXPECT_EQ(second().tags(), QStringList("Second: CT, no study date"));
}

TEST_F(BesideTest, OneFrameOfReferenceNeedsNoRegistration) {
    current_.frameOfReferenceUid = "1.2.3";
    session_->show(current_, {});
    app::OpenedStudy pet = prior();
    pet.frameOfReferenceUid = "1.2.3";
    beside_->offer(pet);
    EXPECT_FALSE(beside_->isRegistering());
    EXPECT_EQ(beside_->state()->link, BesideLink::sameFrame);
    EXPECT_EQ(beside_->state()->secondFromStudy, glm::dmat4(1.0));
    ASSERT_TRUE(settled());
    EXPECT_TRUE(second().notes().join(' ').contains("the patient may have moved"));
    // A frame of reference that two patients share is none.
    pet.seriesDigest = "another";
    pet.identity.patientId = "18";
    beside_->offer(pet);
    beside_->acceptPatient();
    EXPECT_EQ(beside_->state()->link, BesideLink::byHand);
    beside_->linkByFrame();
    EXPECT_EQ(beside_->state()->link, BesideLink::byHand);
}

TEST_F(BesideTest, AnyOtherIsRegisteredByItself) {
    phantom::Options options{.size = {48, 42, 32}, .spacingMm = {6.3, 6.3, 9.3}};
    current_.volume = std::make_shared<const Volume>(phantom::make(options));
    session_->show(current_, {});
    VolumeOptions moved{.size = options.size,
                        .worldFromVoxel = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 30}) *
                                          current_.volume->worldFromVoxel(),
                        .unitsFromStored = current_.volume->unitsFromStored(),
                        .unit = Unit::hounsfield,
                        .modality = "CT"};
    const auto voxels = current_.volume->voxels();
    auto volume = Volume::create(std::move(moved), {voxels.begin(), voxels.end()});
    bool hasEnded = false;
    QObject::connect(&*beside_, &BesideStudy::ended, &*beside_, [&] { hasEnded = true; });
    beside_->offer(studyOf(std::make_shared<const Volume>(*std::move(volume)), "prior", "20220301"));
    EXPECT_TRUE(beside_->isRegistering());
    ASSERT_TRUE(test::waitFor([&] { return hasEnded; }));
    ASSERT_EQ(beside_->state()->link, BesideLink::registered) << (error_ ? error_->message : "");
    EXPECT_NEAR(beside_->state()->secondFromStudy[3].z, 30.0, 2.0);
    session_->undo();
    EXPECT_EQ(beside_->state()->link, BesideLink::byHand) << "one step";
}

TEST_F(BesideTest, WhatCannotBeRegisteredStaysLinkedByHandAndSaysWhy) {
    auto volume = Volume::create({.size = glm::ivec3(24), .unit = Unit::hounsfield, .modality = "CT"},
                                 std::vector<std::uint16_t>(13824, 1000));
    beside_->offer(studyOf(std::make_shared<const Volume>(*std::move(volume)), "flat", "20220301"));
    ASSERT_TRUE(test::waitFor([&] { return error_.has_value(); }));
    EXPECT_NE(error_->message.find("the same value everywhere"), std::string::npos);
    EXPECT_EQ(beside_->state()->link, BesideLink::byHand);
}

TEST_F(BesideTest, ItIsNotOpenedBesideItself) {
    beside_->offer(current_);
    ASSERT_TRUE(error_);
    EXPECT_EQ(error_->code, ErrorCode::usage);
    EXPECT_EQ(beside_->second(), nullptr);
}

TEST_F(BesideTest, AStateThatKnowsTheLinkNeedsNoSecondRegistration) {
    openLinked();
    const app::BesideState left = *state().beside;
    app::StudyState next;
    next.beside = left;
    session_->show(current_, next);
    EXPECT_EQ(beside_->second(), nullptr) << "it is of the study before";
    EXPECT_EQ(beside_->state(), nullptr);
    beside_->offer(prior());
    EXPECT_FALSE(beside_->isRegistering());
    EXPECT_EQ(*beside_->state(), left);
}

TEST_F(BesideTest, ClosingItAndAnotherStudyLeaveNothing) {
    openLinked();
    std::weak_ptr<const Volume> volume = beside_->second()->study.volume;
    beside_->close();
    EXPECT_FALSE(state().beside);
    EXPECT_FALSE(pair_->showsBoth());
    ASSERT_TRUE(settled());
    EXPECT_TRUE(study().tags().isEmpty());
    EXPECT_TRUE(test::waitFor([&] { return volume.expired(); })) << "its memory is not given back";
    openLinked();
    session_->show(current_, {});
    EXPECT_EQ(beside_->second(), nullptr);
    beside_->flip();
    beside_->registerNow();
    beside_->linkByHand();
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(BesideTest, In3dItIsThereWhileItIsLinkedAndAskedFor) {
    openLinked();
    SegmentationKeeper segments(*session_);
    ShownAdditions shown(*session_, segments);
    shown.setSecond(beside_->second());
    EXPECT_EQ(shown.additions(), nullptr);
    BesideBar bar(*session_, *beside_);
    auto* in3d = bar.findChild<QCheckBox*>("beside-in3d");
    auto* presets = bar.findChild<QComboBox*>("beside-preset");
    ASSERT_TRUE(in3d != nullptr && presets != nullptr);
    EXPECT_FALSE(presets->isEnabled());
    in3d->click();
    EXPECT_TRUE(state().beside->in3d);
    EXPECT_TRUE(presets->isEnabled());
    const auto atRest = [&] { return test::waitFor([&] { return shown.isAtRest(); }); };
    ASSERT_TRUE(atRest());
    ASSERT_TRUE(shown.additions() && shown.additions()->second);
    EXPECT_EQ(shown.additions()->second->secondFromVolumeMm, kMoved);
    EXPECT_TRUE(validate(*shown.additions(), *current_.volume).ok());

    const auto before = shown.additions();
    session_->change("View", [](app::StudyState& next) { next.beside->view = BesideView::over; });
    ASSERT_TRUE(atRest());
    EXPECT_EQ(shown.additions(), before) << "in 3D it is the same";
    session_->change("Opacity", [](app::StudyState& next) { next.beside->opacity = 0.2; });
    ASSERT_TRUE(atRest());
    ASSERT_TRUE(shown.additions() && shown.additions()->second);
    EXPECT_LT(shown.additions()->second->function->opacity.back().opacity,
              before->second->function->opacity.back().opacity);
    session_->undo();
    session_->undo();
    session_->undo();
    EXPECT_FALSE(in3d->isChecked());
    EXPECT_EQ(shown.additions(), nullptr);

    in3d->click();
    ASSERT_TRUE(atRest());
    EXPECT_TRUE(shown.additions());
    session_->change("Link", [](app::StudyState& next) { next.beside->link = BesideLink::byHand; });
    EXPECT_EQ(shown.additions(), nullptr) << "nobody knows where it lies";
    EXPECT_FALSE(in3d->isEnabled());
}

// Nothing in a 3D picture tells whose matter is whose.
TEST_F(BesideTest, AnotherPatientIsNeverInThe3dPictureOfThisOne) {
    app::OpenedStudy other = prior();
    other.identity.patientId = "18";
    beside_->offer(other);
    beside_->acceptPatient();
    beside_->cancel();
    SegmentationKeeper segments(*session_);
    ShownAdditions shown(*session_, segments);
    shown.setSecond(beside_->second());
    session_->change("Link", [](app::StudyState& next) {
        next.beside->link = BesideLink::registered;
        next.beside->in3d = true;  // as a file may say
    });
    ASSERT_TRUE(test::waitFor([&] { return shown.isAtRest(); }));
    EXPECT_EQ(shown.additions(), nullptr);
    BesideBar bar(*session_, *beside_);
    bar.showState();
    const auto* in3d = bar.findChild<QCheckBox*>("beside-in3d");
    EXPECT_FALSE(in3d->isEnabled() || in3d->isChecked());
}

TEST_F(BesideTest, In3dOfFloatsAnotherCurveIsNoOtherVolume) {
    VolumeOptions options = test::sliceVolumeOptions();
    options.worldFromVoxel = kMoved * options.worldFromVoxel;
    options.unitsFromStored = {};
    std::vector<float> values(test::sliceVolume()->voxelCount());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.37f * float(i % 1000);
    auto floats = Volume::createFloat(std::move(options), std::move(values));
    ASSERT_TRUE(floats.ok());
    openLinked(studyOf(std::make_shared<const Volume>(*std::move(floats)), "prior", "20220301"));
    SegmentationKeeper segments(*session_);
    ShownAdditions shown(*session_, segments);
    shown.setSecond(beside_->second());
    const auto volumeWith = [&](double opacity) {
        session_->change("Opacity", [&](app::StudyState& next) {
            next.beside->in3d = true;
            next.beside->isDoubtful = true;
            next.beside->opacity = opacity;
        });
        EXPECT_TRUE(test::waitFor([&] { return shown.isAtRest(); }));
        return shown.additions() ? shown.additions()->second->volume : nullptr;
    };
    const auto first = volumeWith(0.3);
    ASSERT_TRUE(first && volumeWith(0.5) == first);
    EXPECT_NE(shown.additions()->remark.find("registration doubtful"), std::string::npos);
    shown.setSecond(nullptr);
    EXPECT_EQ(shown.additions(), nullptr);
}

TEST_F(BesideTest, TheBarShowsTheStateAndProposesOthers) {
    BesideBar bar(*session_, *beside_);
    EXPECT_TRUE(bar.isHidden());
    openLinked();
    EXPECT_FALSE(bar.isHidden());
    auto* views = bar.findChild<QComboBox*>("beside-view");
    auto* links = bar.findChild<QComboBox*>("beside-link");
    auto* opacity = bar.findChild<QSlider*>("beside-opacity");
    auto* white = bar.findChild<QDoubleSpinBox*>("beside-white");
    ASSERT_TRUE(views != nullptr && links != nullptr && opacity != nullptr && white != nullptr);
    EXPECT_EQ(views->currentIndex(), int(BesideView::beside));
    EXPECT_EQ(links->currentIndex(), int(BesideLink::registered));
    EXPECT_DOUBLE_EQ(white->value(), 1000.0);
    EXPECT_FALSE(state().beside->window) << "showing proposes nothing";
    emit views->activated(int(BesideView::over));
    EXPECT_EQ(state().beside->view, BesideView::over);
    opacity->setValue(25);
    EXPECT_DOUBLE_EQ(state().beside->opacity, 0.25);
    opacity->setValue(50);
    session_->undo();
    EXPECT_DOUBLE_EQ(state().beside->opacity, 0.25) << "each change by keys is one of its own";
    white->setValue(800.0);
    EXPECT_DOUBLE_EQ(state().beside->window->width, 800.0);
    white->setValue(-5000.0);  // below black
    EXPECT_DOUBLE_EQ(state().beside->window->width, 800.0);
    emit links->activated(int(BesideLink::byHand));
    EXPECT_EQ(state().beside->view, BesideView::beside) << "nothing is laid over by hand";
    EXPECT_EQ(views->currentIndex(), int(BesideView::beside));
    for (QWidget* control : bar.findChildren<QWidget*>(QRegularExpression("^beside-")))
        EXPECT_FALSE(control->accessibleName().isEmpty() || control->toolTip().isEmpty())
            << control->objectName().toStdString();
    bar.findChild<QAction*>("close-beside")->trigger();
    EXPECT_TRUE(bar.isHidden());
}

}  // namespace
}  // namespace macula::viewer
