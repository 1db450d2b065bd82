// Movies of the open study: their panel, and the job that draws them.
#pragma once

#include <QObject>
#include <QString>

#include "viewer/context/window_context.h"

class QDockWidget;
class QMenu;

namespace macula::viewer {

class MovieExport;
class MoviePanel;
class WorkBar;

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
