// Saves pictures of the 3D view.
#pragma once

#include <QObject>
#include <QString>

#include "viewer/context/window_context.h"

class QMenu;

namespace macula::viewer {

class PaneGrid;
class PictureDialog;
class PictureExport;
class SettingsController;
class WorkBar;

// A picture shows what is on screen when a person asks for it. Lives on the UI thread.
class PicturesController : public QObject {
    Q_OBJECT

  public:
    // Both live until the window's destructor.
    PicturesController(const WindowContext& context, const PaneGrid& panes,
                       const SettingsController& settings);

    WorkBar* bar() const { return bar_; }
    void addActions(QMenu& file);

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
};

}  // namespace macula::viewer
