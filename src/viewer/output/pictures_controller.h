// Saves pictures of the 3D view.
#pragma once

#include <QObject>
#include <QSize>
#include <QString>
#include <QStringList>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "pictures/view_picture.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QMenu;

namespace macula::viewer {

class PaneGrid;
class PictureDialog;
class SettingsController;
class WorkBar;

// Draws a picture to a file in the background. One at a time; a new one cancels the one before, which writes
// nothing. Lives on the UI thread, and so do its signals.
class PictureExport : public QObject {
    Q_OBJECT

  public:
    explicit PictureExport(std::string preferredDevice, QObject* parent = nullptr);

    void start(pictures::ViewPicture picture);
    void cancel();
    bool running() const { return job_.running(); }

  Q_SIGNALS:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void written(const QString& path, const QStringList& notes);
    void failed(const macula::Error& error);

  private:
    void onEnded(const Result<std::vector<Text>>& outcome);

    std::string preferredDevice_;
    QString path_;
    BackgroundJob<std::vector<Text>> job_;
};

// A picture shows what is on screen when a person asks for it. Lives on the UI thread.
class PicturesController : public QObject {
    Q_OBJECT

  public:
    // Both live until the window's destructor.
    PicturesController(const WindowContext& context, const PaneGrid& panes,
                       const SettingsController& settings);

    WorkBar* bar() const { return bar_; }
    void addActions(QMenu& file);
    // Called first when a person saves a picture; true: it saved another one, of what hides the panes.
    void setInstead(std::function<bool()> instead) { instead_ = std::move(instead); }

    // What is on screen now, at its size and the quality of the settings; without an output. Needs a study.
    pictures::ViewPicture onScreen() const;
    QSize screenPx() const;  // of the 3D view; of all panes where that is hidden
    bool is3dShown() const;
    // Cube, scale and letters, for the size that the picture has now.
    static void addOverlays(pictures::ViewPicture& picture);

    QString unfinished() const;  // a sentence; empty: nothing is being written
    void cancel();

  Q_SIGNALS:
    void written();

  private:
    void askHowToSave();
    void askWhereToSave(const PictureDialog& how);

    WindowContext context_;
    const PaneGrid& panes_;
    const SettingsController& settings_;
    PictureExport* export_;
    WorkBar* bar_;
    std::function<bool()> instead_;
};

}  // namespace macula::viewer
