// How a second volume is linked with a study, whose it may be, and when it is in the 3D picture. On Qt's
// platform without a screen.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QTest>
#include <memory>
#include <utility>

#include "base/phantom.h"
#include "viewer/beside/beside_bar.h"
#include "viewer/beside_fixture.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/volume/shown_additions.h"

namespace macula::viewer {
namespace {

using app::BesideLink;
using app::BesideView;

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
    ASSERT_TRUE(waitUntil([&] { return hasEnded; }));
    ASSERT_EQ(beside_->state()->link, BesideLink::registered) << (error_ ? error_->message : "");
    EXPECT_NEAR(beside_->state()->secondFromStudy[3].z, 30.0, 2.0);
    session_->undo();
    EXPECT_EQ(beside_->state()->link, BesideLink::byHand) << "one step";
}

TEST_F(BesideTest, WhatCannotBeRegisteredStaysLinkedByHandAndSaysWhy) {
    auto volume = Volume::create({.size = glm::ivec3(24), .unit = Unit::hounsfield, .modality = "CT"},
                                 std::vector<std::uint16_t>(13824, 1000));
    beside_->offer(studyOf(std::make_shared<const Volume>(*std::move(volume)), "flat", "20220301"));
    ASSERT_TRUE(waitUntil([&] { return error_.has_value(); }));
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

// The same UIDs, and other positions: what was registered then is not shown as if it were of these.
TEST_F(BesideTest, APriorThatWasExportedAnewIsPlacedAnew) {
    openLinked();
    session_->change("Look", [](app::StudyState& next) {
        next.beside->opacity = 0.25;
        next.beside->boundMm = 0.4;
    });
    const app::BesideState left = *state().beside;
    app::StudyState next;
    next.beside = left;
    session_->show(current_, next);
    VolumeOptions options = test::sliceVolumeOptions();
    options.worldFromVoxel =
        affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 7}) * kMoved * options.worldFromVoxel;
    beside_->offer(studyOf(test::sliceVolume(std::move(options)), "prior", "20220301"));
    ASSERT_NE(beside_->state(), nullptr);
    EXPECT_TRUE(beside_->isPlacedAnew());
    EXPECT_TRUE(beside_->isRegistering());
    EXPECT_EQ(beside_->state()->link, BesideLink::byHand);
    EXPECT_NE(beside_->state()->secondFromStudy, left.secondFromStudy);
    EXPECT_EQ(beside_->state()->boundMm, 0.0);
    EXPECT_EQ(beside_->state()->opacity, 0.25) << "its look stays";
    beside_->cancel();
    // So is one that was left by a Macula that knew UIDs alone.
    next.beside->pair.clear();
    session_->show(current_, next);
    beside_->offer(prior());
    EXPECT_TRUE(beside_->isPlacedAnew());
    EXPECT_EQ(beside_->state()->link, BesideLink::byHand);
    // And the study's own series, exported anew, is no longer what is open.
    VolumeOptions own = test::sliceVolumeOptions();
    own.worldFromVoxel[3].z += 5.0;
    beside_->offer(studyOf(test::sliceVolume(std::move(own)), "current", "20240301"));
    EXPECT_FALSE(error_) << error_->message;
}

TEST_F(BesideTest, ClosingItAndAnotherStudyLeaveNothing) {
    openLinked();
    std::weak_ptr<const Volume> volume = beside_->second()->study.volume;
    beside_->close();
    EXPECT_FALSE(state().beside);
    EXPECT_FALSE(pair_->showsBoth());
    ASSERT_TRUE(settled());
    EXPECT_TRUE(study().tags().isEmpty());
    EXPECT_TRUE(waitUntil([&] { return volume.expired(); })) << "its memory is not given back";
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
    const auto atRest = [&] { return waitUntil([&] { return shown.isAtRest(); }); };
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
    ASSERT_TRUE(waitUntil([&] { return shown.isAtRest(); }));
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
        EXPECT_TRUE(waitUntil([&] { return shown.isAtRest(); }));
        return shown.additions() ? shown.additions()->second->volume : nullptr;
    };
    const auto first = volumeWith(0.3);
    ASSERT_TRUE(first && volumeWith(0.5) == first);
    EXPECT_NE(shown.additions()->remark.find("registration doubtful"), std::string::npos);
    shown.setSecond(nullptr);
    EXPECT_EQ(shown.additions(), nullptr);
}

}  // namespace
}  // namespace macula::viewer
