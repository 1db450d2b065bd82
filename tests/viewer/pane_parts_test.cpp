// The parts of a pane of slices, without a window.
#include <gtest/gtest.h>

#include <QCoreApplication>

#include "viewer/slice_volume.h"
#include "viewer/slices/pane_clip.h"
#include "viewer/slices/pane_request.h"
#include "viewer/slices/picture_texts.h"
#include "viewer/slices/slice_hand.h"

namespace macula::viewer {
namespace {

constexpr glm::ivec2 kPanePx{400, 400};

class PanePartsTest : public testing::Test {
  protected:
    PanePartsTest() {
        session_.show({.volume = test::sliceVolume()}, {});
        content_.takeStudy();
        zoom_.settle(kPanePx);
    }
    SliceRequest shown() const { return requestFor(content_, zoom_.view(), nullptr, kPanePx, 1.0); }
    const scene::StudyState& state() const { return session_.state(); }
    static QPointF placeOf(const SliceRequest& shown, const glm::dvec3& mm) {
        const glm::dvec2 px = shown.frame.pictureFromWorld(mm);
        return {px.x, px.y};
    }
    // From the middle of the volume to the block, with the left button.
    void dragToBlock() {
        const SliceRequest on = shown();
        const QPointF middle = placeOf(on, glm::dvec3(0.0));
        const QPointF end = placeOf(on, {-13.0, -9.0, 0.0});
        EXPECT_TRUE(hand_.press(Qt::LeftButton, middle, on));
        hand_.move({end, Qt::LeftButton, Qt::NoModifier}, on, kPanePx);
        hand_.release(Qt::LeftButton, end, &on);
    }

