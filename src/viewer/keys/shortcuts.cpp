#include "viewer/keys/shortcuts.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMainWindow>
#include <QToolBar>

namespace macula::viewer {

QAction* actionFor(const QKeyEvent& keys, const QMainWindow& window, const QToolBar& tools) {
    const QKeySequence pressed(keys.keyCombination());
    for (QAction* action : window.findChildren<QAction*>()) {
        const bool isHidden = !tools.isVisible() && tools.actions().contains(action);
        if (!action->shortcut().isEmpty() && action->shortcut() == pressed && action->isEnabled() &&
            !isHidden)
            return action;
    }
    return nullptr;
}

bool isForList(const QKeyEvent& key) {
    const QWidget* focus = QApplication::focusWidget();
    const bool isList = qobject_cast<const QComboBox*>(focus) != nullptr ||
                        qobject_cast<const QAbstractItemView*>(focus) != nullptr;
    return isList && key.modifiers() == Qt::NoModifier && key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z;
}

}  // namespace macula::viewer
