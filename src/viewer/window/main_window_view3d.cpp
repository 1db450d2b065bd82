// The view in 3D: its cube and scale, its projection, and what a hand in it does to the transfer function.
#include <QAction>
#include <QMenu>
#include <QStatusBar>

#include "viewer/keys/keys.h"
#include "viewer/transfer/transfer_drag.h"
#include "viewer/window/background_menu.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

// As the other keys of the menu, these are handled by the viewport.
void MainWindow::addView3dActions(QMenu& view) {
    const auto add = [&](const QString& title, KeyAction key, const char* name, const QString& about) {
        QAction* action = view.addAction(title + QLatin1Char('\t') + keyOf(key).toString());
        action->setObjectName(QLatin1String(name));
        action->setCheckable(true);
        action->setToolTip(about);
        return action;
    };
    QAction* marks =
        add(tr("Cube and scale"), KeyAction::marks, "cube-and-scale",
            tr("From where the patient is seen, and how long a centimetre is: with parallel rays "
               "everywhere, else at the depth of what the camera turns around"));
    QAction* parallel = add(tr("Parallel rays"), KeyAction::parallel, "parallel-rays",
                            tr("The same millimetres for each pixel at every depth"));
    const auto ask = [this](bool shown) {
        session_.change(tr("Cube and scale"), [shown](scene::StudyState& next) { next.showsMarks = shown; });
    };
    connect(marks, &QAction::triggered, this, ask);
    connect(viewport_, &Viewport::marksAsked, this, ask);
    const auto show = [this, marks] {
        marks->setChecked(session_.state().showsMarks);
        viewport_->showMarks(session_.state().showsMarks);
    };
    connect(&session_, &StudyEditor::changed, this, show);
    connect(&session_, &StudyEditor::studyShown, this, show);
    show();
    view.addMenu(new BackgroundMenu(session_, this));
    connect(parallel, &QAction::triggered, viewport_, &Viewport::setParallel);
    connect(viewport_, &Viewport::parallelChanged, parallel, &QAction::setChecked);

    auto* transfer = new TransferDrag(session_, *transfer_, this);
    connect(viewport_, &Viewport::transferDragged, transfer, &TransferDrag::drag);
    connect(&viewport_->window(), &VulkanWindow::dragEnded, transfer, &TransferDrag::end);
    connect(transfer, &TransferDrag::told, this,
            [this](const QString& what) { statusBar()->showMessage(what); });
}

}  // namespace macula::viewer
