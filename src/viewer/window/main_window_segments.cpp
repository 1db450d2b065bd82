// Segments on slices and in 3D.
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/slices/slice_view.h"
#include "viewer/volume/hidden_voxels.h"
#include "viewer/volume/shown_additions.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

void MainWindow::connectSegments() {
    connect(segments_, &SegmentationKeeper::shownChanged, this, [this] {
        for (SliceView* pane : slices_) pane->setSegments(segments_->shown());
    });
    connect(segments_, &SegmentationKeeper::listChanged, this, &MainWindow::showNotes);
    connect(segments_, &SegmentationKeeper::began, this,
            [this] { segmenting_->begin(tr("Loading a segmentation")); });
    connect(segments_, &SegmentationKeeper::progressed, segmenting_, &WorkBar::setProgress);
    connect(segments_, &SegmentationKeeper::ended, segmenting_, &QWidget::hide);
    connect(segmenting_, &WorkBar::cancelClicked, segments_, &SegmentationKeeper::cancel);
    const auto tell = [this](const Error& error) {
        if (error.code == ErrorCode::cancelled) return;
        messages_->showError(error);
        emit failed(error);
    };
    connect(segments_, &SegmentationKeeper::failed, this, tell);
    connect(&shown_->hidden(), &HiddenVoxels::failed, this, tell);
    connect(&shown_->additions(), &ShownAdditions::failed, this, tell);
}

}  // namespace macula::viewer
