// The hand of the bench, in the real window: what it does arrives, and what it looks for is there.
#include "viewer/driven/driven_hand.h"

#include <QAction>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QTabWidget>

#include "viewer/driven/session_steps.h"
#include "viewer/slices/slice_view.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class DrivenWindowTest : public WindowTest {
  protected:
    DrivenWindowTest() { layout_ = scene::Layout::fourPanes; }
    void openPhantom() {
        window_->open({});
        ASSERT_TRUE(waitUntil([&] { return window_->hasStudy() && last_; }));
        hand_.emplace(*window_);
    }
    bool atRest() {
        return waitUntil([&] { return !hand_->isBusy(); });
    }
    void TearDown() override {
        hand_.reset();
        WindowTest::TearDown();
    }

    std::optional<DrivenHand> hand_;
};

TEST_F(DrivenWindowTest, DragsWheelAndKeysArrive) {
    openPhantom();
    VulkanWindow& picture = window_->viewport().window();
    const Camera before = toCamera(window_->viewport().camera());
    const QPointF middle = DrivenHand::middleOf(picture);
    hand_->drag(picture, middle, middle + QPointF(40, 5));
    EXPECT_TRUE(hand_->isBusy());
    ASSERT_TRUE(atRest());
    EXPECT_NE(toCamera(window_->viewport().camera()), before);

    SliceView& axial = window_->slices(slices::Orientation::axial);
    ASSERT_TRUE(waitUntil([&] { return axial.shownFrame().has_value(); }));
    const auto crosshair = window_->session().state().slices.crosshairMm;
    hand_->turnWheel(axial, 4);
    ASSERT_TRUE(atRest());
    EXPECT_NE(window_->session().state().slices.crosshairMm, crosshair);

    auto* studies = hand_->find<QDockWidget>("studies-panel");
    ASSERT_NE(studies, nullptr);
    hand_->press(Qt::Key_F2);
    EXPECT_FALSE(studies->isHidden());
    showPanel(*hand_, "studies-panel", false);
    EXPECT_TRUE(studies->isHidden());
    showPanel(*hand_, "studies-panel", false);
    EXPECT_TRUE(studies->isHidden());
    auto* filter = hand_->find<QLineEdit>("preset-filter");
    ASSERT_NE(filter, nullptr);
    hand_->type(*filter, QStringLiteral("bone"));
    EXPECT_EQ(filter->text(), QStringLiteral("bone"));
    EXPECT_TRUE(hand_->missing().isEmpty());
}

// A name that is changed in the window would leave a part of the bench undone.
TEST_F(DrivenWindowTest, WhatTheBenchLooksForIsThere) {
    openPhantom();
    for (const char* widget :
         {"studies-panel", "presets-panel", "transfer-panel", "clip-panel", "segments-panel", "movie-panel",
          "search", "studies", "presets", "preset-filter", "transfer-curve", "clip-slider-left",
          "slab-thickness", "quality-automatic"})
        hand_->find<QWidget>(widget);
    for (const char* action :
         {"slice-tool-distance", "slice-tool-ellipse", "slice-tool-crosshair", "slab-maximum", "slab-mean",
          "clip-anterior-half", "save-picture", "save-movie", "settings", "undo", "redo", "show-afresh"})
        EXPECT_NE(hand_->find<QAction>(action), nullptr) << action;
    EXPECT_TRUE(hand_->missing().isEmpty()) << hand_->missing().join(QLatin1Char(' ')).toStdString();
    hand_->trigger("settings");
    EXPECT_NE(hand_->find<QTabWidget>("settings-pages"), nullptr);
    for (auto* dialog : window_->findChildren<QDialog*>()) {
        if (dialog->isVisible()) dialog->reject();
    }
    hand_->trigger("no-such-action");
    EXPECT_EQ(hand_->missing(), QStringList{QStringLiteral("no-such-action")});
}

}  // namespace
}  // namespace macula::viewer
