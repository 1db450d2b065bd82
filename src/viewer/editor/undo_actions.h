// Undo and redo actions for menus and tool bars.
#pragma once

#include <QAction>
#include <QObject>

namespace macula::viewer {

class StudyEditor;

// Their texts name the step; they are disabled without one.
class UndoActions : public QObject {
    Q_OBJECT

  public:
    // `session` outlives it.
    explicit UndoActions(StudyEditor& session, QObject* parent = nullptr);

    QAction& undo() { return *undo_; }
    QAction& redo() { return *redo_; }

  private:
    void update();

    StudyEditor& session_;
    QAction* undo_;
    QAction* redo_;
};

}  // namespace macula::viewer
