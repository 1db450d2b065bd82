// Segmentations of the open study: their panel, their segments on slices, and those that are saved.
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <vector>

#include "scene/segments/segmentation_file.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QMenu;

namespace macula::viewer {

class LabelMapOpener;
class SegmentationKeeper;
class SegmentationPanel;
class SliceView;
class WorkBar;

// Lives on the UI thread.
class SegmentationsController : public QObject {
    Q_OBJECT

  public:
    // `keeper` outlives it.
    SegmentationsController(const WindowContext& context, SegmentationKeeper& keeper,
                            const std::array<SliceView*, 3>& slices);

    SegmentationPanel& panel() const { return *panel_; }
    LabelMapOpener& labelMaps() const { return *labelMaps_; }
    WorkBar* loadingBar() const { return bar_; }  // while segments load
    void addFileAction(QMenu& file);

    // What one object of the segmentations is made of that are shown now. Fails with usage where none is, or
    // no DICOM images are open.
    Result<scene::SegmentationRequest> onScreen() const;

    QString unfinished() const;  // a sentence; empty: nothing is being written
    void cancel() { saving_.cancel(); }

  Q_SIGNALS:
    void written();

  private:
    void askHowToSave();
    void askWhereToSave(scene::SegmentationRequest request);

    WindowContext context_;
    SegmentationKeeper& keeper_;
    std::array<SliceView*, 3> slices_;
    SegmentationPanel* panel_;
    LabelMapOpener* labelMaps_;
    WorkBar* bar_;
    QString path_;  // of the file that is being written
    BackgroundJob<std::vector<Text>> saving_;
};

}  // namespace macula::viewer
