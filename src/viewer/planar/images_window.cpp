#include "viewer/planar/images_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QGuiApplication>
#include <QScreen>
#include <QVBoxLayout>

namespace macula::viewer {

ImagesWindow::ImagesWindow(QWidget& content, QWidget& main) : content_(content) {
    setObjectName(QStringLiteral("images-window-of-its-own"));
    setAttribute(Qt::WA_QuitOnClose, false);  // the program ends with the main window
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(&content);
    // Shortcuts act in each window that has the action.
    for (const char* name : {"undo", "redo"})
        if (auto* action = main.findChild<QAction*>(QLatin1String(name))) addAction(action);
    resize(main.size());
    for (const QScreen* screen : QGuiApplication::screens())
        if (screen != main.screen()) {
            setGeometry(screen->availableGeometry());
            break;
        }
}

void ImagesWindow::giveBack() {
    layout()->removeWidget(&content_);
    content_.setParent(nullptr);
}

void ImagesWindow::closeEvent(QCloseEvent* event) {
    event->ignore();
    Q_EMIT closeAsked();
}

void ImagesWindow::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::ActivationChange) Q_EMIT activeChanged();
}

}  // namespace macula::viewer
