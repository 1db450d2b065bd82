// A second volume in the 3D picture of a study: its curve, when it is there, and what of a state that
// changes.
#include "scene/second/second_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "base/fingerprint.h"
#include "base/phantom.h"
#include "scene/second/second_input.h"
#include "scene/state/study_state.h"
#include "support.h"
#include "synthetic.h"

namespace macula::scene {
namespace {

std::shared_ptr<const Volume> pet() {
    std::vector<std::uint16_t> voxels(27);
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = std::uint16_t(i);
    auto made = Volume::create({.size = {3, 3, 3},
                                .worldFromVoxel = affine({9, 0, 0}, {0, 9, 0}, {0, 0, 9}, {-9, -9, -9}),
                                .unit = Unit::becquerelsPerMillilitre,
                                .modality = "PT"},
                               std::move(voxels));
    return std::make_shared<const Volume>(*std::move(made));
}

DisplayWindow window(double low, double high) {
    return {.center = 0.5 * (low + high), .width = high - low, .explanation = {}, .function = "LINEAR_EXACT"};
}

TEST(SecondCurve, HasTheColoursAndTheWindowThatItHasOverSlices) {
    const TransferFunction curve = secondCurve(*pet(), window(0.0, 20.0), slices::ColourTable::hotIron, 0.5);
    ASSERT_TRUE(validate(curve).ok());
    EXPECT_EQ(curve.unit, Unit::becquerelsPerMillilitre);
    EXPECT_EQ(opacityAt(curve, 4.9), 0.0) << "the lowest quarter hides nothing";
    EXPECT_GT(opacityAt(curve, 10.0), 0.0);
    EXPECT_NEAR(opacityAt(curve, 20.0), 0.5 * 0.95, 1e-9);
    EXPECT_NEAR(opacityAt(curve, 1e6), 0.5 * 0.95, 1e-9);
    EXPECT_LT(glm::distance(colourAt(curve, 20.0), glm::dvec3(1.0)), 0.02) << "hot iron ends in white";
    EXPECT_GT(colourAt(curve, 8.0).r, colourAt(curve, 8.0).b);
    // Whatever a state may hold: it stays a curve.
    for (const double opacity : {0.0, 1.0, 7.0})
        EXPECT_TRUE(
            validate(secondCurve(*pet(), window(-1e9, 1e9), slices::ColourTable::grey, opacity)).ok());
    EXPECT_TRUE(validate(secondCurve(*pet(), window(3.0, 3.0 + 1e-9), slices::ColourTable::green, 1.0)).ok());
}

TEST(SecondCurve, OfThePictureIn3dIsNotHowItIsOnSlices) {
    SecondVolumeState state;
    state.link = SecondVolumeLink::registered;
    state.in3d = true;
    const auto changes = [&](const auto& edit) {
        SecondVolumeState next = state;
        edit(next);
        StudyState before;
        StudyState after;
        before.secondVolume = state;
        after.secondVolume = next;
        const bool isStale = staleAfter(before, after) == Stale::matter;
        EXPECT_EQ(isStale, secondPartIn3d(next) != secondPartIn3d(state));
        return isStale;
    };
    const auto look = [](SecondVolumeState& b) { b.view = SecondVolumePlace::over; };
    const auto bound = [](SecondVolumeState& b) { b.boundMm = 0.4; };
    const auto opacity = [](SecondVolumeState& b) { b.opacity = 0.1; };
    const auto colours = [](SecondVolumeState& b) { b.colours = slices::ColourTable::grey; };
    const auto levels = [](SecondVolumeState& b) { b.window = window(0.0, 7.0); };
    EXPECT_FALSE(changes(look) || changes(bound));
    EXPECT_FALSE(changes([](SecondVolumeState& b) { b.linksWindow = true; }))
        << "its window in 3D is its own";
    EXPECT_TRUE(changes(opacity) && changes(colours) && changes(levels)) << "they are its curve";
    state.preset = std::make_shared<const TransferFunction>();
    EXPECT_FALSE(changes(look) || changes(bound) || changes(opacity) || changes(colours) || changes(levels));
    EXPECT_TRUE(changes([](SecondVolumeState& b) { b.preset.reset(); }));
    EXPECT_TRUE(changes([](SecondVolumeState& b) { b.secondFromStudy[3].x = 1.0; }));
    EXPECT_TRUE(changes([](SecondVolumeState& b) { b.isDoubtful = true; })) << "the picture says so";
}

TEST(SecondCurve, IsIn3dOnlyWhereItIsLinkedAndShown) {
    SecondVolumeState state;
    state.in3d = true;
    EXPECT_FALSE(isSecondIn3d(state)) << "by hand, nobody knows where it lies";
    state.link = SecondVolumeLink::registered;
    EXPECT_TRUE(isSecondIn3d(state));
    state.view = SecondVolumePlace::hidden;
    EXPECT_FALSE(isSecondIn3d(state));
    state.view = SecondVolumePlace::over;
    state.in3d = false;
    EXPECT_FALSE(isSecondIn3d(state));
}

TEST(SecondCurve, APresetCountsMoreAndIsFittedToTheSecondVolume) {
    SecondVolumeState state;
    state.secondFromStudy[3] = glm::dvec4(1, 2, 3, 1);
    TransferFunction preset;
    preset.unit = Unit::raw;
    preset.opacity = {{.value = 0.0, .opacity = 0.0}, {.value = 1.0, .opacity = 1.0}};
    preset.colour = {{.value = 0.0, .colour = glm::dvec3(1.0)}};
    preset.fitToVolume = TransferFunction::Fit{0.0, 1.0, TransferFunction::Fit::To::valueRange};
    state.preset = std::make_shared<const TransferFunction>(preset);
    const DrawnSecondVolume second = secondIn3d(state, pet());
    EXPECT_EQ(second.secondFromVolumeMm, state.secondFromStudy);
    EXPECT_FALSE(second.function->fitToVolume);
    EXPECT_NEAR(second.function->opacity.back().value, 26.0, 1e-6);
    EXPECT_EQ(secondRemark(*second.volume, state, study::SamePatient::yes), "with PT");
}

// Slices say so on each pane; the 3D picture has nothing but its remark.
TEST(SecondCurve, DoubtIsInTheRemark) {
    SecondVolumeState state;
    state.link = SecondVolumeLink::registered;
    state.isDoubtful = true;
    EXPECT_EQ(secondRemark(*pet(), state, study::SamePatient::yes), "with PT, registration doubtful");
    EXPECT_EQ(secondRemark(*pet(), state, study::SamePatient::unknown),
              "with PT, registration doubtful, perhaps of another patient");
    state.link = SecondVolumeLink::sameFrame;
    EXPECT_EQ(secondRemark(*pet(), state, study::SamePatient::no), "with PT, of ANOTHER PATIENT");
}

TEST(SecondCurve, OnlyWhatIsSeenIn3dMakesThePictureAnew) {
    StudyState before;
    before.secondVolume.emplace();
    before.secondVolume->seriesDigest = "ab";
    before.secondVolume->link = SecondVolumeLink::sameFrame;
    StudyState after = before;
    after.secondVolume->opacity = 0.1;
    EXPECT_EQ(staleAfter(before, after), Stale::nothing) << "it is on slices alone";
    after = before;
    after.secondVolume->in3d = true;
    EXPECT_EQ(staleAfter(before, after), Stale::matter);
    StudyState other = after;
    other.secondVolume->view = SecondVolumePlace::over;
    EXPECT_EQ(staleAfter(after, other), Stale::nothing) << "it looks the same in 3D";
    other.secondVolume->opacity = 0.1;
    EXPECT_EQ(staleAfter(after, other), Stale::matter);
}

TEST(SecondInput, IsReadPlacedAndSaid) {
    study::LoadedStudy study;
    study.volume = in16Bits(std::make_shared<const Volume>(phantom::make()));
    study.identity.isOfNobody = true;
    Progress progress;
    SecondVolumeRequest request;
    EXPECT_TRUE(check(request, false).ok());
    EXPECT_FALSE(check(request, true).ok()) << "a registration of nothing";
    request.preset = "ct-bone";
    EXPECT_FALSE(check(request, false).ok());
    request.path = "phantom:";
    EXPECT_TRUE(check(request, true).ok());
    const auto drawn = secondToDraw(request, study, nullptr, progress);
    ASSERT_TRUE(drawn) << drawn.error().message;
    EXPECT_EQ(drawn->second.secondFromVolumeMm, glm::dmat4(1.0));
    EXPECT_EQ(drawn->remark, "with CT");
    EXPECT_FALSE(drawn->notes.empty()) << "nobody checked where it lies";
    Additions added;
    added.second = drawn->second;
    EXPECT_TRUE(validate(added, *study.volume).ok());

    // A view that was saved with it says where it lies.
    SecondVolumeState beside;
    beside.seriesDigest = "phantom";
    beside.link = SecondVolumeLink::registered;
    beside.secondFromStudy[3].x = 12.0;
    beside.pair = pairDigest(fingerprint(*study.volume), fingerprint(*study.volume));
    const auto placed = secondToDraw(request, study, &beside, progress);
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->second.secondFromVolumeMm, beside.secondFromStudy);
    beside.volumeKey = "of another phase";  // the phantom has none: it may be this one
    EXPECT_TRUE(secondToDraw(request, study, &beside, progress));
    beside.secondFromStudy[3].x = 1e5;
    EXPECT_FALSE(secondToDraw(request, study, &beside, progress)) << "nothing of it lies in the study";
    request.preset = "no such preset";
    EXPECT_FALSE(secondToDraw(request, study, nullptr, progress));
}

TEST(SecondInput, WhereItLiesIsSaidByTheFramesOfReference) {
    const dicom::test::TemporaryFolder folder;
    dicom::test::SyntheticSeries series;
    dicom::test::writeFiles(folder.path() / "study", series);
    series.seriesUid = "2.25.1003";
    dicom::test::writeFiles(folder.path() / "same", series);
    series.frameOfReferenceUid = "2.25.1004";
    dicom::test::writeFiles(folder.path() / "other", series);
    Progress progress;
    auto study = study::loadStudy(folder.path() / "study", {}, progress);
    ASSERT_TRUE(study) << study.error().message;
    EXPECT_EQ(study->frameOfReferenceUid, "2.25.1002");
    study::bringTo16Bits(*study);
    SecondVolumeRequest request;
    const auto isTold = [](const std::vector<Text>& all, std::string_view words) {
        return std::ranges::any_of(
            all, [&](const Text& one) { return one.english().find(words) != std::string::npos; });
    };

    request.path = folder.path() / "same";
    const auto same = secondToDraw(request, *study, nullptr, progress);
    ASSERT_TRUE(same) << same.error().message;
    EXPECT_TRUE(isTold(same->notes, "Same frame of reference, not registered: the patient may have moved"));
    EXPECT_FALSE(isTold(same->notes, "--registration"));
    EXPECT_FALSE(isTold(same->warnings, "frame of reference"));

    request.path = folder.path() / "other";
    const auto other = secondToDraw(request, *study, nullptr, progress);
    ASSERT_TRUE(other) << other.error().message;
    EXPECT_FALSE(isTold(other->notes, "Same frame"));
    EXPECT_TRUE(isTold(other->warnings, "another frame of reference"));
    EXPECT_TRUE(isTold(other->warnings, "--registration search"));
    EXPECT_TRUE(isTold(other->notes, "--registration search")) << "a warning is a note of the picture";

    request.path = "phantom:";
    study->volume = in16Bits(std::make_shared<const Volume>(phantom::make()));
    const auto none = secondToDraw(request, *study, nullptr, progress);
    ASSERT_TRUE(none) << none.error().message;
    EXPECT_TRUE(isTold(none->warnings, "not both have a frame of reference"));
    EXPECT_TRUE(isTold(none->warnings, "--registration search"));
}

TEST(SecondInput, OfAnotherPatientIsNotDrawnAndOfNobodyKnowsWhomIsSaid) {
    study::LoadedStudy study;
    study.volume = in16Bits(std::make_shared<const Volume>(phantom::make()));
    study.identity.patientId = "17";
    Progress progress;
    SecondVolumeRequest request;
    request.path = "phantom:";
    const auto unknown = secondToDraw(request, study, nullptr, progress);
    ASSERT_TRUE(unknown) << unknown.error().message;
    EXPECT_EQ(unknown->remark, "with CT, perhaps of another patient");

    // Two folders of one series each, of which the files alone say whose they are.
    const dicom::test::TemporaryFolder jane;
    const dicom::test::TemporaryFolder john;
    dicom::test::SyntheticSeries series;
    dicom::test::writeFiles(jane.path(), series);
    series.patientId = "SYN2";
    dicom::test::writeFiles(john.path(), series);
    const auto own = study::loadStudy(jane.path(), {}, progress);
    ASSERT_TRUE(own) << own.error().message;
    EXPECT_EQ(own->identity.patientId, "SYN1");
    EXPECT_FALSE(own->volumeKey.empty());
    study = *own;
    study::bringTo16Bits(study);
    request.path = john.path();
    const auto refused = secondToDraw(request, study, nullptr, progress);
    ASSERT_FALSE(refused) << "another patient's";
    EXPECT_EQ(refused.error().message, "The second volume is of another patient than the study.");
    request.path = jane.path();
    const auto itself = secondToDraw(request, study, nullptr, progress);
    ASSERT_FALSE(itself) << "the study's own volume";
    EXPECT_EQ(itself.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(itself.error().message, "The second volume is the study itself.");
    EXPECT_NE(itself.error().hint.english().find("--second-series"), std::string::npos);
    request.series = "1";
    EXPECT_FALSE(secondToDraw(request, study, nullptr, progress)) << "also where it was named";
    request.series.clear();
    const dicom::test::TemporaryFolder later;
    series.patientId = "SYN1";
    series.seriesUid = "2.25.1003";
    dicom::test::writeFiles(later.path(), series);
    request.path = later.path();
    const auto second = study::loadStudy(later.path(), {}, progress);
    ASSERT_TRUE(second) << second.error().message;
    EXPECT_TRUE(secondToDraw(request, study, nullptr, progress)) << "another series of the patient";

    // What is registered of one phase of a series is not taken for another one.
    SecondVolumeState beside;
    beside.seriesDigest = second->seriesDigest;
    beside.volumeKey = second->volumeKey;
    beside.link = SecondVolumeLink::registered;
    beside.secondFromStudy[3].x = 1.0;
    study.volume = in16Bits(own->volume);
    beside.pair = pairDigest(fingerprint(*study.volume), fingerprint(*in16Bits(second->volume)));
    const auto same = secondToDraw(request, study, &beside, progress);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->second.secondFromVolumeMm, beside.secondFromStudy);
    beside.volumeKey = "of another phase";
    const auto unplaced = secondToDraw(request, study, &beside, progress);
    ASSERT_TRUE(unplaced);
    EXPECT_EQ(unplaced->second.secondFromVolumeMm, glm::dmat4(1.0));
    beside.in3d = true;
    const auto told = secondToDraw(request, study, &beside, progress);
    ASSERT_TRUE(told);
    EXPECT_EQ(told->notes.size(), unplaced->notes.size() + 1) << "the view had another one in the picture";
}

// Under the same UIDs the prior was exported anew, with its positions set right.
TEST(SecondInput, APlaceIsOfTheVoxelsAndPositionsThatItWasFoundWith) {
    const dicom::test::TemporaryFolder folder;
    dicom::test::SyntheticSeries series;
    dicom::test::writeFiles(folder.path() / "study", series);
    series.seriesUid = "2.25.1003";
    dicom::test::writeFiles(folder.path() / "prior", series);
    series.worldFromVoxel[3] += glm::dvec4(0.0, 0.0, 4.0, 0.0);
    dicom::test::writeFiles(folder.path() / "moved", series);
    Progress progress;
    auto study = study::loadStudy(folder.path() / "study", {}, progress);
    auto prior = study::loadStudy(folder.path() / "prior", {}, progress);
    const auto moved = study::loadStudy(folder.path() / "moved", {}, progress);
    ASSERT_TRUE(study && prior && moved);
    EXPECT_EQ(prior->seriesDigest, moved->seriesDigest);
    EXPECT_EQ(prior->volumeKey, moved->volumeKey) << "nothing but its voxels and positions tells";
    study::bringTo16Bits(*study);
    study::bringTo16Bits(*prior);
    SecondVolumeState beside;
    beside.seriesDigest = prior->seriesDigest;
    beside.volumeKey = prior->volumeKey;
    beside.pair = pairDigest(fingerprint(*study->volume), fingerprint(*prior->volume));
    beside.link = SecondVolumeLink::registered;
    beside.boundMm = 0.4;
    beside.secondFromStudy[3].x = 1.0;
    beside.opacity = 0.25;
    SecondVolumeRequest request;
    const auto isWarned = [](const DrawableSecond& drawn) {
        return std::ranges::any_of(drawn.warnings, [](const Text& warning) {
            return warning.english().find("is not believed") != std::string::npos;
        });
    };
    request.path = folder.path() / "prior";
    const auto same = secondToDraw(request, *study, &beside, progress);
    ASSERT_TRUE(same) << same.error().message;
    EXPECT_EQ(same->second.secondFromVolumeMm, beside.secondFromStudy);
    EXPECT_FALSE(isWarned(*same));
    request.path = folder.path() / "moved";
    const auto anew = secondToDraw(request, *study, &beside, progress);
    ASSERT_TRUE(anew) << anew.error().message;
    EXPECT_EQ(anew->second.secondFromVolumeMm, glm::dmat4(1.0));
    EXPECT_TRUE(isWarned(*anew));
    // A view of before does not say of which voxels it is.
    beside.pair.clear();
    request.path = folder.path() / "prior";
    const auto old = secondToDraw(request, *study, &beside, progress);
    ASSERT_TRUE(old);
    EXPECT_EQ(old->second.secondFromVolumeMm, glm::dmat4(1.0));
    EXPECT_TRUE(isWarned(*old));
    // The study itself under its own UIDs, exported anew, is another volume.
    const dicom::test::TemporaryFolder again;
    dicom::test::SyntheticSeries itself;
    itself.worldFromVoxel[3].z += 4.0;
    dicom::test::writeFiles(again.path(), itself);
    request.path = again.path();
    EXPECT_TRUE(secondToDraw(request, *study, nullptr, progress));
}

}  // namespace
}  // namespace macula::scene
