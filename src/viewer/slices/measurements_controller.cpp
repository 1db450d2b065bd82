#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/slices/measurements_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <exception>
#include <utility>

#include "base/exceptions.h"
#include "scene/slices/measurements_file.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/settings/save_object_dialog.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

MeasurementsController::MeasurementsController(const WindowContext& context)
    : QObject(&context.window),
      context_(context),
      saving_(this, {.ended = [this](const auto& leftOut) {
                  if (leftOut)
                      context_.notifications.showDone(tr("The measurements are written to %1.").arg(path_),
                                                      inWindowsLanguage(*leftOut));
                  else
                      context_.notifications.failUnlessCancelled(leftOut.error());
                  Q_EMIT written();
              }}) {}

void MeasurementsController::addFileActions(QMenu& file) {
    QAction* save = file.addAction(tr("Save &Measurements…"), this, &MeasurementsController::askWhereToSave);
    save->setShortcut(keyOf(KeyAction::saveMeasurements));
    describe(*save, "save-measurements",
             tr("As a table (CSV) or JSON, in mm, degrees and the unit of the study"));
    QAction* report =
        file.addAction(tr("Save Measurements as D&ICOM…"), this, &MeasurementsController::askHowToSaveReport);
    describe(*report, "save-measurement-report",
             tr("As a structured report, which archives keep and other programs show over the images"));
}

void MeasurementsController::addEditActions(QMenu& edit) {
    QAction* clear = edit.addAction(tr("Remove All &Measurements"), this, [this] {
        if (instead_.remove && instead_.remove()) return;
        context_.session.change(tr("Remove measurements"),
                                [](scene::StudyState& next) { next.measurements.clear(); });
    });
    clear->setObjectName(QStringLiteral("remove-measurements"));
}

void MeasurementsController::askWhereToSave() {
    if (instead_.save && instead_.save()) return;
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

Result<scene::ReportRequest> MeasurementsController::onScreen() const {
    const StudyEditor& session = context_.session;
    const auto refused = [](const QString& why, const QString& hint) {
        return Error{
            ErrorCode::usage, Text::verbatim(why.toStdString()), {}, Text::verbatim(hint.toStdString())};
    };
    if (session.state().measurements.empty())
        return refused(tr("There are no measurements to save."), tr("Measure something on a slice first."));
    const study::OpenedStudy& study = session.study();
    if (!study.volume || !study.found)
        return refused(tr("A report of measurements refers to DICOM images, and none are open."),
                       tr("Save the measurements as a table."));
    return scene::ReportRequest{.measurements = session.state().measurements,
                                .volume = study.measured(),
                                .found = study.found,
                                .volumeIndex = study.volumeIndex};
}

QString MeasurementsController::unfinished() const {
    return saving_.running() ? tr("Measurements are still being written.") : QString();
}

void MeasurementsController::askHowToSaveReport() {
    // Takes the present measurements: while a person answers, another study may open.
    const auto now = onScreen();
    if (!now) return context_.notifications.showError(now.error());
    context_.viewport.window().endDrag();
    auto* dialog = new SaveObjectDialog(
        {tr("Save Measurements as DICOM"),
         tr("A structured report for the archive: lengths, angles, areas and values with their places in the "
            "images. It says that nobody has verified it, and not who measured."),
         tr("Nothing of the patient is written, no label, and all UIDs are other ones.")},
        &context_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, request = *now]() mutable {
        request.isDeidentified = dialog->isDeidentified();
        askWhereToSaveReport(std::move(request));
    });
    dialog->open();
}

void MeasurementsController::askWhereToSaveReport(scene::ReportRequest request) {
    auto* dialog = context_.files.toSave(FolderKind::measurements, tr("Save the measurements"),
                                         tr("DICOM files (*.dcm)"), QStringLiteral("dcm"),
                                         QStringLiteral("measurements.dcm"));
    context_.files.ask(
        dialog, FolderKind::measurements, [this, request = std::move(request)](const QString& path) {
            path_ = path;
            saving_.start([path = path.toStdString(), request](Progress&) -> Result<std::vector<Text>> {
                try {
                    return scene::writeMeasurementReport(path, request);
                } catch (const std::exception& thrown) {
                    return errorOf(thrown, Text("write the measurements"));
                }
            });
        });
}

}  // namespace macula::viewer
