// Edits of how segments are shown, without the panel.
#include <gtest/gtest.h>

#include <optional>

#include "viewer/offscreen.h"
#include "viewer/segmentation/segment_edits.h"

namespace macula::viewer {
namespace {

class SegmentEditsTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        session_.emplace(scene::Catalogue{});
        session_->show(smallStudy(), {});
        withoutFolder_.emplace(scene::Catalogue{});
        keeper_.emplace(*withoutFolder_);  // has found nothing, and looks for nothing
        edits_.emplace(*session_, *keeper_);
    }
    void TearDown() override {
        edits_.reset();
        keeper_.reset();
        withoutFolder_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }

    const SegmentId whole_{.digest = "abc"};
    const SegmentId liver_{.digest = "abc", .number = 1};
    const SegmentId tumour_{.digest = "abc", .number = 2};
    std::optional<StudyEditor> session_;
    std::optional<StudyEditor> withoutFolder_;
    std::optional<SegmentationKeeper> keeper_;
    std::optional<SegmentEdits> edits_;
};

TEST_F(SegmentEditsTest, WhoeverIsAskedForIn3dIsShown) {
    EXPECT_FALSE(edits_->isShown(whole_));
    edits_->setIn3d(liver_, scene::In3d::alone, true);
    EXPECT_TRUE(edits_->isShown(whole_));
    EXPECT_EQ(edits_->settings(liver_).in3d, scene::In3d::alone);
    EXPECT_EQ(edits_->settings(tumour_).in3d, scene::In3d::asIs);
    session_->undo();
    EXPECT_FALSE(edits_->isShown(whole_));
    EXPECT_FALSE(session_->canUndo()) << "that is one step";
}

TEST_F(SegmentEditsTest, NobodyIsShownByBeingNoLongerColoured) {
    edits_->setColoured(liver_, true);
    edits_->show(whole_, false);
    edits_->setColoured(liver_, false);
    EXPECT_FALSE(edits_->isShown(whole_));
    EXPECT_FALSE(edits_->settings(liver_).isColouredIn3d);
}

TEST_F(SegmentEditsTest, ADragOfTheOpacityIsOneStepAndAColourIsAnother) {
    const double usual = edits_->settings(liver_).opacity;
    edits_->dragOpacity(liver_, &scene::SegmentSettings::opacity, 0.7);
    edits_->dragOpacity(liver_, &scene::SegmentSettings::opacity, 0.9);
    edits_->setColour(liver_, QColor(10, 20, 30));
    EXPECT_EQ(edits_->colour(liver_), QColor(10, 20, 30));
    EXPECT_EQ(edits_->settings(liver_).opacity, 0.9);
    session_->undo();
    EXPECT_NE(edits_->colour(liver_), QColor(10, 20, 30));
    session_->undo();
    EXPECT_EQ(edits_->settings(liver_).opacity, usual);
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(SegmentEditsTest, WhatIsNotLoadedHasNoMiddle) {
    EXPECT_EQ(edits_->loaded(liver_), nullptr);
    edits_->centreOn(liver_);
    EXPECT_FALSE(session_->canUndo());
}

}  // namespace
}  // namespace macula::viewer
