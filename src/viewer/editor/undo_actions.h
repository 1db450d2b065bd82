// Undo and redo actions for menus and tool bars.
#pragma once

#include <QAction>
#include <QObject>

namespace macula::viewer {

class StudyEditor;
class UndoSteps;

// Their texts name the step; they are disabled without one.
class UndoActions : public QObject {
    Q_OBJECT

  public:
    // `session` outlives it.
    explicit UndoActions(StudyEditor& session, QObject* parent = nullptr);

    QAction& undo() { return *undo_; }
    QAction& redo() { return *redo_; }
    // Acts on `other` in place of the session, which stays as it is; null: on the session again. Call
    // update() when its steps change.
    void actOn(UndoSteps* other);
    void update();

  private:
    void step(bool isUndo);

    StudyEditor& session_;
    UndoSteps* other_ = nullptr;
    QAction* undo_;
    QAction* redo_;
};

}  // namespace macula::viewer
