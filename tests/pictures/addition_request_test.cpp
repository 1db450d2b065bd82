// A second volume and segments, for who has no window: what of the request can be wrong, and what it comes
// to.
#include "pictures/addition_request.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "base/phantom.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/shown_clip.h"
#include "support.h"

namespace macula::pictures {
namespace {

scene::StudyState viewWithBoth() {
    scene::StudyState state;
    state.secondVolume.emplace();
    state.secondVolume->seriesDigest = "phantom";
    state.secondVolume->link = scene::SecondVolumeLink::sameFrame;
    state.secondVolume->in3d = true;
    scene::SegmentSettings coloured;
    coloured.isColouredIn3d = true;
    scene::choose(state.segmentations, std::string(64, 'a'), coloured);
    state.segmentations.front().isShown = true;
    return state;
}

bool isTold(const std::vector<Text>& notes, std::string_view words) {
    for (const Text& note : notes)
        if (note.english().find(words) != std::string::npos) return true;
    return false;
}

study::ReadStudy phantomStudy() {
    study::ReadStudy study;
    study.input.volume = in16Bits(std::make_shared<const Volume>(phantom::make({.size = {24, 20, 16}})));
    study.input.identity.isOfNobody = true;
    return study;
}

TEST(AdditionRequest, IsCheckedBeforeTheStudyIsRead) {
    scene::StudyState state;
    const auto refusal = [&](const AdditionRequest& request, const char* study) {
        const auto choice = resolveAdditions(request, study, state);
        return choice ? std::string() : choice.error().message.english();
    };
    EXPECT_EQ(refusal({}, "phantom:"), "");
    AdditionRequest request;
    request.secondLinkIsGiven = true;
    EXPECT_EQ(refusal(request, "phantom:"), "There is no second volume.");
    request.second.path = "phantom:";
    EXPECT_EQ(refusal(request, "phantom:"), "");
    request.second.preset = "no such preset";
    EXPECT_NE(refusal(request, "phantom:"), "");
    request = {};
    request.segments = {"keep:Liver"};
    EXPECT_EQ(refusal(request, "a folder"), "");
    for (const char* none : {"", "phantom:", "head.nii.gz"})
        EXPECT_EQ(refusal(request, none), "Only a folder of DICOM files can have segmentations.") << none;
    request.segments = {"keep:Liver", "Liver"};
    EXPECT_NE(refusal(request, "a folder"), "");
}

TEST(AdditionRequest, AFileIsNoSecondVolumeOfItself) {
    const dicom::test::TemporaryFolder folder;
    std::ofstream(folder.path() / "a.nrrd") << "one";
    std::ofstream(folder.path() / "b.nrrd") << "one";
    scene::StudyState state;
    AdditionRequest request;
    request.second.path = folder.path() / "." / "a.nrrd";
    const auto refused = resolveAdditions(request, folder.path() / "a.nrrd", state);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "The second volume is the study itself.");
    EXPECT_TRUE(resolveAdditions(request, folder.path() / "b.nrrd", state));
    EXPECT_TRUE(resolveAdditions(request, folder.path() / "missing.nrrd", state)) << "reading says that";
    EXPECT_TRUE(resolveAdditions(request, folder.path(), state)) << "the series decide";
}

TEST(AdditionRequest, TakesWhatTheViewSaysOutOfTheState) {
    scene::StudyState state = viewWithBoth();
    Progress progress;
    const study::ReadStudy study = phantomStudy();
    const auto leftOut = scene::shownClip(state, *study.input.volume, progress);
    ASSERT_TRUE(leftOut);
    EXPECT_EQ(leftOut->notes.size(), 2u) << "who does not draw them says so of both";

    const auto choice = resolveAdditions({}, "phantom:", state);
    ASSERT_TRUE(choice) << choice.error().message;
    EXPECT_TRUE(choice->needsSegmentations());
    EXPECT_TRUE(choice->secondVolume);
    EXPECT_TRUE(state.segmentations.empty());
    EXPECT_FALSE(state.secondVolume);
    auto shown = scene::shownClip(state, *study.input.volume, progress);
    ASSERT_TRUE(shown);
    EXPECT_TRUE(shown->notes.empty());
    // Neither is here.
    const auto made = makeAdditions(*choice, study, trace::Look::cinematic, shown->clip, progress);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_TRUE(made->additions.isNothing());
    EXPECT_TRUE(made->additions.remark.empty());
    EXPECT_FALSE(shown->clip.mask);
    EXPECT_TRUE(isTold(made->notes, "segments of the view are not here"));
    EXPECT_TRUE(isTold(made->notes, "give it by --second"));
    const auto projected = makeAdditions(*choice, study, trace::Look::mip, shown->clip, progress);
    ASSERT_TRUE(projected);
    EXPECT_FALSE(isTold(projected->notes, "--second")) << "a projection would not draw it";
}

TEST(AdditionRequest, IsInTheDrawingAndSaidButOfAProjection) {
    scene::StudyState state;
    AdditionRequest request;
    request.second.path = "phantom:";
    Progress progress;
    const study::ReadStudy study = phantomStudy();
    const auto choice = resolveAdditions(request, "phantom:", state);
    ASSERT_TRUE(choice) << choice.error().message;
    Clip clip;
    const auto made = makeAdditions(*choice, study, trace::Look::mip, clip, progress);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_FALSE(made->additions.second);
    EXPECT_TRUE(isTold(made->notes, "--second does nothing in this look"));
    EXPECT_EQ(made->notes.size(), 1u) << "nothing of where it lies";
    EXPECT_TRUE(made->warnings.empty());
    const auto traced = makeAdditions(*choice, study, trace::Look::cinematic, clip, progress);
    ASSERT_TRUE(traced);
    EXPECT_FALSE(isTold(traced->notes, "does nothing"));
    EXPECT_FALSE(traced->warnings.empty()) << "nothing says that the positions are comparable";
    ASSERT_TRUE(traced->additions.second);

    const auto additions = std::make_shared<const Additions>(traced->additions);
    scene::Drawing drawing;
    drawing.remarks = Text("clipped");
    scene::setAdditions(drawing, additions);
    EXPECT_EQ(drawing.additions, additions);
    EXPECT_EQ(drawing.remarks, "clipped, with CT");
    scene::Drawing projection;
    projection.settings.look = trace::Look::mip;
    scene::setAdditions(projection, additions);
    EXPECT_EQ(projection.additions, additions) << "there when the look changes back";
    EXPECT_EQ(projection.remarks, "");
    scene::setAdditions(projection, nullptr);
    EXPECT_FALSE(projection.additions);
}

}  // namespace
}  // namespace macula::pictures
