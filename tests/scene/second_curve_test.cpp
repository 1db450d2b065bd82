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

namespace macula::app {
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
    BesideState state;
    state.link = BesideLink::registered;
    state.in3d = true;
    const auto changes = [&](const auto& edit) {
        BesideState next = state;
        edit(next);
        StudyState before;
        StudyState after;
        before.beside = state;
        after.beside = next;
        const bool isStale = staleAfter(before, after) == Stale::matter;
        EXPECT_EQ(isStale, partIn3d(next) != partIn3d(state));
        return isStale;
    };
    const auto look = [](BesideState& b) { b.view = BesideView::over; };
    const auto bound = [](BesideState& b) { b.boundMm = 0.4; };
    const auto opacity = [](BesideState& b) { b.opacity = 0.1; };
    const auto colours = [](BesideState& b) { b.colours = slices::ColourTable::grey; };
    const auto levels = [](BesideState& b) { b.window = window(0.0, 7.0); };
    EXPECT_FALSE(changes(look) || changes(bound));
    EXPECT_FALSE(changes([](BesideState& b) { b.linksWindow = true; })) << "its window in 3D is its own";
    EXPECT_TRUE(changes(opacity) && changes(colours) && changes(levels)) << "they are its curve";
    state.preset = std::make_shared<const TransferFunction>();
    EXPECT_FALSE(changes(look) || changes(bound) || changes(opacity) || changes(colours) || changes(levels));
    EXPECT_TRUE(changes([](BesideState& b) { b.preset.reset(); }));
    EXPECT_TRUE(changes([](BesideState& b) { b.secondFromStudy[3].x = 1.0; }));
    EXPECT_TRUE(changes([](BesideState& b) { b.isDoubtful = true; })) << "the picture says so";
}

TEST(SecondCurve, IsIn3dOnlyWhereItIsLinkedAndShown) {
    BesideState state;
    state.in3d = true;
    EXPECT_FALSE(isIn3d(state)) << "by hand, nobody knows where it lies";
    state.link = BesideLink::registered;
    EXPECT_TRUE(isIn3d(state));
    state.view = BesideView::hidden;
    EXPECT_FALSE(isIn3d(state));
    state.view = BesideView::over;
    state.in3d = false;
    EXPECT_FALSE(isIn3d(state));
}

TEST(SecondCurve, APresetCountsMoreAndIsFittedToTheSecondVolume) {
    BesideState state;
    state.secondFromStudy[3] = glm::dvec4(1, 2, 3, 1);
    TransferFunction preset;
    preset.unit = Unit::raw;
    preset.opacity = {{.value = 0.0, .opacity = 0.0}, {.value = 1.0, .opacity = 1.0}};
    preset.colour = {{.value = 0.0, .colour = glm::dvec3(1.0)}};
    preset.fitToVolume = TransferFunction::Fit{0.0, 1.0, TransferFunction::Fit::To::valueRange};
    state.preset = std::make_shared<const TransferFunction>(preset);
    const SecondVolume second = secondIn3d(state, pet());
    EXPECT_EQ(second.secondFromVolumeMm, state.secondFromStudy);
    EXPECT_FALSE(second.function->fitToVolume);
    EXPECT_NEAR(second.function->opacity.back().value, 26.0, 1e-6);
    EXPECT_EQ(secondRemark(*second.volume, state, SamePatient::yes), "with PT");
}

// Slices say so on each pane; the 3D picture has nothing but its remark.
TEST(SecondCurve, DoubtIsInTheRemark) {
    BesideState state;
    state.link = BesideLink::registered;
    state.isDoubtful = true;
    EXPECT_EQ(secondRemark(*pet(), state, SamePatient::yes), "with PT, registration doubtful");
    EXPECT_EQ(secondRemark(*pet(), state, SamePatient::unknown),
              "with PT, registration doubtful, perhaps of another patient");
    state.link = BesideLink::sameFrame;
    EXPECT_EQ(secondRemark(*pet(), state, SamePatient::no), "with PT, of ANOTHER PATIENT");
}

TEST(SecondCurve, OnlyWhatIsSeenIn3dMakesThePictureAnew) {
    StudyState before;
    before.beside.emplace();
    before.beside->seriesDigest = "ab";
    before.beside->link = BesideLink::sameFrame;
    StudyState after = before;
    after.beside->opacity = 0.1;
    EXPECT_EQ(staleAfter(before, after), Stale::nothing) << "it is on slices alone";
    after = before;
    after.beside->in3d = true;
    EXPECT_EQ(staleAfter(before, after), Stale::matter);
    StudyState other = after;
    other.beside->view = BesideView::over;
    EXPECT_EQ(staleAfter(after, other), Stale::nothing) << "it looks the same in 3D";
    other.beside->opacity = 0.1;
    EXPECT_EQ(staleAfter(after, other), Stale::matter);
}

