// The lights of the window: the desk that edits them, and the list of built-in rigs.
#pragma once

#include <QObject>

#include "viewer/context/window_context.h"

class QComboBox;
class QDockWidget;
class QToolBar;

namespace macula::viewer {

class LightsDesk;

// Lives on the UI thread.
class LightsController : public QObject {
    Q_OBJECT

  public:
    explicit LightsController(const WindowContext& context);

    LightsDesk& desk() const { return *desk_; }
    void setDock(QDockWidget& dock);  // the dock of the desk's panel
    void addList(QToolBar& bar);

  private:
    void showChosen();  // selects the session's rig in the list

    WindowContext context_;
    LightsDesk* desk_;
    QComboBox* list_ = nullptr;
};

}  // namespace macula::viewer
