#include "study/list/study_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/english.h"
#include "dicom/manifest/imaging_manifest.h"
#include "dicom/read/sop_class.h"
#include "dicom/write/uid.h"
#include "study/found_by_hand.h"
#include "study/open/presented_volume.h"

namespace macula::study {
namespace {

using Kind = StudyRow::Kind;

std::size_t rowTitled(const StudyTree& tree, std::string_view title) {
    const auto found = std::find_if(tree.rows.begin(), tree.rows.end(),
                                    [&](const StudyRow& row) { return row.title == title; });
    if (found == tree.rows.end()) {
        ADD_FAILURE() << "there is no row " << title;
        return 0;
    }
    return static_cast<std::size_t>(found - tree.rows.begin());
}

std::vector<std::string> titlesOf(const StudyTree& tree, const std::vector<std::size_t>& rows) {
    std::vector<std::string> titles;
    for (const std::size_t row : rows) titles.push_back(tree.rows[row].title.english());
    return titles;
}

std::vector<std::string> shownFor(const StudyTree& tree, std::string_view typed) {
    const std::vector<bool> shown = rowsThatMatch(tree, typed);
    std::vector<std::string> titles;
    for (std::size_t row = 0; row < shown.size(); ++row) {
        if (shown[row]) titles.push_back(tree.rows[row].title.english());
    }
    return titles;
}

using Texts = std::vector<std::string>;

TEST(StudyTree, PatientsHaveTheirStudiesTheNewestFirst) {
    const auto found = test::twoPatients();
    const StudyTree tree = studyTree(*found);
    EXPECT_EQ(titlesOf(tree, tree.top), (Texts{"Müller, Jörg", "DOE, JANE", "4 files left out"}));
    const StudyRow& patient = tree.rows[tree.top[0]];
    EXPECT_EQ(inEnglish(patient.details), Texts{"ID ID0, born 1970-01-02, F"});
    EXPECT_EQ(titlesOf(tree, patient.children), (Texts{"2020-03-04, Head", "2019-02-03, Abdomen of Jörg"}));
    const StudyRow& older = tree.rows[patient.children[1]];
    EXPECT_EQ(inEnglish(older.details), Texts{"CT · 2 series"});
    EXPECT_EQ(titlesOf(tree, older.children), (Texts{"Series 1: Scout", "Series 2: Portal venous"}));
}

TEST(StudyTree, ParentsComeBeforeTheirChildrenAndNameThem) {
    const auto found = test::twoPatients();
    const StudyTree tree = studyTree(*found);
    std::size_t below = 0;
    for (std::size_t row = 0; row < tree.rows.size(); ++row) {
        for (const std::size_t child : tree.rows[row].children) {
            EXPECT_GT(child, row);
            EXPECT_EQ(tree.rows[child].parent, row);
            ++below;
        }
    }
    EXPECT_EQ(below + tree.top.size(), tree.rows.size()) << "each row is in one place";
}

TEST(StudyTree, EachVolumeIsOpenedByARow) {
    const auto found = test::twoPatients();
    const StudyTree tree = studyTree(*found);
    std::set<std::size_t> opened;
    for (const StudyRow& row : tree.rows) {
        if (!row.volume) continue;
        opened.insert(*row.volume);
        const FoundVolume& volume = found->volumes().at(*row.volume);
        EXPECT_EQ(row.picture, volume.stack);
        EXPECT_TRUE(row.whyNot.empty());
        if (row.kind == Kind::series) {
            EXPECT_EQ(row.title,
                      "Series " + std::to_string(*volume.series->number) + ": " + volume.series->description);
        }
    }
    EXPECT_EQ(opened, (std::set<std::size_t>{0, 1, 2, 3}));
}

TEST(StudyTree, ASeriesTellsImagesSizeAndVoxels) {
    const auto found = test::twoPatients();
    const StudyTree tree = studyTree(*found);
    EXPECT_EQ(inEnglish(tree.rows[rowTitled(tree, "Series 2: Portal venous")].details),
              (Texts{"CT · 100 images", "512 × 256 × 100", "0.7 × 0.5 × 1.25 mm"}));
    EXPECT_EQ(inEnglish(tree.rows[rowTitled(tree, "Series 1: Scout")].details),
              (Texts{"CT · 1 image", "512 × 256", "Shown as images, not in 3D"}));
}

TEST(StudyTree, VoxelsThatAreNotCalibratedAreToldSo) {
    dicom::Stack stack = test::volumeOf(20);
    stack.isCalibrated = false;
    dicom::Scan scan;
    scan.studies.push_back(
        test::studyOf(0, "DOE^JANE", "20200102", "Chest",
                      {test::seriesOf(1, "One", {stack}), test::seriesOf(2, "Two", {stack, stack})}));
    scan.patients = 1;
    const FoundVolumes found(std::move(scan));
    const StudyTree tree = studyTree(found);
    EXPECT_EQ(inEnglish(tree.rows[rowTitled(tree, "Series 1: One")].details),
              (Texts{"CT · 20 images", "512 × 256 × 20", "0.7 × 0.5 × 1.25 mm · not calibrated"}));
    const StudyRow& several = tree.rows[rowTitled(tree, "Series 2: Two")];
    ASSERT_EQ(several.children.size(), 2u);
    EXPECT_EQ(tree.rows[several.children[0]].details.at(1), "0.7 × 0.5 × 1.25 mm · not calibrated");
}

TEST(StudyTree, SeveralVolumesOfASeriesAreRowsOfTheirOwn) {
    const auto found = test::twoPatients();
    const StudyTree tree = studyTree(*found);
    const StudyRow& series = tree.rows[rowTitled(tree, "Series 3: T2 two echoes")];
    EXPECT_FALSE(series.volume) << "which of them?";
    EXPECT_EQ(inEnglish(series.details), Texts{"MR · 60 images · 2 volumes"});
    EXPECT_EQ(titlesOf(tree, series.children), (Texts{"TE 4.6 ms", "TE 9.2 ms, phase 2 of 2"}));
    EXPECT_EQ(tree.rows[series.children[0]].volume, 1u);
    EXPECT_EQ(tree.rows[series.children[1]].volume, 2u);
    // With one volume among other images it is clear which is meant.
    const StudyRow& mixed = tree.rows[rowTitled(tree, "Series 4: Lung <b>sharp</b>")];
    EXPECT_EQ(mixed.volume, 3u);
    ASSERT_EQ(mixed.children.size(), 2u);
    EXPECT_EQ(tree.rows[mixed.children[0]].volume, 3u);
    EXPECT_FALSE(tree.rows[mixed.children[1]].volume);
    const StudyRow& single = tree.rows[mixed.children[1]];
    EXPECT_EQ(single.images, single.picture);
    EXPECT_TRUE(single.whyNot.empty());
    ASSERT_EQ(single.messages.size(), 1u);
    EXPECT_TRUE(single.messages[0].english().starts_with(
        dicom::message(dicom::key::kSingleSlice).sentence.english()));
    EXPECT_EQ(tree.rows[mixed.children[0]].messages.size(), 1u) << "of a source with losses";
}

TEST(StudyTree, WhatCannotBeOpenedSaysWhy) {
    const auto found = test::twoPatients();
    const StudyTree tree = studyTree(*found);
    const auto why = [&](std::string_view title) { return tree.rows[rowTitled(tree, title)].whyNot; };
    EXPECT_EQ(why("Series 1: Scout"), "") << "it is shown as an image";
    EXPECT_NE(tree.rows[rowTitled(tree, "Series 1: Scout")].images, nullptr);
    EXPECT_EQ(why("Series 9: Report of Jane"),
              "This is no image, and is not shown in 3D: Structured report.");
    EXPECT_EQ(why("Series 10: Broken"), "No file of this series can be read; it has 4.");
    EXPECT_EQ(tree.rows[rowTitled(tree, "Series 9: Report of Jane")].picture, nullptr);
    EXPECT_EQ(inEnglish(tree.rows[rowTitled(tree, "Series 9: Report of Jane")].details),
              Texts{"SR · no images · 1 object"});
    for (const StudyRow& row : tree.rows) {
        if (row.kind != Kind::stack) continue;
        EXPECT_EQ(row.images == nullptr, row.volume.has_value()) << row.title;
        EXPECT_TRUE(row.whyNot.empty()) << row.title;
    }
}

TEST(StudyTree, FilesLeftOutAreGroupedByTheirReason) {
    const auto found = test::twoPatients();
    const StudyTree tree = studyTree(*found);
    const StudyRow& leftOut = tree.rows[tree.top.back()];
    EXPECT_EQ(leftOut.kind, Kind::leftOut);
    EXPECT_EQ(titlesOf(tree, leftOut.children),
              (Texts{"3 × " + dicom::message(dicom::key::kDamagedFile).sentence.english(),
                     dicom::message(dicom::key::kUnreadableFile).sentence.english()}));
    for (const StudyRow& row : tree.rows) {
        if (row.kind != Kind::leftOut) continue;
        for (const Text& text : row.messages) EXPECT_EQ(text.english().find("/doe"), std::string::npos);
    }
}

TEST(StudyTree, FoldersThatCannotBeReadAreCountedTogether) {
    dicom::Scan scan;
    for (int n = 0; n < 2; ++n)
        scan.skipped.push_back(
            {"/doe", dicom::message(dicom::key::kUnreadableFolder, {{"count", std::int64_t{1}}}), "", true});
    const FoundVolumes found(std::move(scan));
    const StudyTree tree = studyTree(found);
    ASSERT_EQ(tree.rows.size(), 1u);
    EXPECT_EQ(tree.rows[0].title,
              dicom::message(dicom::key::kUnreadableFolder, {{"count", std::int64_t{2}}}).sentence);
}

TEST(StudyTree, ImagesOfOneSeriesEachAreOneRowThatAsks) {
    dicom::Scan scan;
    for (int n = 0; n < 5; ++n) {
        dicom::Series series = test::seriesOf(1, "Slice", {test::refused(dicom::key::kSingleSlice)});
        series.scattered = true;
        scan.studies.push_back(test::studyOf(0, "DOE^JANE", "20200102", "Thorax", {series}));
    }
    scan.messages.push_back(dicom::message(
        dicom::key::kUidPerSlice, {{"count", std::int64_t{5}}, {"level", std::string("study and series")}}));
    const FoundVolumes found(std::move(scan));
    const StudyTree tree = studyTree(found);
    ASSERT_EQ(tree.rows.size(), 1u);
    EXPECT_EQ(tree.rows[0].title, found.scan().messages[0].sentence);
}

TEST(StudyTree, AManifestSaysWhereItsImagesAre) {
    dicom::Scan scan;
    dicom::Series manifest = test::seriesOf(1, "", {}, "KO");
    manifest.objects.push_back({.kind = dicom::imagingManifestKind()});
    scan.studies.push_back(test::studyOf(0, "DOE^JANE", "20210405", "Chest", {manifest}));
    manifest.objects.push_back({.kind = Text("Structured report")});
    manifest.number = 2;
    scan.studies.back().series.push_back(manifest);
    const FoundVolumes found(std::move(scan));
    const StudyTree tree = studyTree(found);
    EXPECT_NE(tree.rows[rowTitled(tree, "Series 1")].whyNot.english().find("Open its file"),
              std::string::npos);
    EXPECT_EQ(tree.rows[rowTitled(tree, "Series 2")].whyNot.english().find("Open its file"),
              std::string::npos);
}

TEST(StudyTree, AnEmptyScanHasNoRows) {
    const FoundVolumes found{dicom::Scan{}};
    EXPECT_TRUE(studyTree(found).rows.empty());
    EXPECT_TRUE(rowsThatMatch(studyTree(found), "ct").empty());
}

TEST(StudyTree, WithoutNamesNobodyIsNamed) {
    const auto found = test::twoPatients();
    const StudyTree shown = studyTree(*found);
    const StudyTree tree = studyTree(*found, Names::hidden);
    ASSERT_EQ(tree.rows.size(), shown.rows.size()) << "rows keep their places";
    EXPECT_EQ(titlesOf(tree, tree.top), (Texts{"Patient 1", "Patient 2", "4 files left out"}));
    for (std::size_t n = 0; n < tree.rows.size(); ++n) {
        const StudyRow& row = tree.rows[n];
        EXPECT_EQ(row.volume, shown.rows[n].volume);
        EXPECT_EQ(row.whyNot, shown.rows[n].whyNot);
        std::string all = row.title.english() + row.searched + row.whyNot.english();
        for (const Text& text : row.details) all += text.english();
        for (const Text& text : row.messages) all += text.english();
        for (const char* name : {"Müller",  "muller", "Jörg", "jorg", "DOE",   "doe",    "Jane",
                                 "JANE",    "jane",   "ID0",  "id0",  "id1",   "1970",   "Abdomen",
                                 "abdomen", "Head",   "head", "Lung", "Scout", "Portal", "EchoTime"})
            EXPECT_EQ(all.find(name), std::string::npos) << all;
    }
    const StudyRow& patient = tree.rows[tree.top[0]];
    EXPECT_EQ(titlesOf(tree, patient.children), (Texts{"2020-03-04", "2019-02-03"})) << "dates stay";
    EXPECT_EQ(shownFor(tree, "muller"), Texts{});
    EXPECT_EQ(shownFor(tree, "2020-03-04 mr"),
              (Texts{"Patient 1", "2020-03-04", "Series 3", "Stack 1", "Stack 2, phase 2 of 2"}));
}

TEST(StudyTree, ADateThatIsNoneMayNameSomebody) {
    dicom::Scan scan;
    scan.studies.push_back(test::studyOf(0, "DOE^JANE", "Jane", "", {test::seriesOf(1, "", {})}));
    scan.studies.push_back(test::studyOf(0, "DOE^JANE", "2020.03.04", "", {test::seriesOf(1, "", {})}));
    const FoundVolumes found(std::move(scan));
    const StudyTree tree = studyTree(found, Names::hidden);
    EXPECT_EQ(titlesOf(tree, tree.rows[tree.top[0]].children), (Texts{"2020.03.04", "no study date"}));
}

TEST(StudyTree, SearchKeepsWhatIsAboveAndBelow) {
    const auto found = test::twoPatients();
    const StudyTree tree = studyTree(*found);
    EXPECT_EQ(shownFor(tree, "portal"),
              (Texts{"Müller, Jörg", "2019-02-03, Abdomen of Jörg", "Series 2: Portal venous"}));
    EXPECT_EQ(shownFor(tree, "jane lung").size(), 5u) << "patient, study, series, and its two stacks";
    EXPECT_EQ(shownFor(tree, "MULLER jorg").size(), 8u) << "all of him";
    EXPECT_EQ(shownFor(tree, "9.2"), (Texts{"Müller, Jörg", "2020-03-04, Head", "Series 3: T2 two echoes",
                                            "TE 9.2 ms, phase 2 of 2"}));
}

TEST(StudyTree, SearchIsByNameIdDateModalityAndDescription) {
    const auto found = test::twoPatients();
    const StudyTree tree = studyTree(*found);
    for (const char* typed : {"müller", "id0", "1970-01-02 id0", "19700102 id0", "20200304", "2020-03-04",
                              "mr", "head", "echoes", "Müller^Jörg", "mr head muller 2020"}) {
        const Texts shown = shownFor(tree, typed);
        EXPECT_NE(std::find(shown.begin(), shown.end(), "Series 3: T2 two echoes"), shown.end()) << typed;
        EXPECT_EQ(std::find(shown.begin(), shown.end(), "DOE, JANE"), shown.end()) << typed;
    }
    const Texts sr = shownFor(tree, "sr");
    EXPECT_EQ(sr, (Texts{"DOE, JANE", "2021-04-05, Thorax", "Series 9: Report of Jane"}))
        << "the modality of one series does not stand for its study";
    EXPECT_EQ(shownFor(tree, "muller lung"), Texts{}) << "all words, of one row and those above it";
    EXPECT_EQ(shownFor(tree, "").size(), tree.rows.size());
    EXPECT_EQ(shownFor(tree, " , ").size(), tree.rows.size());
}

TEST(StudyTree, ManySeriesAreAllThere) {
    const auto found = test::manySeries(2000);
    const StudyTree tree = studyTree(*found);
    EXPECT_EQ(tree.rows.size(), 2002u);
    EXPECT_EQ(shownFor(tree, "thorax 1999").size(), 4u)
        << "patient, study, and by number and by name a series";
}

TEST(StudyTree, OfAGlimpseNothingCanBeOpenedAndNothingIsRefused) {
    dicom::Scan scan;
    dicom::Series series = test::seriesOf(2, "Thorax", {});
    series.instances = 17;
    scan.studies.push_back(test::studyOf(0, "DOE^JANE", "20200102", "Chest", {std::move(series)}));
    scan.patients = 1;
    const FoundVolumes found(std::move(scan), FoundVolumes::Extent::soFar);
    EXPECT_TRUE(found.volumes().empty());
    const StudyTree tree = studyTree(found);
    const StudyRow& row = tree.rows[rowTitled(tree, "Series 2: Thorax")];
    EXPECT_EQ(inEnglish(row.details), Texts{"CT · 17 images so far"});
    EXPECT_EQ(row.whyNot, "");
    EXPECT_EQ(row.picture, nullptr);
    EXPECT_FALSE(row.volume);
}

dicom::OtherObject presentationOf(const std::string& label, const std::string& date,
                                  std::vector<std::string> series, std::string_view sopClass) {
    dicom::OtherObject object{.file = "/doe/" + label,
                              .sopClassUid = std::string(sopClass),
                              .kind = Text("Presentation state"),
                              .referencedSeriesUids = std::move(series),
                              .label = label};
    object.presentation = dicom::PresentationHeading{
        label, "Of Jane, " + label, date, "101112", "READER^NIGHT", {{.sopInstanceUid = "1.1"}}};
    return object;
}

// One series of images, "1.2"; another one of a second patient, "1.3"; and presentation states of both.
std::shared_ptr<const FoundVolumes> withPresentations(std::vector<dicom::OtherObject> objects) {
    dicom::Scan scan;
    dicom::Series images = test::seriesOf(2, "Thorax", {test::volumeOf(4)});
    images.seriesInstanceUid = "1.2";
    dicom::Series others = test::seriesOf(3, "Knee", {test::volumeOf(4)});
    others.seriesInstanceUid = "1.3";
    dicom::Series states = test::seriesOf(9, "Views", {}, "PR");
    states.objects = std::move(objects);
    scan.studies.push_back(
        test::studyOf(0, "DOE^JANE", "20210405", "Chest", {std::move(images), std::move(states)}));
    scan.studies.push_back(test::studyOf(1, "ROE^RICHARD", "20200405", "Leg", {std::move(others)}));
    scan.patients = 2;
    return std::make_shared<const FoundVolumes>(std::move(scan));
}

namespace sop = dicom::sop_class;

TEST(PresentationRows, StandBelowTheirSeriesTheNewestFirst) {
    const auto found =
        withPresentations({presentationOf("OLD", "20200101", {"1.2"}, sop::kVolumePresentationState),
                           presentationOf("NEW", "20240229", {"1.2"}, sop::kSoftcopyPresentationState)});
    const StudyTree tree = studyTree(*found);
    const StudyRow& series = tree.rows[rowTitled(tree, "Series 9: Views")];
    EXPECT_TRUE(series.whyNot.empty()) << "what is in it can be opened";
    EXPECT_EQ(titlesOf(tree, series.children), (Texts{"View of slices: NEW", "3D view: OLD"}));
    const StudyRow& newest = tree.rows[series.children[0]];
    EXPECT_EQ(newest.kind, Kind::presentation);
    EXPECT_EQ(inEnglish(newest.details), Texts{"Of Jane, NEW \u00b7 2024-02-29 \u00b7 READER, NIGHT"});
    EXPECT_EQ(newest.details.at(0).format(), "{} \u00b7 {} \u00b7 {}") << "nothing to be translated";
    ASSERT_TRUE(newest.presentation);
    EXPECT_TRUE(newest.presentation->isOfSlices);
    EXPECT_EQ(newest.presentation->file, "/doe/NEW");
    EXPECT_EQ(found->volumes().at(newest.presentation->volume).series->seriesInstanceUid, "1.2");
    EXPECT_FALSE(newest.volume) << "it is no volume, and is never what is open";
    const StudyRow& older = tree.rows[series.children[1]];
    ASSERT_TRUE(older.presentation);
    EXPECT_FALSE(older.presentation->isOfSlices);
    EXPECT_EQ(shownFor(tree, "jane old").back(), "3D view: OLD");
}

TEST(PresentationRows, SayWhyTheyCannotBeShown) {
    const auto found = withPresentations({presentationOf("A", "4", {"1.3"}, sop::kVolumePresentationState),
                                          presentationOf("B", "3", {"7.7"}, sop::kVolumePresentationState),
                                          presentationOf("C", "2", {}, sop::kSoftcopyPresentationState),
                                          presentationOf("D", "1", {"1.2"}, "1.2.840.10008.5.1.4.1.1.11.2")});
    const StudyTree tree = studyTree(*found);
    const StudyRow& series = tree.rows[rowTitled(tree, "Series 9: Views")];
    ASSERT_EQ(series.children.size(), 4u);
    const auto whyNot = [&](std::size_t child) { return tree.rows[series.children[child]].whyNot; };
    EXPECT_NE(whyNot(0).english().find("another patient"), std::string::npos) << whyNot(0);
    EXPECT_NE(whyNot(1).english().find("not in this folder"), std::string::npos) << whyNot(1);
    EXPECT_NE(whyNot(2).english().find("not in this folder"), std::string::npos) << whyNot(2);
    EXPECT_NE(whyNot(3).english().find("of this kind"), std::string::npos) << whyNot(3);
    for (const std::size_t child : series.children) EXPECT_FALSE(tree.rows[child].presentation);
}

// Two phases in one file: those whose frames it names are meant.
TEST(PresentationRows, OfFramesOfOneFileTheVolumeIsMeantThatHasThem) {
    dicom::Stack early = test::volumeOf(4);
    dicom::Stack late = test::volumeOf(4);
    auto file = std::make_shared<dicom::Instance>(*early.frames.front().instance);
    file->sopInstanceUid = "1.1";
    for (int n = 0; n < 4; ++n) {
        early.frames[std::size_t(n)].number = n;
        late.frames[std::size_t(n)].number = 4 + n;
        early.frames[std::size_t(n)].instance = late.frames[std::size_t(n)].instance = file;
    }
    dicom::Series images = test::seriesOf(2, "Thorax", {early, late});
    images.seriesInstanceUid = "1.2";
    dicom::Scan scan;
    scan.studies.push_back(test::studyOf(0, "DOE^JANE", "20210405", "Chest", {std::move(images)}));
    scan.patients = 1;
    const FoundVolumes found(std::move(scan));
    dicom::OtherObject object = presentationOf("NEW", "20240229", {"1.2"}, sop::kSoftcopyPresentationState);
    EXPECT_EQ(presentedVolume(object, 0, found).index, 0u);
    object.presentation->images.front().numbers = {6, 7};
    EXPECT_EQ(presentedVolume(object, 0, found).index, 1u);
}

// Of nobody: the UIDs are made anew, and say of which series it is to who has that.
TEST(PresentationRows, WithoutAPatientAreOfTheOneSeriesThatTheirUidsWereMadeOf) {
    dicom::Scan scan;
    dicom::Series images = test::seriesOf(2, "Thorax", {test::volumeOf(4)});
    images.seriesInstanceUid = "1.2";
    dicom::Series states = test::seriesOf(9, "Views", {}, "PR");
    states.objects.push_back(
        presentationOf("ANON", "20240229", {dicom::uidFrom("1.2")}, sop::kVolumePresentationState));
    scan.studies.push_back(test::studyOf(0, "DOE^JANE", "20210405", "Chest", {std::move(images)}));
    scan.studies.push_back(test::studyOf(1, "ANONYMOUS", "20210405", "", {std::move(states)}));
    scan.patients = 2;
    const FoundVolumes found(std::move(scan));
    const StudyTree tree = studyTree(found);
    const StudyRow& row = tree.rows[rowTitled(tree, "3D view: ANON")];
    ASSERT_TRUE(row.presentation);
    EXPECT_EQ(row.presentation->volume, 0u);
}

TEST(PresentationRows, WithoutNamesNothingOfTheFileIsLeftButTheDate) {
    const auto found =
        withPresentations({presentationOf("JANE", "20240229", {"1.2"}, sop::kVolumePresentationState),
                           presentationOf("JANE", "by JANE", {"1.2"}, sop::kVolumePresentationState)});
    const StudyTree tree = studyTree(*found, Names::hidden);
    std::size_t seen = 0;
    for (const StudyRow& row : tree.rows) {
        if (row.kind != Kind::presentation) continue;
        ++seen;
        EXPECT_EQ(row.title, "3D view");
        EXPECT_TRUE(row.details.empty() || inEnglish(row.details) == Texts{"2024-02-29"});
        EXPECT_EQ(row.searched.find("jane"), std::string::npos);
    }
    EXPECT_EQ(seen, 2u);
}

dicom::OtherObject documentOf(const std::string& file, const std::string& title) {
    dicom::OtherObject object{.file = file,
                              .sopClassUid = "1.2.840.10008.5.1.4.1.1.88.11",
                              .kind = Text("Structured report"),
                              .referencedSeriesUids = {}};
    object.label = title;
    return object;
}

TEST(DocumentRows, ASeriesOfOneDocumentOpensItAndOneOfSeveralHasARowForEach) {
    dicom::Scan scan;
    dicom::Series one = test::seriesOf(8, "Report", {}, "SR");
    one.objects = {documentOf("/doe/a", "Chest of Jane")};
    dicom::Series several = test::seriesOf(9, "Reports", {}, "SR");
    several.objects = {documentOf("/doe/b", "First"), documentOf("/doe/c", "")};
    scan.studies.push_back(test::studyOf(3, "DOE^JANE", "20210405", "Thorax", {one, several}));
    scan.patients = 4;
    const FoundVolumes found(std::move(scan));
    const StudyTree tree = studyTree(found);
    const StudyRow& only = tree.rows[rowTitled(tree, "Series 8: Report")];
    ASSERT_TRUE(only.document);
    EXPECT_EQ(only.document->file, "/doe/a");
    EXPECT_EQ(only.document->patient, 3);
    EXPECT_TRUE(only.children.empty());
    EXPECT_TRUE(only.whyNot.empty());
    EXPECT_EQ(only.details.back().english(), "Structured report: Chest of Jane");
    const StudyRow& both = tree.rows[rowTitled(tree, "Series 9: Reports")];
    EXPECT_FALSE(both.document);
    EXPECT_TRUE(both.whyNot.empty());
    EXPECT_EQ(titlesOf(tree, both.children), (Texts{"Structured report: First", "Structured report"}));
    EXPECT_EQ(tree.rows[both.children[1]].document->file, "/doe/c");
    const StudyTree hidden = studyTree(found, Names::hidden);
    for (const StudyRow& row : hidden.rows)
        for (const Text& detail : row.details)
            EXPECT_EQ(detail.english().find("Jane"), std::string::npos) << detail.english();
}

}  // namespace
}  // namespace macula::study
