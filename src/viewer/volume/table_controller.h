// The search for the table of a CT: its progress and its notes; and voxels that cannot be hidden.
#pragma once

#include <QObject>

#include "viewer/context/window_context.h"

class QAction;

namespace macula::viewer {

class TableRemoval;
class WorkBar;

// Lives on the UI thread.
class TableController : public QObject {
    Q_OBJECT

  public:
    explicit TableController(const WindowContext& context);

    WorkBar* bar() const { return bar_; }
    QAction& action() const;
    // Ends a search when the action, such as Undo, is triggered: its end would undo the undoing.
    void endAt(const QAction& action);

  private:
    TableRemoval& table_;
    WorkBar* bar_;
};

}  // namespace macula::viewer
