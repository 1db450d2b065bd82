// The dose of a plan in the window: it offers itself, lies over the images, and has histograms.
#include <gtest/gtest.h>

#include <QAction>
#include <QTableWidget>
#include <stdexcept>

#include "dicom/support.h"
#include "study/dose/made_plan.h"
#include "viewer/dose/dose_controller.h"
#include "viewer/dose/dose_panel.h"
#include "viewer/dose/dvh_chart.h"
#include "viewer/dose/dvh_dialog.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/second/slice_pair.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class DoseWindowTest : public WindowTest {
  protected:
    DoseWindowTest() { layout_ = scene::Layout::fourPanes; }
    QAction& action(const char* name) {
        auto* found = window_->findChild<QAction*>(QString::fromLatin1(name));
        if (found == nullptr) throw std::runtime_error(name);
        return *found;
    }
    void open(const study::test::MadePlan& plan = {}) {
        study::test::writePlan(folder_.path(), plan);
        window_->open(folder_.path());
        ASSERT_TRUE(waitUntil([&] { return window_->hasStudy() && window_->dose().isAtRest(); }));
    }
    dicom::test::TemporaryFolder folder_;
};

TEST_F(DoseWindowTest, ADoseOffersItselfAndLiesOverTheImages) {
    open();
    ASSERT_EQ(window_->dose().found().size(), 1u);
    EXPECT_TRUE(window_->notes().contains("40 Gy prescribed")) << window_->notes().toStdString();
    ASSERT_TRUE(action("show-dose").isEnabled());
    action("show-dose").trigger();
    ASSERT_TRUE(waitUntil([&] { return window_->secondVolume().state() != nullptr; }));
    EXPECT_EQ(window_->secondVolume().state()->view, scene::SecondVolumePlace::over);
    EXPECT_EQ(window_->state().layout, scene::Layout::fourPanes);
    EXPECT_FALSE(window_->secondVolume().isRegistering());
    EXPECT_FALSE(window_->notes().contains("Show Dose")) << "it is shown";
    SliceView& axial = window_->slices(slices::Orientation::axial);
    ASSERT_TRUE(waitUntil([&] { return axial.isUpToDate(); }));
    const QPoint middle = axial.rect().center();
    QMouseEvent move(QEvent::MouseMove, middle, axial.mapToGlobal(middle), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&axial, &move);
    EXPECT_TRUE(axial.overProbedText().endsWith("% of 40 Gy prescribed"))
        << axial.overProbedText().toStdString();
    window_->session().undo();
    EXPECT_FALSE(window_->state().secondVolume);
}

TEST_F(DoseWindowTest, RegionsHaveHistograms) {
    open();
    action("show-dvh").trigger();
    DvhDialog& dialog = window_->dose().dialog();
    EXPECT_TRUE(dialog.isVisible());
    ASSERT_TRUE(waitUntil([&] { return dialog.report() != nullptr; }));
    ASSERT_EQ(dialog.table().rowCount(), 3);
    EXPECT_EQ(dialog.table().item(0, 0)->text(), "BOX");
    EXPECT_EQ(dialog.table().item(0, 4)->text(), "24.00") << "the mean";
    EXPECT_TRUE(dialog.chart().placeOnCurve(0, 24.0));
    window_->showStudy(smallStudy(Unit::hounsfield));
    EXPECT_EQ(dialog.report(), nullptr) << "it was of another study";
    EXPECT_FALSE(action("show-dose").isEnabled());
}

TEST_F(DoseWindowTest, ADoseOfAnotherFrameDoesNotOfferItself) {
    open({.frameOfReferenceUid = "2.25.9999"});
    EXPECT_TRUE(window_->dose().found().empty());
    EXPECT_FALSE(action("show-dose").isEnabled());
    EXPECT_FALSE(action("show-dvh").isEnabled());
    EXPECT_FALSE(window_->notes().contains("Show Dose")) << window_->notes().toStdString();
}

}  // namespace
}  // namespace macula::viewer
