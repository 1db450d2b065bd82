// How a second volume is linked with a study, whose it may be, and when it is in the 3D picture. On Qt's
// platform without a screen.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QTest>
#include <memory>
#include <utility>

#include "base/phantom.h"
#include "viewer/second/second_volume_bar.h"
#include "viewer/second_fixture.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/volume/shown_additions.h"

namespace macula::viewer {
namespace {

using scene::SecondVolumeLink;
using scene::SecondVolumePlace;

TEST_F(SecondVolumeTest, ByHandNothingIsComparedAndTheWheelMovesTheSecondAlone) {
    secondVolume_->offer(prior());
    secondVolume_->cancel();  // the registration
    ASSERT_TRUE(secondVolume_->state());
    EXPECT_EQ(secondVolume_->state()->link, SecondVolumeLink::byHand);
    ASSERT_TRUE(settled());
    EXPECT_TRUE(second().notes().join(' ').contains("Not registered"));
    secondVolume_->setView(SecondVolumePlace::over);
    EXPECT_EQ(secondVolume_->state()->view, SecondVolumePlace::beside) << "nobody knows where it lies";
    const auto before = state();
    turnWheel(second(), 1);
    EXPECT_EQ(state().slices, before.slices);
    EXPECT_NEAR(state().secondVolume->secondFromStudy[3].z - before.secondVolume->secondFromStudy[3].z, 2.0,
                1e-9);
    turnWheel(second(), 1000);
    EXPECT_LT(state().secondVolume->secondFromStudy[3].z - before.secondVolume->secondFromStudy[3].z, 3.0)
        << "it stays in sight";
    QTest::mouseClick(&second(), Qt::LeftButton, {}, QPoint(60, 60));
    EXPECT_EQ(state().slices.crosshairMm, before.slices.crosshairMm) << "this is no place in the study";
}

TEST_F(SecondVolumeTest, AnotherPatientIsAskedAboutAndSaid) {
    study::OpenedStudy other = prior();
    other.identity.patientId = "18";
    other.identity.birthDate = "19800101";
    secondVolume_->offer(other);
    ASSERT_TRUE(asked_);
    EXPECT_EQ(*asked_, QStringList({"ID", "date of birth"})) << "no values";
    EXPECT_EQ(secondVolume_->second(), nullptr) << "nothing is shown before the answer";
    EXPECT_FALSE(state().secondVolume);
    secondVolume_->refusePatient();
    secondVolume_->acceptPatient();
    EXPECT_EQ(secondVolume_->second(), nullptr) << "it was refused";

    secondVolume_->offer(other);
    secondVolume_->acceptPatient();
    secondVolume_->cancel();
    ASSERT_TRUE(settled());
    EXPECT_TRUE(second().notes().join(' ').contains("ANOTHER PATIENT"));
    secondVolume_->flip();
    ASSERT_TRUE(settled());
    EXPECT_TRUE(study().notes().join(' ').contains("ANOTHER PATIENT"));
}

TEST_F(SecondVolumeTest, WhereImagesDoNotTellWhoItIsThePaneSaysSo) {
    study::OpenedStudy file = prior();
    file.identity = {.series = Text("File brain.nii")};
    secondVolume_->offer(file);
    secondVolume_->cancel();
    EXPECT_FALSE(asked_);
    ASSERT_TRUE(settled());
    EXPECT_TRUE(second().notes().join(' ').contains("do not tell whether both are of one patient"));
    EXPECT_EQ(second().tags(), QStringList("Second: CT, no study date"));
}

TEST_F(SecondVolumeTest, OneFrameOfReferenceNeedsNoRegistration) {
    current_.frameOfReferenceUid = "1.2.3";
    session_->show(current_, {});
    study::OpenedStudy pet = prior();
    pet.frameOfReferenceUid = "1.2.3";
    secondVolume_->offer(pet);
    EXPECT_FALSE(secondVolume_->isRegistering());
    EXPECT_EQ(secondVolume_->state()->link, SecondVolumeLink::sameFrame);
    EXPECT_EQ(secondVolume_->state()->secondFromStudy, glm::dmat4(1.0));
    ASSERT_TRUE(settled());
    EXPECT_TRUE(second().notes().join(' ').contains("the patient may have moved"));
    // A frame of reference that two patients share is none.
    pet.seriesDigest = "another";
    pet.identity.patientId = "18";
    secondVolume_->offer(pet);
    secondVolume_->acceptPatient();
    EXPECT_EQ(secondVolume_->state()->link, SecondVolumeLink::byHand);
    secondVolume_->linkByFrame();
    EXPECT_EQ(secondVolume_->state()->link, SecondVolumeLink::byHand);
}

TEST_F(SecondVolumeTest, AnyOtherIsRegisteredByItself) {
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
    QObject::connect(&*secondVolume_, &SecondVolumeLoader::ended, &*secondVolume_, [&] { hasEnded = true; });
    secondVolume_->offer(studyOf(std::make_shared<const Volume>(*std::move(volume)), "prior", "20220301"));
    EXPECT_TRUE(secondVolume_->isRegistering());
    ASSERT_TRUE(waitUntil([&] { return hasEnded; }));
    ASSERT_EQ(secondVolume_->state()->link, SecondVolumeLink::registered)
        << (error_ ? error_->message : Text());
    EXPECT_NEAR(secondVolume_->state()->secondFromStudy[3].z, 30.0, 2.0);
    session_->undo();
    EXPECT_EQ(secondVolume_->state()->link, SecondVolumeLink::byHand) << "one step";
}

TEST_F(SecondVolumeTest, WhatCannotBeRegisteredStaysLinkedByHandAndSaysWhy) {
    auto volume = Volume::create({.size = glm::ivec3(24), .unit = Unit::hounsfield, .modality = "CT"},
                                 std::vector<std::uint16_t>(13824, 1000));
    secondVolume_->offer(studyOf(std::make_shared<const Volume>(*std::move(volume)), "flat", "20220301"));
    ASSERT_TRUE(waitUntil([&] { return error_.has_value(); }));
    EXPECT_NE(error_->message.english().find("the same value everywhere"), std::string::npos);
    EXPECT_EQ(secondVolume_->state()->link, SecondVolumeLink::byHand);
}

TEST_F(SecondVolumeTest, ItIsNotOpenedBesideItself) {
    secondVolume_->offer(current_);
    ASSERT_TRUE(error_);
    EXPECT_EQ(error_->code, ErrorCode::usage);
    EXPECT_EQ(secondVolume_->second(), nullptr);
}

TEST_F(SecondVolumeTest, AStateThatKnowsTheLinkNeedsNoSecondRegistration) {
    openLinked();
    const scene::SecondVolumeState left = *state().secondVolume;
    scene::StudyState next;
    next.secondVolume = left;
    session_->show(current_, next);
    EXPECT_EQ(secondVolume_->second(), nullptr) << "it is of the study before";
    EXPECT_EQ(secondVolume_->state(), nullptr);
    secondVolume_->offer(prior());
    EXPECT_FALSE(secondVolume_->isRegistering());
    EXPECT_EQ(*secondVolume_->state(), left);
}

// The same UIDs, and other positions: what was registered then is not shown as if it were of these.
TEST_F(SecondVolumeTest, APriorThatWasExportedAnewIsPlacedAnew) {
    openLinked();
    session_->change("Look", [](scene::StudyState& next) {
        next.secondVolume->opacity = 0.25;
        next.secondVolume->boundMm = 0.4;
    });
    const scene::SecondVolumeState left = *state().secondVolume;
    scene::StudyState next;
    next.secondVolume = left;
    session_->show(current_, next);
    VolumeOptions options = test::sliceVolumeOptions();
    options.worldFromVoxel =
        affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 7}) * kMoved * options.worldFromVoxel;
    secondVolume_->offer(studyOf(test::sliceVolume(std::move(options)), "prior", "20220301"));
    ASSERT_NE(secondVolume_->state(), nullptr);
    EXPECT_TRUE(secondVolume_->isPlacedAnew());
    EXPECT_TRUE(secondVolume_->isRegistering());
    EXPECT_EQ(secondVolume_->state()->link, SecondVolumeLink::byHand);
    EXPECT_NE(secondVolume_->state()->secondFromStudy, left.secondFromStudy);
    EXPECT_EQ(secondVolume_->state()->boundMm, 0.0);
    EXPECT_EQ(secondVolume_->state()->opacity, 0.25) << "its look stays";
    secondVolume_->cancel();
    // So is one that was left by a Macula that knew UIDs alone.
    next.secondVolume->pair.clear();
    session_->show(current_, next);
    secondVolume_->offer(prior());
    EXPECT_TRUE(secondVolume_->isPlacedAnew());
    EXPECT_EQ(secondVolume_->state()->link, SecondVolumeLink::byHand);
    // And the study's own series, exported anew, is no longer what is open.
    VolumeOptions own = test::sliceVolumeOptions();
    own.worldFromVoxel[3].z += 5.0;
    secondVolume_->offer(studyOf(test::sliceVolume(std::move(own)), "current", "20240301"));
    EXPECT_FALSE(error_) << error_->message;
}

