// Presentation states: the 3D view as a DICOM object, saved and opened again.
#include <QAction>
#include <QFileDialog>
#include <QMenu>
#include <utility>

#include "study/open/found_volumes.h"
#include "viewer/browser/study_browser.h"
#include "viewer/keys/keys.h"
#include "viewer/output/presentation_dialog.h"
#include "viewer/output/presentation_files.h"
#include "viewer/slices/slice_view.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

void MainWindow::addPresentationsTo(QMenu& file) {
    QAction* open = file.addAction(tr("Open Presen&tation State…"), this, &MainWindow::askForPresentation);
    open->setObjectName(QStringLiteral("open-presentation"));
    open->setToolTip(tr("Show this series as a DICOM presentation state says"));
    QAction* save =
        file.addAction(tr("Save Presentation State…"), this, &MainWindow::askHowToSavePresentation);
    save->setObjectName(QStringLiteral("save-presentation"));
    save->setShortcut(keyOf(KeyAction::savePresentation));
    save->setToolTip(tr("The 3D view as a DICOM object, for the archive and other programs"));

    presentations_ = new PresentationFiles(this);
    connect(presentations_, &PresentationFiles::saved, this,
            [this](const QString& path, const QStringList& notes) {
                QStringList told{tr("The presentation state is written to %1.").arg(path)};
                messages_->showNote((told + notes).join(QLatin1Char(' ')));
            });
    connect(presentations_, &PresentationFiles::opened, this,
            [this](const scene::StudyState& state, const QStringList& notes) {
                if (const Result<void> shown = setState(state); !shown) {
                    messages_->showError(shown.error());
                } else if (notes.isEmpty()) {
                    messages_->hide();
                } else {
                    messages_->showNote(notes.join(QLatin1Char(' ')));
                }
            });
    connect(presentations_, &PresentationFiles::openedOnSlices, this, &MainWindow::showOnSlices);
    connect(presentations_, &PresentationFiles::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
}

void MainWindow::askForPresentation() {
    if (!study().volume)
        return messages_->showError({ErrorCode::usage,
                                     tr("No study is open.").toStdString(),
                                     {},
                                     tr("Open the series of the presentation state first.").toStdString()});
    auto* dialog =
        new QFileDialog(this, tr("Open a presentation state"), folders_.of(FolderKind::presentations),
                        tr("DICOM files (*.dcm);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    ask(dialog, FolderKind::presentations,
        [this](const QString& path) { openPresentation(path.toStdString()); });
}

void MainWindow::openPresentation(const std::filesystem::path& path) {
    const study::OpenedStudy& shown = study();
    std::vector<dicom::ReferencedFrames> images;
    if (shown.found) images = study::imagesOf(*shown.found->volumes().at(shown.volumeIndex).stack);
    scene::StudyState usual = state();
    // It is of the 3D view, which may be hidden.
    if (usual.layout != scene::Layout::volume) usual.layout = scene::Layout::fourPanes;
    presentations_->open(path, shown.volume, shown.seriesDigest, std::move(images), std::move(usual),
                         viewport_->aspect());
}

// Those of the list of studies: their series is opened first, unless it is on screen.
void MainWindow::connectListedPresentations() {
    connect(browser_, &StudyBrowser::presentationChosen, this,
            [this](const study::StudyRow::Presentation& chosen) {
                const auto found = browser_->found();
                if (study().found == found && study().volumeIndex == chosen.volume && !loading())
                    return showListed(chosen);
                keepState();  // as in open()
                loader_.open(found, chosen.volume);
                awaiting_ = AwaitedPresentation{found, chosen};
                focusPicture();
            });
    connect(browser_, &StudyBrowser::presentationRefused, this, [this](const std::string& whyNot) {
        messages_->showError(
            {ErrorCode::inputNotUsable,
             whyNot,
             {},
             tr("Choose another one, or open the folder that its series is in.").toStdString()});
    });
    connect(&loader_, &StudyLoader::began, this, [this] { awaiting_.reset(); });
    connect(&loader_, &StudyLoader::cancelled, this, [this] { awaiting_.reset(); });
    connect(&loader_, &StudyLoader::failed, this, [this] { awaiting_.reset(); });
    connect(this, &MainWindow::studyShown, this, [this] {
        presentations_->cancelOpening();
        const auto awaited = std::exchange(awaiting_, {});
        if (awaited && awaited->found == study().found && awaited->listed.volume == study().volumeIndex)
            showListed(awaited->listed);
    });
}

void MainWindow::showListed(const study::StudyRow::Presentation& listed) {
    if (listed.isOfSlices) {
        presentations_->openOnSlices(listed.file, study(), session_.state().slices);
    } else {
        openPresentation(listed.file);
    }
}

// Zoom and place are of the pane, and no part of what can be undone.
void MainWindow::showOnSlices(const scene::SoftcopyOnSlices& shown, const QStringList& notes) {
    session_.change(tr("Presentation state"), [&](scene::StudyState& next) {
        next.slices = shown.slices;
        if (next.layout == scene::Layout::volume) next.layout = scene::Layout::fourPanes;
    });
    for (SliceView* pane : slices_) {
        if (shown.area && shown.area->orientation == pane->orientation()) {
            pane->showArea(*shown.area);
        } else {
            pane->fit();
        }
    }
    if (notes.isEmpty()) {
        messages_->hide();
    } else {
        messages_->showNote(notes.join(QLatin1Char(' ')));
    }
}

void MainWindow::askHowToSavePresentation() {
    if (!study().volume || !study().found)
        return messages_->showError(
            {ErrorCode::usage,
             tr("A presentation state refers to DICOM images, and none are open.").toStdString(),
             {},
             tr("Open a folder with DICOM files, or save the view.").toStdString()});
    // What is on screen now: while a person answers another study may come.
    const study::FoundVolume& shown = study().found->volumes().at(study().volumeIndex);
    auto images = scene::presentedImages(*shown.series, *shown.stack);
    if (!images) return messages_->showError(images.error());
    scene::PresentationRequest request;
    request.state = state();
    request.volume = study().volume;
    request.images = *std::move(images);
    const QSize size = viewport_->pictureSize();
    if (!size.isEmpty()) request.aspectWidthOverHeight = double(size.width()) / size.height();
    viewport_->window().endDrag();
    auto* dialog = new PresentationDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, request = std::move(request)]() mutable {
        request.isDeidentified = dialog->isDeidentified();
        askWhereToSavePresentation(std::move(request));
    });
    dialog->open();
}

void MainWindow::askWhereToSavePresentation(scene::PresentationRequest request) {
    auto* dialog = new QFileDialog(this, tr("Save the presentation state"),
                                   folders_.of(FolderKind::presentations), tr("DICOM files (*.dcm)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("dcm"));
    dialog->selectFile(QStringLiteral("presentation.dcm"));
    ask(dialog, FolderKind::presentations, [this, request = std::move(request)](const QString& path) {
        presentations_->save(path.toStdString(), request);
    });
}

}  // namespace macula::viewer
