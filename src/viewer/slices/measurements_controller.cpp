#include "viewer/slices/measurements_controller.h"

#include <QMainWindow>
#include <QMenu>

#include "scene/slices/measurements_file.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

MeasurementsController::MeasurementsController(const WindowContext& context)
    : QObject(&context.window), context_(context) {}

void MeasurementsController::addFileActions(QMenu& file) {
    QAction* save = file.addAction(tr("Save &Measurements…"), this, &MeasurementsController::askWhereToSave);
    save->setShortcut(keyOf(KeyAction::saveMeasurements));
    describe(*save, "save-measurements",
             tr("As a table (CSV) or JSON, in mm, degrees and the unit of the study"));
}

void MeasurementsController::addEditActions(QMenu& edit) {
    QAction* clear = edit.addAction(tr("Remove All &Measurements"), this, [this] {
        context_.session.change(tr("Remove measurements"),
                                [](scene::StudyState& next) { next.measurements.clear(); });
    });
    clear->setObjectName(QStringLiteral("remove-measurements"));
}

void MeasurementsController::askWhereToSave() {
    const StudyEditor& session = context_.session;
    if (session.state().measurements.empty())
        return context_.notifications.refuse(tr("There are no measurements to save."),
                                             tr("Measure something on a slice first."));
    auto* dialog = context_.files.toSave(FolderKind::measurements, tr("Save the measurements"),
                                         tr("Table (*.csv);;JSON (*.json)"), QStringLiteral("csv"),
                                         QStringLiteral("measurements"));
    FileDialogs::followFilter(*dialog);
    // Takes the present measurements: while a person looks for a folder, another study may open.
    context_.files.ask(
        dialog, FolderKind::measurements,
        [this, measurements = session.state().measurements, volume = session.study().measured(),
         numbers = session.study().imageNumbers](const QString& path) {
            context_.notifications.showOutcome(
                scene::writeMeasurements(path.toStdString(), measurements, {*volume, numbers}),
                tr("The measurements are written to %1.").arg(path));
        });
}

}  // namespace macula::viewer