TEST(SecondInput, IsReadPlacedAndSaid) {
    StudyInput study;
    study.volume = in16Bits(std::make_shared<const Volume>(phantom::make()));
    study.identity.isOfNobody = true;
    Progress progress;
    SecondWish wish;
    EXPECT_TRUE(check(wish, false).ok());
    EXPECT_FALSE(check(wish, true).ok()) << "a registration of nothing";
    wish.preset = "ct-bone";
    EXPECT_FALSE(check(wish, false).ok());
    wish.path = "phantom:";
    EXPECT_TRUE(check(wish, true).ok());
    const auto drawn = secondToDraw(wish, study, nullptr, progress);
    ASSERT_TRUE(drawn) << drawn.error().message;
    EXPECT_EQ(drawn->second.secondFromVolumeMm, glm::dmat4(1.0));
    EXPECT_EQ(drawn->remark, "with CT");
    EXPECT_FALSE(drawn->notes.empty()) << "nobody checked where it lies";
    Additions added;
    added.second = drawn->second;
    EXPECT_TRUE(validate(added, *study.volume).ok());

    // A view that was saved with it says where it lies.
    BesideState beside;
    beside.seriesDigest = "phantom";
    beside.link = BesideLink::registered;
    beside.secondFromStudy[3].x = 12.0;
    beside.pair = pairDigest(fingerprint(*study.volume), fingerprint(*study.volume));
    const auto placed = secondToDraw(wish, study, &beside, progress);
    ASSERT_TRUE(placed);
    EXPECT_EQ(placed->second.secondFromVolumeMm, beside.secondFromStudy);
    beside.volumeKey = "of another phase";  // the phantom has none: it may be this one
    EXPECT_TRUE(secondToDraw(wish, study, &beside, progress));
    beside.secondFromStudy[3].x = 1e5;
    EXPECT_FALSE(secondToDraw(wish, study, &beside, progress)) << "nothing of it lies in the study";
    wish.preset = "no such preset";
    EXPECT_FALSE(secondToDraw(wish, study, nullptr, progress));
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
    auto study = loadStudy(folder.path() / "study", {}, progress);
    ASSERT_TRUE(study) << study.error().message;
    EXPECT_EQ(study->frameOfReferenceUid, "2.25.1002");
    bringTo16Bits(*study);
    SecondWish wish;
    const auto isTold = [](const std::vector<std::string>& all, std::string_view words) {
        return std::ranges::any_of(all, [&](const std::string& one) { return one.find(words) != one.npos; });
    };

    wish.path = folder.path() / "same";
    const auto same = secondToDraw(wish, *study, nullptr, progress);
    ASSERT_TRUE(same) << same.error().message;
    EXPECT_TRUE(isTold(same->notes, "Same frame of reference, not registered: the patient may have moved"));
    EXPECT_FALSE(isTold(same->notes, "--registration"));
    EXPECT_FALSE(isTold(same->warnings, "frame of reference"));

    wish.path = folder.path() / "other";
    const auto other = secondToDraw(wish, *study, nullptr, progress);
    ASSERT_TRUE(other) << other.error().message;
    EXPECT_FALSE(isTold(other->notes, "Same frame"));
    EXPECT_TRUE(isTold(other->warnings, "another frame of reference"));
    EXPECT_TRUE(isTold(other->warnings, "--registration search"));
    EXPECT_TRUE(isTold(other->notes, "--registration search")) << "a warning is a note of the picture";

    wish.path = "phantom:";
    study->volume = in16Bits(std::make_shared<const Volume>(phantom::make()));
    const auto none = secondToDraw(wish, *study, nullptr, progress);
    ASSERT_TRUE(none) << none.error().message;
    EXPECT_TRUE(isTold(none->warnings, "not both have a frame of reference"));
    EXPECT_TRUE(isTold(none->warnings, "--registration search"));
}

