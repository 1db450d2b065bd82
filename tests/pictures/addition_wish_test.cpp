// A second volume and segments, for who has no window: what of the wish can be wrong, and what it comes to.
#include "pictures/addition_wish.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "base/phantom.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/shown_clip.h"
#include "support.h"

namespace macula::app {
namespace {

StudyState viewWithBoth() {
    StudyState state;
    state.beside.emplace();
    state.beside->seriesDigest = "phantom";
    state.beside->link = BesideLink::sameFrame;
    state.beside->in3d = true;
    SegmentChoice coloured;
    coloured.isColouredIn3d = true;
    choose(state.segmentations, std::string(64, 'a'), coloured);
    state.segmentations.front().isShown = true;
    return state;
}

bool isTold(const std::vector<std::string>& notes, std::string_view words) {
    for (const std::string& note : notes)
        if (note.find(words) != std::string::npos) return true;
    return false;
}

ReadStudy phantomStudy() {
    ReadStudy study;
    study.input.volume = in16Bits(std::make_shared<const Volume>(phantom::make({.size = {24, 20, 16}})));
    study.input.identity.isOfNobody = true;
    return study;
}

TEST(AdditionWish, IsCheckedBeforeTheStudyIsRead) {
    StudyState state;
    const auto refusal = [&](const AdditionWish& wish, const char* study) {
        const auto choice = additionChoice(wish, study, state);
        return choice ? std::string() : choice.error().message;
    };
    EXPECT_EQ(refusal({}, "phantom:"), "");
    AdditionWish wish;
    wish.secondLinkIsGiven = true;
    EXPECT_EQ(refusal(wish, "phantom:"), "There is no second volume.");
    wish.second.path = "phantom:";
    EXPECT_EQ(refusal(wish, "phantom:"), "");
    wish.second.preset = "no such preset";
    EXPECT_NE(refusal(wish, "phantom:"), "");
    wish = {};
    wish.segments = {"keep:Liver"};
    EXPECT_EQ(refusal(wish, "a folder"), "");
    for (const char* none : {"", "phantom:", "head.nii.gz"})
        EXPECT_EQ(refusal(wish, none), "Only a folder of DICOM files can have segmentations.") << none;
    wish.segments = {"keep:Liver", "Liver"};
    EXPECT_NE(refusal(wish, "a folder"), "");
}

TEST(AdditionWish, AFileIsNoSecondVolumeOfItself) {
    const dicom::test::TemporaryFolder folder;
    std::ofstream(folder.path() / "a.nrrd") << "one";
    std::ofstream(folder.path() / "b.nrrd") << "one";
    StudyState state;
    AdditionWish wish;
    wish.second.path = folder.path() / "." / "a.nrrd";
    const auto refused = additionChoice(wish, folder.path() / "a.nrrd", state);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "The second volume is the study itself.");
    EXPECT_TRUE(additionChoice(wish, folder.path() / "b.nrrd", state));
    EXPECT_TRUE(additionChoice(wish, folder.path() / "missing.nrrd", state)) << "reading says that";
    EXPECT_TRUE(additionChoice(wish, folder.path(), state)) << "the series decide";
}

TEST(AdditionWish, TakesWhatTheViewSaysOutOfTheState) {
    StudyState state = viewWithBoth();
    Progress progress;
    const ReadStudy study = phantomStudy();
    const auto leftOut = shownClip(state, *study.input.volume, progress);
    ASSERT_TRUE(leftOut);
    EXPECT_EQ(leftOut->notes.size(), 2u) << "who does not draw them says so of both";

    const auto choice = additionChoice({}, "phantom:", state);
    ASSERT_TRUE(choice) << choice.error().message;
    EXPECT_TRUE(choice->needsSegmentations());
    EXPECT_TRUE(choice->beside);
    EXPECT_TRUE(state.segmentations.empty());
    EXPECT_FALSE(state.beside);
    auto shown = shownClip(state, *study.input.volume, progress);
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

TEST(AdditionWish, IsInTheDrawingAndSaidButOfAProjection) {
    StudyState state;
    AdditionWish wish;
    wish.second.path = "phantom:";
    Progress progress;
    const ReadStudy study = phantomStudy();
    const auto choice = additionChoice(wish, "phantom:", state);
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
    Drawing drawing;
    drawing.remarks = "clipped";
    setAdditions(drawing, additions);
    EXPECT_EQ(drawing.additions, additions);
    EXPECT_EQ(drawing.remarks, "clipped, with CT");
    Drawing projection;
    projection.settings.look = trace::Look::mip;
    setAdditions(projection, additions);
    EXPECT_EQ(projection.additions, additions) << "there when the look changes back";
    EXPECT_EQ(projection.remarks, "");
    setAdditions(projection, nullptr);
    EXPECT_FALSE(projection.additions);
}

}  // namespace
}  // namespace macula::app
