// A menu with exclusive choices.
#pragma once

#include <QActionGroup>
#include <QMenu>
#include <QString>

namespace macula::viewer {

// Entries of a menu of which at most one is checked, numbered from 0 in the order they were added. The menu
// may hold other things too.
class ChoiceMenu : public QMenu {
    Q_OBJECT

  public:
    ChoiceMenu(const QString& title, QWidget* parent);

    // The first choice added is chosen. `name` is the action's object name, for tests and desktop scripts.
    QAction* addChoice(const QString& title, const QString& name);
    int chosen() const { return chosen_; }
    void choose(int index);  // does not emit changed; -1: none

  Q_SIGNALS:
    void changed(int index);  // only when a person chooses

  private:
    QActionGroup group_;
    int chosen_ = 0;
};

}  // namespace macula::viewer