TEST_F(SecondVolumeTest, ClosingItAndAnotherStudyLeaveNothing) {
    openLinked();
    std::weak_ptr<const Volume> volume = secondVolume_->second()->study.volume;
    secondVolume_->close();
    EXPECT_FALSE(state().secondVolume);
    EXPECT_FALSE(pair_->showsBoth());
    ASSERT_TRUE(settled());
    EXPECT_TRUE(study().tags().isEmpty());
    EXPECT_TRUE(waitUntil([&] { return volume.expired(); })) << "its memory is not given back";
    openLinked();
    session_->show(current_, {});
    EXPECT_EQ(secondVolume_->second(), nullptr);
    secondVolume_->flip();
    secondVolume_->registerNow();
    secondVolume_->linkByHand();
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(SecondVolumeTest, In3dItIsThereWhileItIsLinkedAndAskedFor) {
    openLinked();
    SegmentationKeeper segments(*session_);
    ShownAdditions shown(*session_, segments);
    shown.setSecond(secondVolume_->second());
    EXPECT_EQ(shown.additions(), nullptr);
    SecondVolumeBar bar(*session_, *secondVolume_);
    auto* in3d = bar.findChild<QCheckBox*>("beside-in3d");
    auto* presets = bar.findChild<QComboBox*>("beside-preset");
    ASSERT_TRUE(in3d != nullptr && presets != nullptr);
    EXPECT_FALSE(presets->isEnabled());
    in3d->click();
    EXPECT_TRUE(state().secondVolume->in3d);
    EXPECT_TRUE(presets->isEnabled());
    const auto atRest = [&] { return waitUntil([&] { return shown.isAtRest(); }); };
    ASSERT_TRUE(atRest());
    ASSERT_TRUE(shown.additions() && shown.additions()->second);
    EXPECT_EQ(shown.additions()->second->secondFromVolumeMm, kMoved);
    EXPECT_TRUE(validate(*shown.additions(), *current_.volume).ok());

    const auto before = shown.additions();
    session_->change("View",
                     [](scene::StudyState& next) { next.secondVolume->view = SecondVolumePlace::over; });
    ASSERT_TRUE(atRest());
    EXPECT_EQ(shown.additions(), before) << "in 3D it is the same";
    session_->change("Opacity", [](scene::StudyState& next) { next.secondVolume->opacity = 0.2; });
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
    session_->change("Link",
                     [](scene::StudyState& next) { next.secondVolume->link = SecondVolumeLink::byHand; });
    EXPECT_EQ(shown.additions(), nullptr) << "nobody knows where it lies";
    EXPECT_FALSE(in3d->isEnabled());
}

// Nothing in a 3D picture tells whose matter is whose.
TEST_F(SecondVolumeTest, AnotherPatientIsNeverInThe3dPictureOfThisOne) {
    study::OpenedStudy other = prior();
    other.identity.patientId = "18";
    secondVolume_->offer(other);
    secondVolume_->acceptPatient();
    secondVolume_->cancel();
    SegmentationKeeper segments(*session_);
    ShownAdditions shown(*session_, segments);
    shown.setSecond(secondVolume_->second());
    session_->change("Link", [](scene::StudyState& next) {
        next.secondVolume->link = SecondVolumeLink::registered;
        next.secondVolume->in3d = true;  // as a file may say
    });
    ASSERT_TRUE(waitUntil([&] { return shown.isAtRest(); }));
    EXPECT_EQ(shown.additions(), nullptr);
    SecondVolumeBar bar(*session_, *secondVolume_);
    bar.showState();
    const auto* in3d = bar.findChild<QCheckBox*>("beside-in3d");
    EXPECT_FALSE(in3d->isEnabled() || in3d->isChecked());
}

TEST_F(SecondVolumeTest, In3dOfFloatsAnotherCurveIsNoOtherVolume) {
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
    shown.setSecond(secondVolume_->second());
    const auto volumeWith = [&](double opacity) {
        session_->change("Opacity", [&](scene::StudyState& next) {
            next.secondVolume->in3d = true;
            next.secondVolume->isDoubtful = true;
            next.secondVolume->opacity = opacity;
        });
        EXPECT_TRUE(waitUntil([&] { return shown.isAtRest(); }));
        return shown.additions() ? shown.additions()->second->volume : nullptr;
    };
    const auto first = volumeWith(0.3);
    ASSERT_TRUE(first && volumeWith(0.5) == first);
    EXPECT_NE(shown.additions()->remark.english().find("registration doubtful"), std::string::npos);
    shown.setSecond(nullptr);
    EXPECT_EQ(shown.additions(), nullptr);
}

}  // namespace
}  // namespace macula::viewer
