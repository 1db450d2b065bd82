// What the actions Undo and Redo act on, where it is not the study.
#pragma once

#include <QString>

namespace macula::viewer {

class UndoSteps {
  public:
    virtual ~UndoSteps() = default;
    // What the next step changes; empty: there is none.
    virtual QString undoText() const = 0;
    virtual QString redoText() const = 0;
    virtual void undo() = 0;
    virtual void redo() = 0;

  protected:
    UndoSteps() = default;
    UndoSteps(const UndoSteps&) = default;
    UndoSteps& operator=(const UndoSteps&) = default;
};

}  // namespace macula::viewer
