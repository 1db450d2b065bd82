// What the window writes for others: pictures.
#include <QFileDialog>
#include <QFileInfo>

#include "app/study/found_volumes.h"
#include "viewer/main_window.h"
#include "viewer/output/picture_dialog.h"

namespace macula::viewer {

namespace {

// One of those that the volume was made of.
std::optional<std::filesystem::path> imageOf(const app::OpenedStudy& study) {
    if (!study.found) return std::nullopt;
    const auto& frames = study.found->volumes().at(study.volumeIndex).stack->frames;
    return frames.empty() ? std::nullopt : std::optional(frames[frames.size() / 2].instance->file);
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
    auto* dialog = new PictureDialog(viewport_->pictureSize(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { askWhereToSavePicture(*dialog); });
    dialog->open();
}

void MainWindow::askWhereToSavePicture(const PictureDialog& how) {
    auto* dialog = new QFileDialog(
        this, tr("Save the picture"), lastFolder_,
        tr("Pictures (*.png);;Linear light and depth (*.exr);;DICOM Secondary Capture (*.dcm)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    dialog->selectFile(QStringLiteral("picture"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section(QLatin1String("*."), 1).chopped(1));
    });
    // What is on screen now: while a person looks for a folder another study may come.
    app::ViewPicture picture{.volume = study().volume,
                             .seriesDigest = study().seriesDigest,
                             .drawing = drawing(),
                             .camera = toCamera(viewport_->camera()),
                             .sizePx = {how.sizePx().width(), how.sizePx().height()},
                             .effort = {.quality = how.quality()},
                             .output = {},
                             .source = imageOf(study()),
                             .isDeidentified = how.isDeidentified()};
    ask(dialog, [this, picture = std::move(picture)](const QString& path) {
        app::ViewPicture wanted = picture;
        wanted.output = path.toStdString();
        export_->start(std::move(wanted));
    });
}

}  // namespace macula::viewer
