#include "viewer/panes/panels_controller.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QTabBar>
#include <utility>

namespace macula::viewer {

PanelsController::PanelsController(QMainWindow& window) : QObject(&window), window_(window) {}

QDockWidget* PanelsController::add(Qt::DockWidgetArea area, QWidget* panel, const QString& title,
                                   const char* name, const QKeySequence& key) {
    auto* dock = new QDockWidget(title, &window_);
    dock->setObjectName(QString::fromLatin1(name));
    dock->setWidget(panel);
    // Not floating: on some desktops, a floating panel keeps events from the volume's native window.
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    window_.addDockWidget(area, dock);
    dock->hide();
    if (!key.isEmpty()) dock->toggleViewAction()->setShortcut(key);
    actions_ << dock->toggleViewAction();
    return dock;
}

void PanelsController::sharePlace(QDockWidget* one, QDockWidget* other) {
    for (auto [asked, partner] : {std::pair(one, other), std::pair(other, one)}) {
        connect(asked->toggleViewAction(), &QAction::triggered, asked,
                [this, asked = asked, partner = partner](bool shown) {
                    if (!shown) return;
                    if (!partner->isHidden()) window_.tabifyDockWidget(partner, asked);
                    asked->raise();
                });
        connect(asked, &QDockWidget::visibilityChanged, this, &PanelsController::explainTabs,
                Qt::QueuedConnection);
    }
}

void PanelsController::explainTabs() {
    for (QTabBar* bar : window_.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
        bar->setToolTip(tr("Panels that share this place"));
}

}  // namespace macula::viewer
