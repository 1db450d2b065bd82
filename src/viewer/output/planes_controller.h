// Saves planes like those of a pane as a DICOM series.
#pragma once

#include <QObject>
#include <QString>
#include <array>

#include "scene/slices/planes_file.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QMenu;

namespace macula::viewer {

class SettingsController;
class SliceView;
class WorkBar;

// Writes in the background, one batch at a time. Lives on the UI thread.
class PlanesController : public QObject {
    Q_OBJECT

  public:
    // All of them outlive it.
    PlanesController(const WindowContext& context, const std::array<SliceView*, 3>& panes,
                     const SettingsController& settings);

    void addAction(QMenu& file);
    WorkBar* bar() const { return bar_; }
    QString unfinished() const;  // a sentence; empty: nothing is being written
    void cancel();

  Q_SIGNALS:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void failed(const macula::Error& error);
    void written();

  private:
    void askOfActivePane();
    void ask(const SliceView& pane);
    void askWhereToSave(scene::PlaneBatchRequest request);
    void onEnded(const Result<scene::WrittenPlanes>& outcome);

    WindowContext context_;
    std::array<SliceView*, 3> panes_;
    const SettingsController& settings_;
    WorkBar* bar_;
    QString folder_;  // that is being written
    BackgroundJob<scene::WrittenPlanes> job_;
};

}  // namespace macula::viewer
