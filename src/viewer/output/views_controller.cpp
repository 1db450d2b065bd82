#include "viewer/output/views_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <utility>

#include "base/atomic_file.h"
#include "scene/drawing/drawing_of.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"
#include "viewer/volume/state_controller.h"

namespace macula::viewer {

ViewsController::ViewsController(const WindowContext& context, StateController& states)
    : QObject(&context.window), context_(context), states_(states) {}

void ViewsController::addActions(QMenu& file) {
    QAction* open = file.addAction(tr("Open &View…"), this, &ViewsController::askForOne);
    open->setShortcut(keyOf(KeyAction::openView));
    open->setToolTip(tr("Show this study as it was when a view was saved"));
    open->setObjectName(QStringLiteral("open-view"));
    QAction* save = file.addAction(tr("&Save View…"), this, &ViewsController::askWhereToSave);
    save->setObjectName(QStringLiteral("save-view"));
    save->setShortcut(keyOf(KeyAction::saveView));
    save->setToolTip(tr("All that was chosen, and the camera, for another time"));
}

void ViewsController::askForOne() {
    auto* dialog = context_.files.toOpen(FolderKind::views, tr("Open a view"), tr("Views (*.json)"));
    context_.files.ask(dialog, FolderKind::views, [this](const QString& path) { open(path); });
}

void ViewsController::open(const QString& path) {
    context_.notifications.showOutcome([&]() -> Result<void> {
        MACULA_TRY(const scene::StudyState state, scene::readStudyState(path.toStdString()));
        return states_.setState(state);
    }());
}

void ViewsController::askWhereToSave() {
    if (!context_.notifications.refuseUnless(context_.session.hasStudy(),
                                             tr("There is no view to save yet.")))
        return;
    auto* dialog = context_.files.toSave(FolderKind::views, tr("Save the view"), tr("Views (*.json)"),
                                         QStringLiteral("json"), QStringLiteral("view.json"));
    scene::StudyState view = states_.state();
    view.grid = scene::savedGridOf(*context_.session.study().volume);
    context_.files.ask(dialog, FolderKind::views, [this, json = toJson(view)](const QString& path) {
        context_.notifications.showOutcome(writeTextAtomically(path.toStdString(), json));
    });
}

}  // namespace macula::viewer
