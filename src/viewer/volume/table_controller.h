// Shows progress and notes of the search for a CT's table, and reports voxels that cannot be hidden.
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
    // Cancels a search when `action`, such as Undo, is triggered: the search's end would revert the undo.
    void endAt(const QAction& action);

  private:
    TableRemoval& table_;
    WorkBar* bar_;
};

}  // namespace macula::viewer
