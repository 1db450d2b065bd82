// A second volume: whose, how old, and where it lies.
#include "scene/second/second_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/fingerprint.h"
#include "base/sha256.h"
#include "study/found_by_hand.h"

namespace macula::scene {
namespace {

study::Identity jane() {
    return {.patientName = "DOE^JANE",
            .patientId = "17",
            .birthDate = "19700102",
            .sex = "F",
            .studyDate = "20240301",
            .studyDescription = "Chest",
            .series = Text("CT, series 3: Miller")};
}

study::OpenedStudy studyOf(study::Identity identity, const glm::dvec3& firstMm = glm::dvec3(0.0)) {
    auto volume = Volume::create({.size = {4, 5, 6},
                                  .worldFromVoxel = affine({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, firstMm),
                                  .unit = Unit::hounsfield,
                                  .modality = "CT"},
                                 std::vector<std::uint16_t>(120, 7));
    study::OpenedStudy study;
    study.volume = std::make_shared<const Volume>(*std::move(volume));
    study.seriesDigest = "digest";
    study.identity = std::move(identity);
    return study;
}

template <class Change>
study::Identity janeBut(Change change) {
    study::Identity identity = jane();
    change(identity);
    return identity;
}

TEST(SecondStudy, IsOfTheSamePatientOnlyWhereAllAgrees) {
    EXPECT_EQ(study::samePatient(jane(), jane()), study::SamePatient::yes);
    EXPECT_EQ(study::samePatient(jane(), janeBut([](auto& i) { i.patientName = "Doe^Jane^^^ "; })),
              study::SamePatient::yes)
        << "written otherwise";
    EXPECT_EQ(study::samePatient(jane(), janeBut([](auto& i) { i.birthDate = "1970.01.02"; })),
              study::SamePatient::yes);
    EXPECT_EQ(study::samePatient(jane(), janeBut([](auto& i) { i.studyDate = "20200101"; })),
              study::SamePatient::yes);
    EXPECT_EQ(study::samePatient({.series = Text("File a.nii")}, {.series = Text("File b.nii")}),
              study::SamePatient::unknown);
    EXPECT_EQ(study::samePatient(jane(), {.series = Text("File a.nii")}), study::SamePatient::unknown);
    EXPECT_EQ(study::samePatient(jane(), janeBut([](auto& i) { i.birthDate.clear(); })),
              study::SamePatient::unknown);
    EXPECT_EQ(study::samePatient({.series = Text("a"), .isOfNobody = true},
                                 {.series = Text("a"), .isOfNobody = true}),
              study::SamePatient::yes);
    EXPECT_NE(study::samePatient(jane(), {.series = Text("a"), .isOfNobody = true}), study::SamePatient::yes);
}

// Two studies that were made anonymous by the same program are not for that of one patient.
TEST(SecondStudy, PlaceholdersAreOfNobody) {
    const study::Identity nobody{
        .patientName = "ANONYMOUS", .patientId = "0000", .birthDate = "19000101", .sex = "F"};
    EXPECT_EQ(study::samePatient(nobody, nobody), study::SamePatient::unknown);
    EXPECT_EQ(study::samePatient(nobody, jane()), study::SamePatient::unknown) << "and nothing differs";
    EXPECT_EQ(study::samePatient(jane(), nobody), study::SamePatient::unknown);
    EXPECT_TRUE(study::whatDiffers(nobody, jane()).empty());
    for (const char* name : {"", "Patient^Anonymous", "De-Identified", "XXXX^XXXX", "unknown"}) {
        study::Identity named = nobody;
        named.patientName = name;
        EXPECT_EQ(study::samePatient(named, nobody), study::SamePatient::unknown) << name;
    }
    study::Identity man = nobody;
    man.sex = "M";
    EXPECT_EQ(study::samePatient(nobody, man), study::SamePatient::no) << "that much is known";
    man.sex = "U";
    EXPECT_EQ(study::samePatient(nobody, man), study::SamePatient::unknown);
    // Pseudonyms tell.
    study::Identity first = nobody;
    first.patientId = "ANON0017";
    study::Identity other = nobody;
    other.patientId = "ANON0018";
    EXPECT_EQ(study::samePatient(first, first), study::SamePatient::yes);
    EXPECT_EQ(study::samePatient(first, other), study::SamePatient::no);
    // A study is of one patient: a PET and its CT.
    study::Identity pet = nobody;
    pet.studyInstanceUid = "1.2.3";
    study::Identity ct = pet;
    EXPECT_EQ(study::samePatient(pet, ct), study::SamePatient::yes);
    ct.studyInstanceUid = "1.2.4";
    EXPECT_EQ(study::samePatient(pet, ct), study::SamePatient::unknown);
}

TEST(SecondStudy, OneThingThatDiffersIsAnotherPatient) {
    using Names = std::vector<std::string>;
    const auto differs = [](auto change) {
        const study::Identity other = janeBut(change);
        EXPECT_EQ(study::samePatient(jane(), other), study::SamePatient::no);
        EXPECT_EQ(study::samePatient(other, jane()), study::SamePatient::no);
        return study::whatDiffers(jane(), other);
    };
    EXPECT_EQ(differs([](auto& i) { i.patientId = "18"; }), Names{"ID"});
    EXPECT_EQ(differs([](auto& i) { i.patientName = "ROE^JANE"; }), Names{"name"});
    EXPECT_EQ(differs([](auto& i) { i.birthDate = "19700103"; }), Names{"date of birth"});
    EXPECT_EQ(differs([](auto& i) { i.sex = "M"; }), Names{"sex"});
    EXPECT_EQ(differs([](auto& i) { i.patientId = "18", i.sex = "O"; }), (Names{"ID", "sex"}));
}

TEST(SecondStudy, IsPriorOrLaterByTheDateOfTheStudy) {
    const auto of = [](const char* date) { return janeBut([date](auto& i) { i.studyDate = date; }); };
    EXPECT_EQ(study::ageOf(jane(), of("20220301")), study::Age::earlier);
    EXPECT_EQ(study::ageOf(jane(), of("20240301")), study::Age::sameDay);
    EXPECT_EQ(study::ageOf(jane(), of("20240302")), study::Age::later);
    for (const char* date : {"", "2024", "20240x01", "yesterday"})
        EXPECT_EQ(study::ageOf(jane(), of(date)), study::Age::unknown) << date;
}

TEST(SecondStudy, ItsTagHoldsNoWordThatAPersonTyped) {
    EXPECT_EQ(plainTag(studyOf(jane())), "CT, 2024-03-01");
    EXPECT_EQ(plainTag(studyOf(janeBut([](auto& i) { i.studyDate = "for Miller"; }))), "CT, no study date");
    EXPECT_EQ(plainTag(studyOf({.series = Text("Phantom of Miller"), .isOfNobody = true})), "phantom");
    study::OpenedStudy found = studyOf(jane());
    found.found = study::test::twoPatients();
    found.volumeIndex = found.found->volumes().size() - 1;
    const int number = found.found->volumes().back().series->number.value();
    EXPECT_EQ(plainTag(found), "CT, 2024-03-01, series " + std::to_string(number));
    found.volumeIndex = 10'000;
    EXPECT_EQ(plainTag(found), "CT, 2024-03-01");
}

TEST(SecondStudy, IsLinkedByItsFrameOfReferenceOrByHand) {
    study::OpenedStudy study = studyOf(jane());
    study::OpenedStudy second = studyOf(jane(), {100.0, -20.0, 7.0});
    second.seriesDigest = "other";
    SecondVolumeState link = firstLink(study, second, "pair");
    EXPECT_EQ(link.link, SecondVolumeLink::byHand) << "nothing is known of where it lies";
    EXPECT_FALSE(link.isLinked());
    EXPECT_EQ(transformPoint(link.secondFromStudy, study.volume->worldBox().centre()),
              second.volume->worldBox().centre());
    EXPECT_EQ(link.seriesDigest, "other");
    study.frameOfReferenceUid = second.frameOfReferenceUid = "1.2.3";
    link = firstLink(study, second, "pair");
    EXPECT_EQ(link.link, SecondVolumeLink::sameFrame);
    EXPECT_EQ(link.secondFromStudy, glm::dmat4(1.0));
    second.identity.patientId = "18";
    EXPECT_EQ(firstLink(study, second, "pair").link, SecondVolumeLink::byHand) << "another patient";
    second.identity = jane();
    second.frameOfReferenceUid = "1.2.4";
    EXPECT_EQ(firstLink(study, second, "pair").link, SecondVolumeLink::byHand);
}

TEST(SecondStudy, IsFoundByItsDigestWhereThatIsOfOneVolume) {
    dicom::Series one = study::test::seriesOf(1, "a", {study::test::volumeOf(3)});
    one.seriesInstanceUid = "1.1";
    dicom::Series two = study::test::seriesOf(2, "b", {study::test::volumeOf(3), study::test::volumeOf(4)});
    two.seriesInstanceUid = "1.2";
    dicom::Scan scan;
    scan.studies.push_back(study::test::studyOf(0, "DOE^JANE", "20240301", "Chest", {one, two}));
    const study::FoundVolumes found(std::move(scan));
    SecondVolumeState state;
    state.seriesDigest = sha256Hex("1.1");
    EXPECT_EQ(volumeOf(found, state), 0U);
    state.seriesDigest = sha256Hex("1.2");
    EXPECT_FALSE(volumeOf(found, state)) << "which of two?";
    for (const std::size_t place : {0U, 1U}) {
        state.volume = place;
        EXPECT_EQ(volumeOf(found, state), place + 1);
    }
    state.volume = 2;
    EXPECT_FALSE(volumeOf(found, state));
    EXPECT_FALSE(volumeOf(found, {.seriesDigest = "phantom"}));
}

dicom::Stack phaseAt(const std::string& time, const std::string& frameOfReference = "1.9",
                     const glm::dvec3& row = {1, 0, 0}) {
    dicom::Stack stack = study::test::volumeOf(3);
    int slice = 0;
    for (dicom::Frame& frame : stack.frames) {
        frame.frameOfReferenceUid = frameOfReference;
        frame.plane = dicom::ImagePlane{.rowDirection = row};
        frame.attributes = {time, "7", std::to_string(++slice)};  // the last is of each image
    }
    return stack;
}

std::shared_ptr<const study::FoundVolumes> foundWith(std::vector<dicom::Stack> stacks) {
    dicom::Series other = study::test::seriesOf(1, "a", {study::test::volumeOf(3)});
    other.seriesInstanceUid = "1.1";
    dicom::Series series = study::test::seriesOf(2, "b", std::move(stacks));
    series.seriesInstanceUid = "1.2";
    dicom::Scan scan;
    scan.studies.push_back(study::test::studyOf(0, "DOE^JANE", "20240301", "Chest", {other, series}));
    return std::make_shared<const study::FoundVolumes>(std::move(scan));
}

// What was stored of the phase at 10:02 stays of that one, whatever else comes into the folder or goes.
TEST(SecondStudy, IsFoundWhereverItsSeriesHasItNow) {
    const auto stored = [](const std::shared_ptr<const study::FoundVolumes>& found, std::size_t index) {
        study::OpenedStudy second = studyOf(jane());
        second.seriesDigest = sha256Hex("1.2");
        second.found = found;
        second.volumeIndex = index;
        return firstLink(studyOf(jane()), second, "pair");
    };
    const SecondVolumeState ofTwo = stored(foundWith({phaseAt("1001"), phaseAt("1002")}), 2);
    EXPECT_EQ(ofTwo.volume, 1U);
    EXPECT_EQ(volumeOf(*foundWith({phaseAt("1001"), phaseAt("1002")}), ofTwo), 2U);
    EXPECT_EQ(volumeOf(*foundWith({phaseAt("1000"), phaseAt("1001"), phaseAt("1002")}), ofTwo), 3U);
    EXPECT_EQ(volumeOf(*foundWith({phaseAt("1002")}), ofTwo), 1U);
    EXPECT_FALSE(volumeOf(*foundWith({phaseAt("1000"), phaseAt("1001")}), ofTwo)) << "it has gone";
    // It was the only one.
    const SecondVolumeState ofOne = stored(foundWith({phaseAt("1002")}), 1);
    EXPECT_FALSE(ofOne.volume);
    EXPECT_EQ(volumeOf(*foundWith({phaseAt("1001"), phaseAt("1002")}), ofOne), 2U);
    EXPECT_FALSE(volumeOf(*foundWith({phaseAt("1001")}), ofOne)) << "another one has taken its place";
    // A slice more, which says another number of itself, is the same volume.
    dicom::Stack more = phaseAt("1002");
    more.frames.push_back(more.frames.front());
    EXPECT_EQ(volumeOf(*foundWith({phaseAt("1001"), more}), ofTwo), 2U);
    // Views of before have a place alone.
    SecondVolumeState old = ofTwo;
    old.volumeKey.clear();
    EXPECT_EQ(volumeOf(*foundWith({phaseAt("1001"), phaseAt("1002")}), old), 2U);
}

TEST(VolumeKey, IsOfFrameOrientationAndTime) {
    const auto key = [](const dicom::Stack& stack) { return foundWith({stack})->key(1); };
    const std::string usual = key(phaseAt("1001"));
    EXPECT_EQ(usual, key(phaseAt("1001")));
    EXPECT_EQ(usual, key(phaseAt("1001", "1.9", {1.0 - 1e-7, 1e-5, 0}))) << "other digits";
    EXPECT_NE(usual, key(phaseAt("1002")));
    EXPECT_NE(usual, key(phaseAt("1001", "1.8")));
    EXPECT_NE(usual, key(phaseAt("1001", "1.9", {0, 1, 0})));
    // Nothing tells these two apart but their order.
    const auto twins = foundWith({phaseAt("1001"), phaseAt("1001")});
    EXPECT_EQ(twins->key(1), usual);
    EXPECT_EQ(twins->key(2), usual + "-2");
    // Images that say nothing, and a stack without any.
    EXPECT_FALSE(key(study::test::volumeOf(3)).empty());
    dicom::Stack none = study::test::volumeOf(3);
    none.frames.clear();
    EXPECT_FALSE(key(none).empty());
}

TEST(SecondStudy, APairIsOfVoxelsAndPositionsOfBoth) {
    const auto of = [](const glm::dvec3& firstMm) { return fingerprint(*studyOf(jane(), firstMm).volume); };
    const std::string usual = pairDigest(of(glm::dvec3(0.0)), of({100.0, 0.0, 0.0}));
    EXPECT_EQ(usual, pairDigest(of(glm::dvec3(0.0)), of({100.0, 0.0, 0.0})));
    EXPECT_NE(usual, pairDigest(of(glm::dvec3(0.0)), of({100.0, 0.0, 0.5})));
    EXPECT_NE(usual, pairDigest(of({0.0, 0.0, 0.5}), of({100.0, 0.0, 0.0})));
    EXPECT_NE(usual, pairDigest(of({100.0, 0.0, 0.0}), of(glm::dvec3(0.0))));
}

TEST(SecondStudy, ALookIsKeptWhereThePlaceIsNot) {
    SecondVolumeState before;
    before.link = SecondVolumeLink::registered;
    before.secondFromStudy[3].x = 3.0;
    before.boundMm = 0.4;
    before.view = SecondVolumePlace::over;
    before.opacity = 0.25;
    SecondVolumeState place;
    place.pair = "pair";
    const SecondVolumeState byHand = withLookOf(place, before);
    EXPECT_EQ(byHand.opacity, 0.25);
    EXPECT_EQ(byHand.view, SecondVolumePlace::beside) << "nothing lies over it by hand";
    EXPECT_EQ(byHand.secondFromStudy, glm::dmat4(1.0));
    EXPECT_EQ(byHand.boundMm, 0.0);
    EXPECT_EQ(byHand.pair, "pair");
    place.link = SecondVolumeLink::sameFrame;
    EXPECT_EQ(withLookOf(place, before).view, SecondVolumePlace::over);
}

// Two phases of a heart are one series, and are told apart.
TEST(SecondStudy, VolumesOfOneSeriesAreToldApart) {
    dicom::Series series =
        study::test::seriesOf(2, "b", {study::test::volumeOf(3), study::test::volumeOf(4)});
    series.seriesInstanceUid = "1.2";
    dicom::Scan scan;
    scan.studies.push_back(study::test::studyOf(0, "DOE^JANE", "20240301", "Chest", {series}));
    study::OpenedStudy first = studyOf(jane());
    first.seriesDigest = sha256Hex("1.2");
    first.found = std::make_shared<const study::FoundVolumes>(std::move(scan));
    study::OpenedStudy second = first;
    second.volumeIndex = 1;
    EXPECT_EQ(plainTag(first), "CT, 2024-03-01, series 2, volume 1 of 2");
    EXPECT_EQ(plainTag(second), "CT, 2024-03-01, series 2, volume 2 of 2");
    SecondVolumeState link = firstLink(first, second, "pair");
    EXPECT_EQ(link.volume, 1U);
    EXPECT_TRUE(isPlacedFor(link, second, "pair"));
    EXPECT_FALSE(isPlacedFor(link, second, "other")) << "of these UIDs, and of other voxels or positions";
    EXPECT_FALSE(isPlacedFor(link, second, {}));
    EXPECT_FALSE(isPlacedFor(link, first, "pair")) << "the registration is of the other";
    EXPECT_FALSE(link.volumeKey.empty());
    link.volumeKey.clear();  // of a view of before
    EXPECT_TRUE(isPlacedFor(link, second, "pair"));
    EXPECT_FALSE(isPlacedFor(link, first, "pair"));
    link.volume.reset();  // of one still older
    EXPECT_FALSE(isPlacedFor(link, second, "pair"));
    EXPECT_TRUE(isPlacedFor(firstLink(first, studyOf(jane()), "pair"), studyOf(jane()), "pair"));
    EXPECT_FALSE(firstLink(first, studyOf(jane()), "pair").volume);
}

}  // namespace
}  // namespace macula::scene
