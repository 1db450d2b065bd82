// Movies of the open study: their panel, and the job that draws them.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <string>

#include "pictures/view_sequence.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"
#include "viewer/output/video_encoder.h"

class QDockWidget;
class QMenu;

namespace macula::viewer {

class MoviePanel;
class WorkBar;

struct MovieRequest {
    pictures::ViewSequence sequence;
    double picturesPerS = 25.0;
    bool wantsVideo = false;  // if there is an encoder
};

// Draws a turntable or a camera path to a folder in the background, and encodes it as a video. One at a time;
// a new one cancels the one before. Cancelling while drawing leaves no files; cancelling while encoding
// leaves the pictures. Lives on the UI thread, and so do its signals.
class MovieExport : public QObject {
    Q_OBJECT

  public:
    explicit MovieExport(std::string preferredDevice, QObject* parent = nullptr);

    void start(MovieRequest request);
    void cancel();
    bool running() const { return job_.running() || encoder_.running(); }

  Q_SIGNALS:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void written(const QString& told);  // sentences for a person
    void failed(const macula::Error& error);

  private:
    void onDrawn(const Result<pictures::WrittenSequence>& outcome);
    void finish(const QString& aboutVideo);

    std::string preferredDevice_;
    // These three are from the last request; only the job keeps its volume and names.
    QString folder_;
    double picturesPerS_ = 0.0;
    bool wantsVideo_ = false;
    QStringList told_;
    qint64 stageBeganMs_ = 0;
    BackgroundJob<pictures::WrittenSequence> job_;
    VideoEncoder encoder_;
};

// A movie shows what is on screen when a person asks for it. Lives on the UI thread.
class MoviesController : public QObject {
    Q_OBJECT

  public:
    explicit MoviesController(const WindowContext& context);

    QWidget* panel() const { return scrolled_; }
    void setDock(QDockWidget& dock);  // the panel's dock
    WorkBar* bar() const { return bar_; }
    void addActions(QMenu& file);

    QString unfinished() const;  // a sentence; empty: nothing is being written
    void cancel();
    void onStudyShown();

  Q_SIGNALS:
    void written();

  private:
    void askWhereToDraw();
    void askForPath();
    void askWhereToSavePath();

    WindowContext context_;
    MoviePanel* panel_;
    QWidget* scrolled_;
    QDockWidget* dock_ = nullptr;
    MovieExport* export_;
    WorkBar* bar_;
};

}  // namespace macula::viewer