TEST(SecondInput, OfAnotherPatientIsNotDrawnAndOfNobodyKnowsWhomIsSaid) {
    StudyInput study;
    study.volume = in16Bits(std::make_shared<const Volume>(phantom::make()));
    study.identity.patientId = "17";
    Progress progress;
    SecondWish wish;
    wish.path = "phantom:";
    const auto unknown = secondToDraw(wish, study, nullptr, progress);
    ASSERT_TRUE(unknown) << unknown.error().message;
    EXPECT_EQ(unknown->remark, "with CT, perhaps of another patient");

    // Two folders of one series each, of which the files alone say whose they are.
    const dicom::test::TemporaryFolder jane;
    const dicom::test::TemporaryFolder john;
    dicom::test::SyntheticSeries series;
    dicom::test::writeFiles(jane.path(), series);
    series.patientId = "SYN2";
    dicom::test::writeFiles(john.path(), series);
    const auto own = loadStudy(jane.path(), {}, progress);
    ASSERT_TRUE(own) << own.error().message;
    EXPECT_EQ(own->identity.patientId, "SYN1");
    EXPECT_FALSE(own->volumeKey.empty());
    study = *own;
    bringTo16Bits(study);
    wish.path = john.path();
    const auto refused = secondToDraw(wish, study, nullptr, progress);
    ASSERT_FALSE(refused) << "another patient's";
    EXPECT_EQ(refused.error().message, "The second volume is of another patient than the study.");
    wish.path = jane.path();
    const auto itself = secondToDraw(wish, study, nullptr, progress);
    ASSERT_FALSE(itself) << "the study's own volume";
    EXPECT_EQ(itself.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(itself.error().message, "The second volume is the study itself.");
    EXPECT_NE(itself.error().hint.find("--second-series"), std::string::npos);
    wish.series = "1";
    EXPECT_FALSE(secondToDraw(wish, study, nullptr, progress)) << "also where it was named";
    wish.series.clear();
    const dicom::test::TemporaryFolder later;
    series.patientId = "SYN1";
    series.seriesUid = "2.25.1003";
    dicom::test::writeFiles(later.path(), series);
    wish.path = later.path();
    const auto second = loadStudy(later.path(), {}, progress);
    ASSERT_TRUE(second) << second.error().message;
    EXPECT_TRUE(secondToDraw(wish, study, nullptr, progress)) << "another series of the patient";

    // What is registered of one phase of a series is not taken for another one.
    BesideState beside;
    beside.seriesDigest = second->seriesDigest;
    beside.volumeKey = second->volumeKey;
    beside.link = BesideLink::registered;
    beside.secondFromStudy[3].x = 1.0;
    study.volume = in16Bits(own->volume);
    beside.pair = pairDigest(fingerprint(*study.volume), fingerprint(*in16Bits(second->volume)));
    const auto same = secondToDraw(wish, study, &beside, progress);
    ASSERT_TRUE(same);
    EXPECT_EQ(same->second.secondFromVolumeMm, beside.secondFromStudy);
    beside.volumeKey = "of another phase";
    const auto unplaced = secondToDraw(wish, study, &beside, progress);
    ASSERT_TRUE(unplaced);
    EXPECT_EQ(unplaced->second.secondFromVolumeMm, glm::dmat4(1.0));
    beside.in3d = true;
    const auto told = secondToDraw(wish, study, &beside, progress);
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
    auto study = loadStudy(folder.path() / "study", {}, progress);
    auto prior = loadStudy(folder.path() / "prior", {}, progress);
    const auto moved = loadStudy(folder.path() / "moved", {}, progress);
    ASSERT_TRUE(study && prior && moved);
    EXPECT_EQ(prior->seriesDigest, moved->seriesDigest);
    EXPECT_EQ(prior->volumeKey, moved->volumeKey) << "nothing but its voxels and positions tells";
    bringTo16Bits(*study);
    bringTo16Bits(*prior);
    BesideState beside;
    beside.seriesDigest = prior->seriesDigest;
    beside.volumeKey = prior->volumeKey;
    beside.pair = pairDigest(fingerprint(*study->volume), fingerprint(*prior->volume));
    beside.link = BesideLink::registered;
    beside.boundMm = 0.4;
    beside.secondFromStudy[3].x = 1.0;
    beside.opacity = 0.25;
    SecondWish wish;
    const auto isWarned = [](const SecondToDraw& drawn) {
        return std::ranges::any_of(drawn.warnings, [](const std::string& warning) {
            return warning.find("is not believed") != std::string::npos;
        });
    };
    wish.path = folder.path() / "prior";
    const auto same = secondToDraw(wish, *study, &beside, progress);
    ASSERT_TRUE(same) << same.error().message;
    EXPECT_EQ(same->second.secondFromVolumeMm, beside.secondFromStudy);
    EXPECT_FALSE(isWarned(*same));
    wish.path = folder.path() / "moved";
    const auto anew = secondToDraw(wish, *study, &beside, progress);
    ASSERT_TRUE(anew) << anew.error().message;
    EXPECT_EQ(anew->second.secondFromVolumeMm, glm::dmat4(1.0));
    EXPECT_TRUE(isWarned(*anew));
    // A view of before does not say of which voxels it is.
    beside.pair.clear();
    wish.path = folder.path() / "prior";
    const auto old = secondToDraw(wish, *study, &beside, progress);
    ASSERT_TRUE(old);
    EXPECT_EQ(old->second.secondFromVolumeMm, glm::dmat4(1.0));
    EXPECT_TRUE(isWarned(*old));
    // The study itself under its own UIDs, exported anew, is another volume.
    const dicom::test::TemporaryFolder again;
    dicom::test::SyntheticSeries itself;
    itself.worldFromVoxel[3].z += 4.0;
    dicom::test::writeFiles(again.path(), itself);
    wish.path = again.path();
    EXPECT_TRUE(secondToDraw(wish, *study, nullptr, progress));
}

}  // namespace
}  // namespace macula::app
