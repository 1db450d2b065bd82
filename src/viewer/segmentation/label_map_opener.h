// Opens label maps from files as segmentations of the open volume.
#pragma once

#include <QObject>
#include <QString>
#include <functional>

#include "study/segmentation/label_map.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

class SegmentationKeeper;

// The study on screen stays. One file at a time, in the background; another study ends it. Lives on the UI
// thread.
class LabelMapOpener : public QObject {
    Q_OBJECT

  public:
    // `keeper` outlives it.
    LabelMapOpener(const WindowContext& context, SegmentationKeeper& keeper);

    void askForFile();
    void open(const QString& path);
    // Of a file that is dropped on the window: a segmentation is opened as one, and where it may be one, a
    // person is asked; `openAsVolume` is called otherwise, at once or later. False where no volume is open,
    // or it is no volume file: then it does nothing.
    bool takesDropped(const QString& path, std::function<void()> openAsVolume);
    bool isOpening() const { return guessing_.running() || opening_.running(); }
    void cancel();

  Q_SIGNALS:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();

  private:
    void onGuessed(const Result<study::LabelMapGuess>& guess);
    void onOpened(const Result<study::OpenedLabelMap>& opened);
    void askWhatItIs();

    WindowContext context_;
    SegmentationKeeper& keeper_;
    QString path_;
    std::function<void()> openAsVolume_;
    BackgroundJob<study::LabelMapGuess> guessing_;
    BackgroundJob<study::OpenedLabelMap> opening_;
};

}  // namespace macula::viewer
