// Label maps of other programs in the window: opened, dropped, asked about, shown, undone.
#include <gtest/gtest.h>

#include <QAction>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTreeWidget>
#include <QUrl>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "formats/volume_file.h"
#include "viewer/segmentation/label_map_opener.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/segmentation/segmentations_controller.h"
#include "viewer/slices/slice_view.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

class LabelMapsWindowTest : public WindowTest {
  protected:
    LabelMapsWindowTest() { layout_ = scene::Layout::fourPanes; }

    void openCt() {
        series_.size = {12, 11, 10};
        dicom::test::writeFiles(folder_ / "ct", series_);
        window_->open(folder_ / "ct");
        ASSERT_TRUE(waitUntil([this] { return window_->hasStudy() && !window_->loading(); }));
        ASSERT_TRUE(waitUntil([this] { return axial().isUpToDate() && window_->segments().isAtRest(); }));
    }
    // On the voxels of the CT, or beside them: the ball is in the middle, and has the number 5.
    QString writeLabels(const char* name, double besideMm = 0.0) {
        const Volume& volume = *window_->session().study().volume;
        glm::dmat4 place = volume.worldFromVoxel();
        place[3].x += besideMm;
        const glm::ivec3 size = volume.size();
        std::vector<std::uint16_t> labels;
        for (int k = 0; k < size.z; ++k)
            for (int j = 0; j < size.y; ++j)
                for (int i = 0; i < size.x; ++i)
                    labels.push_back(glm::distance(glm::dvec3(i, j, k), glm::dvec3(6, 5, 5)) < 3.0 ? 5 : 0);
        Progress progress;
        const auto map = LabelMap::create(size, place, {}, std::move(labels));
        EXPECT_TRUE(formats::writeVolumeFile(*map, folder_ / name, progress));
        return QString::fromStdString((folder_ / name).string());
    }
    void drop(const QString& path) {
        QMimeData files;
        files.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&*window_, &enter);
        QDropEvent event(QPointF(10, 10), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&*window_, &event);
    }
    bool isShown() {
        return waitUntil([this] { return window_->segments().shown() != nullptr; });
    }
    SliceView& axial() { return window_->slices(slices::Orientation::axial); }
    QMessageBox* question() { return window_->findChild<QMessageBox*>(QStringLiteral("label-map-question")); }

    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
};

TEST_F(LabelMapsWindowTest, ADroppedOneOnTheVoxelsIsAskedAbout) {
    openCt();
    const QString path = writeLabels("labels.nii.gz");
    drop(path);
    ASSERT_TRUE(waitUntil([this] { return question() != nullptr; }));
    EXPECT_TRUE(question()->text().contains(QStringLiteral("labels.nii.gz")));
    question()->findChild<QPushButton*>(QStringLiteral("label-map-segmentation"))->click();
    ASSERT_TRUE(isShown());
    const auto* loaded = window_->segments().allLoaded().back().get();
    ASSERT_EQ(loaded->segments.size(), 1u);
    EXPECT_EQ(loaded->segments[0].segment.label, "Label 5");
    EXPECT_FALSE(loaded->isResampled);
    EXPECT_TRUE(window_->message().contains(QStringLiteral("no frame of reference")))
        << window_->message().toStdString();
    auto* tree = window_->findChild<QTreeWidget*>(QStringLiteral("segments"));
    ASSERT_EQ(tree->topLevelItemCount(), 1);
    EXPECT_EQ(tree->topLevelItem(0)->text(0), QStringLiteral("labels.nii.gz"));
    EXPECT_EQ(tree->topLevelItem(0)->checkState(0), Qt::Checked);
    // One undo step hides it; it stays in the list, until another study opens.
    window_->session().undo();
    EXPECT_EQ(window_->segments().shown(), nullptr);
    EXPECT_EQ(tree->topLevelItemCount(), 1);
    tree->topLevelItem(0)->setCheckState(0, Qt::Checked);
    EXPECT_TRUE(isShown());
    // The same file once more takes its own place.
    window_->findChild<LabelMapOpener*>()->open(path);
    ASSERT_TRUE(waitUntil([this] { return !window_->findChild<LabelMapOpener*>()->isOpening(); }));
    EXPECT_EQ(tree->topLevelItemCount(), 1);
    // And it is what a DICOM segmentation is saved of.
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return tree->topLevelItemCount() == 0; }));
}

TEST_F(LabelMapsWindowTest, OneOfOtherVoxelsIsOpenedAsTheVolumeThatItIs) {
    openCt();
    drop(writeLabels("beside.nrrd", 1.0));
    ASSERT_TRUE(
        waitUntil([this] { return window_->session().study().description.english() == "beside.nrrd"; }));
    EXPECT_EQ(question(), nullptr);
}

TEST_F(LabelMapsWindowTest, FilesThatAreNoLabelMapsAreRefusedInWords) {
    openCt();
    const QString ct = [this] {
        Progress progress;
        EXPECT_TRUE(
            formats::writeVolumeFile(*window_->session().study().volume, folder_ / "ct.nii.gz", progress));
        return QString::fromStdString((folder_ / "ct.nii.gz").string());
    }();
    window_->findChild<LabelMapOpener*>()->open(ct);
    ASSERT_TRUE(waitUntil([this] { return !window_->message().isEmpty(); }));
    EXPECT_EQ(window_->segments().shown(), nullptr);
    window_->findChild<LabelMapOpener*>()->open(writeLabels("far.mha", 900.0));
    ASSERT_TRUE(waitUntil([this] {
        return window_->message().contains(QStringLiteral("No voxel of this segmentation"));
    })) << window_->message().toStdString();
    EXPECT_TRUE(window_->hasStudy());
}

}  // namespace
}  // namespace macula::viewer
