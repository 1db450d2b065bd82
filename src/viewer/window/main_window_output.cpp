// What the window writes for others: pictures.
#include <QFileDialog>
#include <QFileInfo>

#include "base/atomic_file.h"
#include "pipeline/volume/transfer_function_json.h"
#include "scene/slices/measurements_file.h"
#include "study/open/found_volumes.h"
#include "viewer/output/picture_dialog.h"
#include "viewer/output/picture_overlays.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

namespace {

// One of those that the volume was made of.
std::optional<dicom::SecondaryCapture::Source> imageOf(const study::OpenedStudy& study) {
    if (!study.found) return std::nullopt;
    const auto& frames = study.found->volumes().at(study.volumeIndex).stack->frames;
    if (frames.empty()) return std::nullopt;
    const dicom::Instance& image = *frames[frames.size() / 2].instance;
    return dicom::SecondaryCapture::Source{image.file, image.sopInstanceUid};
}

}  // namespace

void MainWindow::connectExport() {
    connect(export_, &PictureExport::began, this, [this] {
        messages_->hide();
        exporting_->begin(tr("Drawing the picture"));
    });
    connect(export_, &PictureExport::progressed, exporting_, &WorkBar::setProgress);
    connect(exporting_, &WorkBar::cancelClicked, export_, &PictureExport::cancel);
    connect(export_, &PictureExport::ended, exporting_, &QWidget::hide);
    connect(export_, &PictureExport::written, this, [this](const QString& path, const QStringList& notes) {
        QStringList told{tr("The picture is written to %1.").arg(path)};
        messages_->showNote((told + notes).join(QLatin1Char(' ')));
    });
    connect(export_, &PictureExport::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
}

void MainWindow::askForPicture() {
    if (!study().volume)
        return messages_->showError({ErrorCode::usage,
                                     tr("There is no picture to save yet.").toStdString(),
                                     {},
                                     tr("Open a study first.").toStdString()});
    viewport_->window().endDrag();
    const bool is3dShown = panes_->isShown(Pane::volume);
    // The window of a picture that is not shown has no size that means anything.
    auto* dialog = new PictureDialog(
        is3dShown ? viewport_->pictureSize() : panes_->size() * panes_->devicePixelRatioF(), this);
    if (!is3dShown) dialog->tellThat3dIsHidden();
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->beginWith(options_.settings.quality, options_.settings.deidentifies);
    dialog->offerEffectsOf(session_.state().settings.look);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { askWhereToSavePicture(*dialog); });
    dialog->open();
}

void MainWindow::askWhereToSavePicture(const PictureDialog& how) {
    auto* dialog = new QFileDialog(
        this, tr("Save the picture"), folders_.of(FolderKind::pictures),
        tr("Pictures (*.png);;Linear light and depth (*.exr);;DICOM Secondary Capture (*.dcm)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    dialog->selectFile(QStringLiteral("picture"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section(QLatin1String("*."), 1).chopped(1));
    });
    // What is on screen now: while a person looks for a folder another study may come.
    pictures::ViewPicture picture{.volume = study().volume,
                                  .seriesDigest = study().seriesDigest,
                                  .drawing = shown_->drawing(),
                                  .camera = toCamera(viewport_->camera()),
                                  .sizePx = {how.sizePx().width(), how.sizePx().height()},
                                  .effort = {.quality = how.quality()},
                                  .effects = how.effects(),
                                  .output = {},
                                  .source = imageOf(study()),
                                  .isOfNobody = study().identity.isOfNobody,
                                  .isDeidentified = how.isDeidentified()};
    if (how.hasOverlays())
        picture.stampsFor = [sizePx = picture.sizePx,
                             isCalibrated = picture.volume->provenance().isCalibrated](const Camera& camera) {
            return overlaysOf(camera, sizePx, isCalibrated);
        };
    ask(dialog, FolderKind::pictures, [this, picture = std::move(picture)](const QString& path) {
        pictures::ViewPicture wanted = picture;
        wanted.output = path.toStdString();
        export_->start(std::move(wanted));
    });
}

void MainWindow::tellOfFile(const Result<void>& written, const QString& told) {
    if (written) {
        messages_->showNote(told);
    } else {
        messages_->showError(written.error());
    }
}

void MainWindow::askWhereToSavePreset() {
    if (!session_.state().preset)
        return messages_->showError({ErrorCode::usage,
                                     tr("There is no preset to save yet.").toStdString(),
                                     {},
                                     tr("Open a study first.").toStdString()});
    auto* dialog = new QFileDialog(this, tr("Save the preset"), folders_.of(FolderKind::presets),
                                   tr("Presets (*.json)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    dialog->selectFile(QString::fromStdString(session_.state().preset->name) + QStringLiteral(".json"));
    ask(dialog, FolderKind::presets, [this, json = toJson(*session_.state().preset)](const QString& path) {
        tellOfFile(writeTextAtomically(path.toStdString(), json),
                   tr("The preset is written to %1. Open it with --preset %1.").arg(path));
    });
}

void MainWindow::askWhereToSaveMeasurements() {
    if (session_.state().measurements.empty())
        return messages_->showError({ErrorCode::usage,
                                     tr("There are no measurements to save.").toStdString(),
                                     {},
                                     tr("Measure something on a slice first.").toStdString()});
    auto* dialog = new QFileDialog(this, tr("Save the measurements"), folders_.of(FolderKind::measurements),
                                   tr("Table (*.csv);;JSON (*.json)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->selectFile(QStringLiteral("measurements"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section(QLatin1String("*."), 1).chopped(1));
    });
    // Those of now: while a person looks for a folder another study may come.
    ask(dialog, FolderKind::measurements,
        [this, measurements = session_.state().measurements, volume = study().measured(),
         numbers = study().imageNumbers](const QString& path) {
            tellOfFile(scene::writeMeasurements(path.toStdString(), measurements, {*volume, numbers}),
                       tr("The measurements are written to %1.").arg(path));
        });
}

}  // namespace macula::viewer
