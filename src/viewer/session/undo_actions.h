// Undo and redo of what was chosen for a study, for menus and tool bars.
#pragma once

#include <QAction>
#include <QObject>

namespace macula::viewer {

class ViewerSession;

// They say what they would undo, and can be used only where there is something.
class UndoActions : public QObject {
    Q_OBJECT

  public:
    // `session` outlives it.
    explicit UndoActions(ViewerSession& session, QObject* parent = nullptr);

    QAction& undo() { return *undo_; }
    QAction& redo() { return *redo_; }

  private:
    void update();

    ViewerSession& session_;
    QAction* undo_;
    QAction* redo_;
};

}  // namespace macula::viewer
