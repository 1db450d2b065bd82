// Presentation states of folders: written, found again, and opened for the volumes that they are of.
#include <gtest/gtest.h>

#include "pictures/state_request.h"
#include "pipeline/volume/window.h"
#include "presentation_fixture.h"
#include "scene/presentation/presentation_file.h"
#include "study/open/found_volumes.h"
#include "study/open/loaded_study.h"
#include "support.h"
#include "synthetic.h"
#include "synthetic_pet.h"

namespace macula::scene {
namespace {

// From a folder to a file and back, as the programs do it.
TEST_F(APresentation, IsWrittenOfAFolderAndOpenedForIt) {
    dicom::test::write(*oblique_, folder_ / "study");
    const auto scan = dicom::test::scan(folder_ / "study");
    ASSERT_TRUE(scan);
    const dicom::Series& series = scan->studies.at(0).series.at(0);
    const dicom::Stack& stack = series.stacks.at(0);
    const std::string digest = sha256Hex(series.seriesInstanceUid);
    PresentationRequest request;
    request.state = state_;
    request.volume = dicom::test::load(series, stack);
    auto images = presentedImages(series, stack);
    ASSERT_TRUE(images.ok()) << images.error().message;
    EXPECT_EQ(images->series.images.size(), stack.frames.size());
    request.images = *images;
    const std::filesystem::path path = folder_ / "presentation.dcm";
    for (const bool isDeidentified : {false, true}) {
        request.isDeidentified = isDeidentified;
        const auto written = writePresentation(path, request);
        ASSERT_TRUE(written.ok()) << written.error().message;
        const auto opened = openPresentation(path, *request.volume, digest, study::imagesOf(stack));
        ASSERT_TRUE(opened.ok()) << opened.error().message;
        EXPECT_TRUE(opened->isOwn);
        StudyState expected = state_;
        expected.seriesDigest = digest;
        EXPECT_EQ(opened->state, expected) << "the preset is a built-in one, and keeps its name";
        EXPECT_TRUE(opened->notes.empty());
        // Of another phase of the series, and of a part of the images.
        const auto otherPhase = openPresentation(
            path, *request.volume, digest,
            std::vector<dicom::ReferencedFrames>{{.sopInstanceUid = "2.25.1"}, {.sopInstanceUid = "2.25.2"}});
        ASSERT_FALSE(otherPhase.ok());
        EXPECT_EQ(otherPhase.error().code, ErrorCode::inputNotUsable);
        auto some = study::imagesOf(stack);
        ASSERT_GT(some.size(), 1u);
        some.pop_back();
        const auto part = openPresentation(path, *request.volume, digest, some);
        ASSERT_TRUE(part.ok());
        EXPECT_EQ(part->notes.size(), 1u);
        EXPECT_FALSE(openPresentation(path, *request.volume, sha256Hex("another"), {}).ok());
    }
    EXPECT_FALSE(openPresentation(folder_ / "gone.dcm", *request.volume, digest, {}).ok());
    dicom::Stack unnamed = stack;
    for (dicom::Frame& frame : unnamed.frames) frame.frameOfReferenceUid.clear();
    EXPECT_EQ(presentedImages(series, unnamed).error().code, ErrorCode::usage);
    EXPECT_FALSE(presentedImages(series, dicom::Stack{}).ok());
}

// Two phases in one file: a view of one is not taken for one of the other.
// What is shown in SUV is written as the Bq/mL that the images have; of others such values are refused,
// because nobody has said what they are in SUV.
TEST_F(APresentation, OfPetHasTheValuesOfTheImages) {
    const dicom::test::TemporaryFolder folder;
    writeFiles(folder.path(), dicom::test::petSeries());
    const auto scan = dicom::test::scan(folder.path());
    ASSERT_TRUE(scan);
    const dicom::Series& series = scan->studies.at(0).series.at(0);
    Progress progress;
    const auto pet = study::loadStudy(*scan, folder.path(), {}, progress);
    ASSERT_TRUE(pet.ok());
    ASSERT_EQ(pet->volume->unit(), Unit::suvBodyWeight);
    PresentationRequest request;
    request.state = state_;
    request.state.preset = preset("cinematic-pet");
    request.state.settings.look = trace::Look::mip;
    request.state.windows.at(std::size_t(trace::Look::mip)) = windowOver({0.0, 8.0});
    request.state.camera = frameBox(pet->volume->worldBox(), ViewDirection::anterior, 25.0, 1.5);
    request.volume = pet->volume;
    request.images = *presentedImages(series, series.stacks.at(0));
    const std::filesystem::path path = folder / "state.dcm";
    ASSERT_TRUE(writePresentation(path, request).ok());
    const auto read = dicom::readPresentationState(path);
    ASSERT_TRUE(read.ok());
    const double becquerels = 8.0 / dicom::test::kSuvPerBqPerMl;
    EXPECT_NEAR(read->presentation.palette.values.high, becquerels, 1e-3 * becquerels);
    auto foreign = *read;
    foreign.presentation.ownState.clear();
    auto presented = stateOf(foreign, StudyState{}, "a.dcm");
    ASSERT_TRUE(presented.ok());
    const auto done = completeFor(*presented, foreign, *pet->volume, pet->seriesDigest, {}, "a.dcm");
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, ErrorCode::inputNotUsable);
}

TEST_F(APresentation, OfSomeFramesOfAFileNamesThem) {
    const dicom::test::SyntheticSeries described;
    dicom::test::writeMultiFrame(folder_ / "study" / "all.dcm", described, dicom::test::slicesOf(described));
    const auto scan = dicom::test::scan(folder_ / "study");
    ASSERT_TRUE(scan);
    const dicom::Series& series = scan->studies.at(0).series.at(0);
    const dicom::Stack& whole = series.stacks.at(0);
    const std::size_t half = whole.frames.size() / 2;
    ASSERT_GT(half, 1u);
    dicom::Stack first = whole;
    first.frames.clear();
    dicom::Stack second = first;
    for (const dicom::Frame& frame : whole.frames)
        (std::size_t(frame.number) < half ? first : second).frames.push_back(frame);
    const auto ofAll = presentedImages(series, whole);
    ASSERT_TRUE(ofAll.ok()) << ofAll.error().message;
    ASSERT_EQ(ofAll->series.images.size(), 1u);
    EXPECT_TRUE(ofAll->series.images[0].frames.empty());
    PresentationRequest request;
    request.state = state_;
    request.volume = dicom::test::load(series, whole);
    request.images = *presentedImages(series, second);
    ASSERT_EQ(request.images.series.images.size(), 1u);
    EXPECT_EQ(request.images.series.images[0].frames.front(), int(half) + 1) << "from 1";
    EXPECT_EQ(request.images.series.images[0].frames.size(), second.frames.size());
    const std::filesystem::path path = folder_ / "presentation.dcm";
    const std::string digest = sha256Hex(series.seriesInstanceUid);
    for (const bool isDeidentified : {false, true}) {
        request.isDeidentified = isDeidentified;
        ASSERT_TRUE(writePresentation(path, request).ok());
        const auto read = dicom::readPresentationState(path);
        ASSERT_TRUE(read.ok());
        EXPECT_EQ(read->presentation.series.images[0].frames, request.images.series.images[0].frames);
        const auto same = openPresentation(path, *request.volume, digest, study::imagesOf(second));
        ASSERT_TRUE(same.ok()) << same.error().message;
        EXPECT_TRUE(same->isOwn);
        EXPECT_TRUE(same->notes.empty());
        EXPECT_FALSE(openPresentation(path, *request.volume, digest, study::imagesOf(first)).ok())
            << "another phase";
        const auto more = openPresentation(path, *request.volume, digest, study::imagesOf(whole));
        ASSERT_TRUE(more.ok());
        EXPECT_EQ(more->notes.size(), 1u) << "of a part of these";
    }
}

TEST_F(APresentation, IsARequestLikeAView) {
    dicom::test::write(*straight_, folder_ / "study");
    const auto scan = dicom::test::scan(folder_ / "study");
    ASSERT_TRUE(scan);
    const dicom::Series& series = scan->studies.at(0).series.at(0);
    PresentationRequest request;
    request.state = state_;
    request.state.clip = clip("left-half");
    request.volume = dicom::test::load(series);
    request.images = *presentedImages(series, series.stacks.at(0));
    const pictures::StateRequest typed{.presentation = folder_ / "a.dcm"};
    ASSERT_TRUE(writePresentation(typed.presentation, request).ok());
    auto state = stateOf(typed);
    ASSERT_TRUE(state.ok()) << state.error().message;
    study::LoadedStudy study{.volume = request.volume, .seriesDigest = sha256Hex(series.seriesInstanceUid)};
    const auto preset = pictures::completeState(*state, typed, study);
    ASSERT_TRUE(preset.ok()) << preset.error().message;
    EXPECT_EQ(state->camera, state_.camera);
    EXPECT_EQ(state->clip, request.state.clip);
    EXPECT_EQ(preset->publicName, "ct-bone");
    study.images = {{.sopInstanceUid = "2.25.1"}};  // another phase
    EXPECT_FALSE(pictures::completeState(*state, typed, study).ok());
    study.images.clear();
    study.seriesDigest = sha256Hex("another");
    EXPECT_FALSE(pictures::completeState(*state, typed, study).ok());
    // Of another program all is seen in a narrower picture, too.
    dicom::VolumePresentation foreign = said(*request.volume, false).presentation;
    foreign.series = request.images.series;
    const std::filesystem::path path = folder_ / "foreign.dcm";
    ASSERT_TRUE(dicom::writePresentationState(path, foreign, {.isDeidentified = true}).ok());
    const auto wide = stateOf(pictures::StateRequest{.presentation = path, .aspectWidthOverHeight = 1.5});
    const auto narrow = stateOf(pictures::StateRequest{.presentation = path, .aspectWidthOverHeight = 0.5});
    ASSERT_TRUE(wide.ok() && narrow.ok());
    EXPECT_GT(narrow->camera->verticalFovDeg, 2.0 * wide->camera->verticalFovDeg);
}

}  // namespace
}  // namespace macula::scene
