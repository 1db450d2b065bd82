// Own segments in the window: the panel and its tools, and that they survive the program.
#include <gtest/gtest.h>

#include <QAction>
#include <QInputDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/segmenting/segmenting_controller.h"
#include "viewer/slices/slice_view.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class SegmentingWindowTest : public WindowTest {
  protected:
    SegmentingWindowTest() { layout_ = scene::Layout::fourPanes; }
    bool openPhantom() {
        window_->open(std::nullopt);
        return waitUntil([&] { return window_->hasStudy() && !window_->loading() && axial().isUpToDate(); });
    }
    SliceView& axial() { return window_->slices(slices::Orientation::axial); }
    SegmentationKeeper& keeper() { return window_->segments(); }
    void click(const char* name) {
        auto* button = window_->findChild<QPushButton*>(QLatin1String(name));
        ASSERT_NE(button, nullptr) << name;
        button->click();
    }
    std::size_t count() {
        return keeper().own() && !keeper().own()->segments.empty()
                   ? keeper().own()->segments.front().voxels->count()
                   : 0;
    }
    void paintInTheMiddle() {
        window_->findChild<QAction*>(QStringLiteral("slice-tool-segment"))->trigger();
        QTest::mouseClick(&axial(), Qt::LeftButton, {}, axial().rect().center());
        ASSERT_TRUE(waitUntil([&] { return count() > 0; }));
    }

    QTemporaryDir folder_;
};

TEST_F(SegmentingWindowTest, APersonMakesPaintsAndUndoes) {
    ASSERT_TRUE(openPhantom());
    click("segment-new");
    auto* dialog = window_->findChild<QInputDialog*>(QStringLiteral("segment-name-dialog"));
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue(QStringLiteral("Lesion"));
    dialog->accept();
    ASSERT_TRUE(waitUntil([&] { return keeper().own() && keeper().own()->segments.size() == 1; }));
    EXPECT_EQ(keeper().own()->segments.front().segment.label, "Lesion");
    EXPECT_EQ(window_->segmenting().work().selected(), std::uint16_t(1));
    paintInTheMiddle();
    const std::size_t painted = count();
    auto* tree = window_->findChild<QTreeWidget*>(QStringLiteral("segments"));
    EXPECT_EQ(tree->topLevelItem(0)->child(0)->text(0), QStringLiteral("Lesion"));
    EXPECT_TRUE(waitUntil([&] { return axial().isUpToDate(); }));
    window_->session().undo();
    EXPECT_EQ(count(), 0u);
    window_->session().redo();
    EXPECT_EQ(count(), painted);
    // In 3D, as those that are read.
    auto* tree3d = window_->findChild<QPushButton*>(QStringLiteral("segment-alone"));
    ASSERT_TRUE(tree3d->isEnabled());
    tree3d->click();
    EXPECT_TRUE(waitUntil([&] { return keeper().isAtRest() && !keeper().madeIn3d().empty(); }));
    // Nothing is kept here: quitting asks.
    EXPECT_TRUE(window_->segmenting().unfinished().contains(QStringLiteral("in no file")));
    EXPECT_TRUE(window_->isWriting());
    window_->segmenting().cancel();
    EXPECT_FALSE(window_->isWriting());
}

TEST_F(SegmentingWindowTest, SegmentsAreThereWhenTheStudyIsOpenedAgain) {
    sessions_ = folder_.filePath(QStringLiteral("sessions")).toStdString();
    window_.reset();
    makeWindow();
    ASSERT_TRUE(openPhantom());
    paintInTheMiddle();
    const std::size_t painted = count();
    EXPECT_FALSE(window_->isWriting()) << "they are kept";
    window_.reset();

    makeWindow();
    ASSERT_TRUE(openPhantom());
    ASSERT_TRUE(waitUntil([&] { return count() > 0; }));
    EXPECT_EQ(count(), painted);
    EXPECT_TRUE(keeper().shown()) << "and are shown as they were";
    EXPECT_FALSE(window_->notes().contains(QStringLiteral("not in the folder")))
        << window_->notes().toStdString();
}

TEST_F(SegmentingWindowTest, AProgramThatFailsSaysWhy) {
    ASSERT_TRUE(openPhantom());
    window_->findChild<QAction*>(QStringLiteral("segment-by-program"))->trigger();
    auto* dialog = window_->findChild<QDialog*>(QStringLiteral("program-dialog"));
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QLineEdit*>(QStringLiteral("program-command"))
        ->setText(QStringLiteral("sh -c \"echo weights are missing >&2; exit 4\" {input} {output}"));
    dialog->accept();
    ASSERT_TRUE(waitUntil([&] { return window_->message().contains(QStringLiteral("weights are missing")); }))
        << window_->message().toStdString();
    EXPECT_TRUE(window_->message().contains(QStringLiteral("code 4")));
    EXPECT_FALSE(window_->segmenting().program().isRunning());
}

}  // namespace
}  // namespace macula::viewer
