// A clip on slices: what it removes, and its handles.
#include "scene/clip/edited_clip.h"
#include "viewer/slice_view_fixture.h"

namespace macula::viewer {
namespace {

using slices::Orientation;

// Left of 6 mm is removed.
class ClippedSliceTest : public SliceViewTest {
  protected:
    void clipLeft() {
        session_->change("Clip", [this](scene::StudyState& next) {
            next.clip = *scene::withFace({}, scene::Face::left, 6.0, *session_->study().volume);
        });
    }
    double leftMm() const { return scene::keptBox(state().clip, *session_->study().volume)->high.x; }
    static int greyAt(SliceView& view, const glm::dvec3& mm) {
        return qGray(pictureOf(view).pixel(placeOf(view, mm)));
    }
};

TEST_F(ClippedSliceTest, WhatIsRemovedIsDimmed) {
    showStudy();
    session_->change("Cross-hair", [](scene::StudyState& next) {
        next.slices.crosshairMm = {-19.0, -14.0, 12.0};
        next.slices.window =
            DisplayWindow{.center = 0.0, .width = 1000.0, .explanation = {}, .function = "LINEAR"};
    });
    const auto view = pane(Orientation::axial);
    const int before = greyAt(*view, {12.0, 10.0, 12.0});
    EXPECT_GT(before, 100);
    clipLeft();
    ASSERT_TRUE(settled(*view));
    EXPECT_LT(greyAt(*view, {12.0, 10.0, 12.0}), before / 2)
        << "at the patient's left, the right of the pane";
    EXPECT_EQ(greyAt(*view, {-3.0, 10.0, 12.0}), before) << "what is kept is as it was";
    view->showClip(false, false);
    EXPECT_EQ(greyAt(*view, {12.0, 10.0, 12.0}), before);
}

TEST_F(ClippedSliceTest, AFaceIsDraggedByItsHandleInOneStep) {
    showStudy();
    const auto view = pane(Orientation::axial);
    clipLeft();
    const QPoint handle = placeOf(*view, {6.0, 0.0, 0.0});
    move(*view, handle, Qt::NoButton);
    EXPECT_EQ(view->cursor().shape(), Qt::CrossCursor) << "no handles were asked for";
    drag(*view, Qt::LeftButton, handle, placeOf(*view, {2.0, 5.0, 0.0}));
    EXPECT_NEAR(leftMm(), 6.0, 1e-9);
    EXPECT_TRUE(state().slices.crosshairMm) << "it was the cross-hair that was dragged";
    session_->undo();

    view->showClip(true, true);
    ASSERT_TRUE(settled(*view));
    move(*view, handle, Qt::NoButton);
    EXPECT_EQ(view->cursor().shape(), Qt::SizeHorCursor);
    drag(*view, Qt::LeftButton, handle, placeOf(*view, {2.0, 5.0, 0.0}));
    EXPECT_NEAR(leftMm(), 2.0, 0.2);
    EXPECT_FALSE(state().slices.crosshairMm);
    EXPECT_EQ(session_->undoText(), "Clip");
    session_->undo();
    EXPECT_NEAR(leftMm(), 6.0, 1e-9) << "the drag is one step";
    // Another drag is another step.
    drag(*view, Qt::LeftButton, handle, placeOf(*view, {9.0, 0.0, 0.0}));
    drag(*view, Qt::LeftButton, placeOf(*view, {leftMm(), 0.0, 0.0}), placeOf(*view, {12.0, 0.0, 0.0}));
    session_->undo();
    EXPECT_NEAR(leftMm(), 9.0, 0.2);
}

TEST_F(ClippedSliceTest, WithoutAClipABorderOfTheVolumeIsTakenHoldOf) {
    showStudy();
    const auto view = pane(Orientation::coronal);
    turnWheel(*view, -3, Qt::ControlModifier);  // smaller: the borders are in the pane
    ASSERT_TRUE(settled(*view));
    view->showClip(true, true);
    const Box all = session_->study().volume->worldBox();
    drag(*view, Qt::LeftButton, placeOf(*view, {0.0, 0.0, all.high.z}), placeOf(*view, {0.0, 0.0, 8.0}));
    ASSERT_TRUE(state().clip);
    EXPECT_NEAR(scene::keptBox(state().clip, *session_->study().volume)->high.z, 8.0, 0.2)
        << "superior is up";
}

TEST_F(ClippedSliceTest, TheBallIsMovedAndSized) {
    showStudy();
    const auto view = pane(Orientation::axial);
    session_->change("Clip", [this](scene::StudyState& next) {
        next.clip = *scene::withBallRemoved({}, {0.0, 0.0, 4.0}, 8.0, *session_->study().volume);
    });
    view->showClip(true, true);
    const auto ball = [&] { return *clipFor(*state().clip, *session_->study().volume).ball; };
    // The slice at 0 mm: a circle of the root of 8 x 8 - 4 x 4.
    const double radius = std::sqrt(48.0);
    move(*view, placeOf(*view, {0.0, 0.0, 0.0}), Qt::NoButton);
    EXPECT_EQ(view->cursor().shape(), Qt::SizeAllCursor);
    drag(*view, Qt::LeftButton, placeOf(*view, {0.0, 0.0, 0.0}), placeOf(*view, {-4.0, 2.0, 0.0}));
    EXPECT_LT(glm::distance(ball().centreMm, {-4.0, 2.0, 4.0}), 0.3) << "it stays as high as it was";
    EXPECT_NEAR(ball().radiusMm, 8.0, 1e-9);
    drag(*view, Qt::LeftButton, placeOf(*view, {-4.0 + radius, 2.0, 0.0}), placeOf(*view, {7.0, 2.0, 0.0}));
    EXPECT_NEAR(ball().radiusMm, std::sqrt(11.0 * 11.0 + 16.0), 0.3);
}

}  // namespace
}  // namespace macula::viewer
