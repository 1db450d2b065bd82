// The panels of the window, in docks beside its panes.
#pragma once

#include <QAction>
#include <QList>
#include <QObject>
#include <QString>

class QDockWidget;
class QMainWindow;

namespace macula::viewer {

// The window outlives it. Lives on the UI thread.
class PanelsController : public QObject {
    Q_OBJECT

  public:
    explicit PanelsController(QMainWindow& window);

    // Adds a hidden dock for the panel. `name` is its object name; an empty key: none.
    QDockWidget* add(Qt::DockWidgetArea area, QWidget* panel, const QString& title, const char* name,
                     const QKeySequence& key = {});
    // Two docks that are seldom wanted at once share a place, but only once both are shown: earlier, the
    // window would make room for the hidden one.
    void sharePlace(QDockWidget* one, QDockWidget* other);

    const QList<QAction*>& actions() const { return actions_; }  // each shows and hides a panel

  private:
    void explainTabs();

    QMainWindow& window_;
    QList<QAction*> actions_;
};

}  // namespace macula::viewer
