#include "viewer/segmentation/segmentations_controller.h"

#include <QMainWindow>

#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/segmentation/segmentation_panel.h"
#include "viewer/slices/slice_view.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"
#include "viewer/status/study_notes.h"

namespace macula::viewer {

SegmentationsController::SegmentationsController(const WindowContext& context, SegmentationKeeper& keeper,
                                                 const std::array<SliceView*, 3>& slices)
    : QObject(&context.window),
      context_(context),
      keeper_(keeper),
      slices_(slices),
      panel_(new SegmentationPanel(context.session, keeper)),
      bar_(new WorkBar) {
    connect(&keeper_, &SegmentationKeeper::shownChanged, this, [this] {
        for (SliceView* pane : slices_) pane->setSegments(keeper_.shown());
    });
    connect(&keeper_, &SegmentationKeeper::listChanged, &context_.notes, &StudyNotes::show);
    connect(&keeper_, &SegmentationKeeper::began, this,
            [this] { bar_->begin(tr("Loading a segmentation")); });
    connect(&keeper_, &SegmentationKeeper::progressed, bar_, &WorkBar::setProgress);
    connect(&keeper_, &SegmentationKeeper::ended, bar_, &QWidget::hide);
    connect(bar_, &WorkBar::cancelClicked, &keeper_, &SegmentationKeeper::cancel);
    connect(&keeper_, &SegmentationKeeper::failed, &context_.notifications,
            &Notifications::failUnlessCancelled);
    context_.notes.ask(NoteOn::segments, [this] {
        const QString note = keeper_.note();
        return note.isEmpty() ? QStringList() : QStringList{note};
    });
}

}  // namespace macula::viewer
