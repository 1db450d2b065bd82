// Saves views and opens them again: everything that a person chose, with the camera.
#pragma once

#include <QObject>
#include <QString>

#include "viewer/context/window_context.h"

class QMenu;

namespace macula::viewer {

class StateController;

// Lives on the UI thread.
class ViewsController : public QObject {
    Q_OBJECT

  public:
    // `states` outlives it.
    ViewsController(const WindowContext& context, StateController& states);

    void addActions(QMenu& file);

  private:
    void askForOne();
    void open(const QString& path);
    void askWhereToSave();

    WindowContext context_;
    StateController& states_;
};

}  // namespace macula::viewer