    int argc_ = 1;
    char name_[5] = "test";
    char* argv_[2] = {name_, nullptr};
    QCoreApplication application_{argc_, argv_};  // timers need it
    StudyEditor session_{scene::Catalogue{}};
    PaneContent content_{session_, slices::Orientation::axial, PaneRole::study};
    PaneZoom zoom_{content_};
    SliceTravel travel_{session_, content_, zoom_};
    SliceWindowing windowing_{session_, content_};
    PaneMeasurements measurements_{session_, content_};
    PaneClip clip_{session_};
    PaneTurn turn_{session_, content_};
    PaneCurve curve_{session_, content_};
    SliceHand hand_{{session_, zoom_, travel_, windowing_, measurements_, clip_, turn_, curve_}};
};

TEST_F(PanePartsTest, StepsSoonAfterEachOtherAreOneUndoStep) {
    const int before = content_.slice();
    travel_.moveBy(1);
    travel_.moveBy(1);
    EXPECT_EQ(content_.slice(), before + 2);
    session_.undo();
    EXPECT_EQ(content_.slice(), before);
    EXPECT_FALSE(session_.canUndo());
    travel_.goToLast();
    travel_.moveBy(1);
    EXPECT_EQ(content_.slice(), test::kSliceVolumeSize.z - 1);
}

TEST_F(PanePartsTest, ThirdsOfANotchAddUp) {
    const int before = content_.slice();
    for (int i = 0; i < 2; ++i) travel_.turnWheel(SliceTravel::kNotch / 3, false);
    EXPECT_EQ(content_.slice(), before);
    travel_.turnWheel(SliceTravel::kNotch / 3, false);
    EXPECT_EQ(content_.slice(), before + 1);
}

TEST_F(PanePartsTest, AZoomKeepsThePointUnderThePointer) {
    int changes = 0;
    QObject::connect(&zoom_, &PaneZoom::changed, [&] { ++changes; });
    const QPointF place(260.0, 180.0);
    const glm::dvec3 before = shown().worldFromPane(place);
    zoom_.zoomAt(place, 2.0, kPanePx);
    EXPECT_EQ(changes, 1);
    EXPECT_LT(glm::distance(shown().worldFromPane(place), before), 1e-6);
    const double closer = zoom_.view().mmPerPx;
    zoom_.settle(kPanePx);
    EXPECT_EQ(zoom_.view().mmPerPx, closer) << "not fitted again";
    zoom_.fit();
    zoom_.settle(kPanePx);
    EXPECT_NEAR(zoom_.view().mmPerPx, 2.0 * closer, 1e-9);
}

TEST_F(PanePartsTest, AFollowingPaneTellsNothingBeforeItWasTold) {
    PaneContent second(session_, slices::Orientation::axial, PaneRole::second);
    second.takeStudy();
    PaneZoom zoom(second);
    int told = 0;
    QObject::connect(&zoom, &PaneZoom::settled, [&] { ++told; });
    zoom.settle(kPanePx);
    EXPECT_EQ(told, 0);
    zoom.follow({.centreMm = {1.0, 2.0, 0.0}, .mmPerPx = 0.5});
    zoom.settle(kPanePx);
    EXPECT_EQ(told, 0);
    zoom.panBy({10.0, 0.0});
    zoom.settle(kPanePx);
    EXPECT_EQ(told, 1);
}

TEST_F(PanePartsTest, ADragOfTheDistanceToolMeasuresAndSelects) {
    hand_.setTool(SliceTool::distance);
    dragToBlock();
    ASSERT_EQ(state().measurements.size(), 1u);
    EXPECT_EQ(measurements_.selected(), 0u);
    EXPECT_FALSE(measurements_.isDrawing());
    const auto seen = measurements_.seenOn(shown());
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen.front().text, QStringLiteral("15.8 mm"));  // of 13 and 9 mm
    travel_.moveBy(3);
    EXPECT_TRUE(measurements_.seenOn(shown()).empty()) << "it is of another slice";
    measurements_.removeSelected();
    EXPECT_TRUE(state().measurements.empty());
}

TEST_F(PanePartsTest, AMeasurementStaysSelectedWhenAnotherOneGoes) {
    for (const double mm : {10.0, 20.0})
        session_.change("Measurement", [mm](scene::StudyState& next) {
            next.measurements.push_back({.shape = slices::Distance{{glm::dvec3(0.0), glm::dvec3(mm, 0, 0)}}});
        });
    ASSERT_TRUE(measurements_.selectAt(placeOf(shown(), {20.0, 0.0, 0.0}), shown()));
    ASSERT_EQ(measurements_.selected(), 1u);
    scene::StudyState before = state();
    session_.change("First",
                    [](scene::StudyState& next) { next.measurements.erase(next.measurements.begin()); });
    EXPECT_FALSE(measurements_.follow(before));
    EXPECT_EQ(measurements_.selected(), 0u);
    before = state();
    session_.change("All", [](scene::StudyState& next) { next.measurements.clear(); });
    EXPECT_TRUE(measurements_.follow(before));
    EXPECT_FALSE(measurements_.selected());
}

TEST_F(PanePartsTest, ADragOfTheWindowToolIsOneUndoStep) {
    const DisplayWindow before = content_.wantedWindow();
    hand_.setTool(SliceTool::window);
    dragToBlock();
    EXPECT_NE(content_.wantedWindow(), before);
    session_.undo();
    EXPECT_EQ(content_.wantedWindow(), before);
    EXPECT_FALSE(session_.canUndo());
}

TEST_F(PanePartsTest, ARightClickAsksForTheMenuAndADragDoesNot) {
    const SliceRequest on = shown();
    EXPECT_TRUE(hand_.press(Qt::RightButton, {100.0, 100.0}, on));
    EXPECT_TRUE(hand_.release(Qt::RightButton, {101.0, 100.0}, &on));
    EXPECT_TRUE(hand_.press(Qt::RightButton, {100.0, 100.0}, on));
    hand_.move({QPointF(150.0, 100.0), Qt::RightButton, Qt::NoModifier}, on, kPanePx);
    EXPECT_FALSE(hand_.release(Qt::RightButton, {150.0, 100.0}, &on));
    EXPECT_FALSE(hand_.isHolding());
}

TEST_F(PanePartsTest, TextsTellTheValueUnderThePointer) {
    travel_.pointAt(test::kBlockCentreMm, SliceShows::second);
    const SliceRequest on = shown();
    const QPointF block = placeOf(on, test::kBlockCentreMm);
    EXPECT_TRUE(probedText(on, block).startsWith(QLatin1String("1000 HU")))
        << probedText(on, block).toStdString();
    EXPECT_TRUE(overProbedText(on, block).isEmpty());
    const SliceOverlay overlay = overlayOf(on, slices::Orientation::axial, block);
    ASSERT_EQ(overlay.facts.size(), 3);
    EXPECT_EQ(overlay.facts.front(), probedText(on, block));
}

}  // namespace
}  // namespace macula::viewer
