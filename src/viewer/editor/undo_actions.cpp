#include "viewer/editor/undo_actions.h"

#include <QKeySequence>

#include "viewer/editor/study_editor.h"
#include "viewer/editor/undo_steps.h"

namespace macula::viewer {

namespace {

// "Undo Preset". In a menu an ampersand would mark a shortcut letter.
void tell(QAction& action, const QString& verb, const QString& tip, const QString& what, bool can) {
    const QString plain = QString(what).replace(QLatin1Char('&'), QStringLiteral("&&"));
    action.setText(can && !what.isEmpty() ? QStringLiteral("%1 %2").arg(verb, plain) : verb);
    action.setToolTip(can ? tip.arg(what) : QString());
    action.setEnabled(can);
}

}  // namespace

UndoActions::UndoActions(StudyEditor& session, QObject* parent)
    : QObject(parent), session_(session), undo_(new QAction(this)), redo_(new QAction(this)) {
    undo_->setObjectName(QStringLiteral("undo"));
    undo_->setShortcuts(QKeySequence::Undo);
    redo_->setObjectName(QStringLiteral("redo"));
    redo_->setShortcuts(QKeySequence::Redo);
    connect(undo_, &QAction::triggered, this, [this] { step(true); });
    connect(redo_, &QAction::triggered, this, [this] { step(false); });
    connect(&session_, &StudyEditor::changed, this, &UndoActions::update);
    connect(&session_, &StudyEditor::studyShown, this, &UndoActions::update);
    update();
}

void UndoActions::actOn(UndoSteps* other) {
    other_ = other;
    update();
}

void UndoActions::step(bool isUndo) {
    if (other_ != nullptr) return isUndo ? other_->undo() : other_->redo();
    return isUndo ? session_.undo() : session_.redo();
}

void UndoActions::update() {
    const QString undo = other_ != nullptr ? other_->undoText() : session_.undoText();
    const QString redo = other_ != nullptr ? other_->redoText() : session_.redoText();
    tell(*undo_, tr("&Undo"), tr("Take the last change back: %1"), undo,
         other_ != nullptr ? !undo.isEmpty() : session_.canUndo());
    tell(*redo_, tr("&Redo"), tr("Make it again: %1"), redo,
         other_ != nullptr ? !redo.isEmpty() : session_.canRedo());
}

}  // namespace macula::viewer
