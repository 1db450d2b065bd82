#include "viewer/menus/choice_menu.h"

#include <QAction>

namespace macula::viewer {

ChoiceMenu::ChoiceMenu(const QString& title, QWidget* parent) : QMenu(title, parent), group_(this) {
    setToolTipsVisible(true);
    group_.setExclusive(true);
}

QAction* ChoiceMenu::addChoice(const QString& title, const QString& name) {
    const auto index = int(group_.actions().size());
    QAction* action = addAction(title);
    action->setObjectName(name);
    action->setCheckable(true);
    action->setChecked(index == chosen_);
    group_.addAction(action);
    connect(action, &QAction::triggered, this, [this, index] {
        if (index == chosen_) return;
        chosen_ = index;
        Q_EMIT changed(index);
    });
    return action;
}

void ChoiceMenu::choose(int index) {
    chosen_ = index;
    if (index >= 0)
        group_.actions().at(index)->setChecked(true);
    else if (QAction* before = group_.checkedAction())
        before->setChecked(false);
}

}  // namespace macula::viewer
