#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/output/presentations_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <exception>
#include <new>
#include <utility>
#include <vector>

#include "viewer/browser/study_browser.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/slices/slice_view.h"
#include "viewer/status/notifications.h"
#include "viewer/volume/opening_controller.h"
#include "viewer/volume/state_controller.h"

namespace macula::viewer {

namespace {

Error tooLarge() {
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory for the presentation state."),
            {},
            Text("Close other programs.")};
}

// Hides the message of a library or file system, which may contain a path.
Error notWritten() {
    return {ErrorCode::outputNotWritable,
            Text("The presentation state could not be written."),
            {},
            Text("Choose another folder, and check free space and permissions.")};
}

Error notRead() {
    return {ErrorCode::inputNotUsable,
            Text("The presentation state could not be read."),
            {},
            Text("The file may be damaged; choose another one.")};
}

}  // namespace

PresentationFiles::PresentationFiles(QObject* parent)
    : QObject(parent),
      saving_(this, {.ended =
                         [this](const auto& leftOut) {
                             if (leftOut) {
                                 Q_EMIT saved(path_, inWindowsLanguage(*leftOut));
                             } else {
                                 Q_EMIT failed(leftOut.error());
                             }
                         }}),
      opening_(this, {.ended =
                          [this](const auto& presented) {
                              if (presented) {
                                  Q_EMIT opened(presented->state, inWindowsLanguage(presented->notes));
                              } else {
                                  Q_EMIT failed(presented.error());
                              }
                          }}),
      openingOnSlices_(this, {.ended = [this](const auto& shown) {
                           if (shown) {
                               Q_EMIT openedOnSlices(*shown, inWindowsLanguage(shown->notes));
                           } else {
                               Q_EMIT failed(shown.error());
                           }
                       }}) {}

void PresentationFiles::save(const std::filesystem::path& path, scene::PresentationRequest request) {
    path_ = QString::fromStdString(path.string());
    saving_.start([path, request = std::move(request)](Progress&) -> Result<std::vector<Text>> {
        try {
            return scene::writePresentation(path, request);
        } catch (const std::bad_alloc&) {
            return tooLarge();
        } catch (const std::exception&) {
            return notWritten();
        }
    });
}

void PresentationFiles::open(const std::filesystem::path& path, std::shared_ptr<const Volume> volume,
                             std::string seriesDigest, std::vector<dicom::ReferencedFrames> images,
                             scene::StudyState usual, double aspectWidthOverHeight) {
    openingOnSlices_.cancel();
    opening_.start([path, volume = std::move(volume), digest = std::move(seriesDigest),
                    images = std::move(images), usual = std::move(usual),
                    aspectWidthOverHeight](Progress&) -> Result<scene::PresentedState> {
        try {
            MACULA_TRY(scene::PresentedState presented,
                       scene::openPresentation(path, *volume, digest, images, usual));
            scene::widenFor(presented, aspectWidthOverHeight);
            return presented;
        } catch (const std::bad_alloc&) {
            return tooLarge();
        } catch (const std::exception&) {
            return notRead();
        }
    });
}

void PresentationFiles::openOnSlices(const std::filesystem::path& path, study::OpenedStudy study,
                                     scene::SliceState usual) {
    opening_.cancel();
    openingOnSlices_.start([path, study = std::move(study),
                            usual = std::move(usual)](Progress&) -> Result<scene::SoftcopyOnSlices> {
        try {
            return scene::openSoftcopy(path, study, usual);
        } catch (const std::bad_alloc&) {
            return tooLarge();
        } catch (const std::exception&) {
            return notRead();
        }
    });
}

void PresentationFiles::cancelOpening() {
    opening_.cancel();
    openingOnSlices_.cancel();
}

PresentationDialog::PresentationDialog(QWidget* parent)
    : SaveObjectDialog(
          {tr("Save Presentation State"),
           tr("A DICOM object without pixels, for the archive: camera, colours, clip and shading of the 3D "
              "view. Macula draws the same picture of it; other programs draw what they can."),
           tr("Nothing of the patient is written, and all UIDs are other ones. It can be opened where the "
              "series itself is.")},
          parent) {}

PresentationsController::PresentationsController(const WindowContext& context, const Uses& uses)
    : QObject(&context.window), context_(context), uses_(uses), files_(new PresentationFiles(this)) {
    connect(files_, &PresentationFiles::saved, this, [this](const QString& path, const QStringList& notes) {
        context_.notifications.showDone(tr("The presentation state is written to %1.").arg(path), notes);
        Q_EMIT written();
    });
    connect(files_, &PresentationFiles::opened, this,
            [this](const scene::StudyState& state, const QStringList& notes) {
                if (const Result<void> shown = uses_.states.setState(state); !shown)
                    return context_.notifications.showError(shown.error());
                context_.notifications.showNotesOf(notes);
            });
    connect(files_, &PresentationFiles::openedOnSlices, this, &PresentationsController::showOnSlices);
    connect(files_, &PresentationFiles::failed, this,
            [this](const Error& error) { context_.notifications.fail(error); });
    connectList();
}

const study::OpenedStudy& PresentationsController::study() const {
    return context_.session.study();
}

void PresentationsController::addActions(QMenu& file) {
    QAction* open =
        file.addAction(tr("Open Presen&tation State…"), this, &PresentationsController::askForOne);
    describe(*open, "open-presentation", tr("Show this series as a DICOM presentation state says"));
    QAction* save =
        file.addAction(tr("Save Presentation State…"), this, &PresentationsController::askHowToSave);
    save->setShortcut(keyOf(KeyAction::savePresentation));
    describe(*save, "save-presentation",
             tr("The 3D view as a DICOM object, for the archive and other programs"));
}

QString PresentationsController::unfinished() const {
    return files_->saving() ? tr("A presentation state is still being written.") : QString();
}

void PresentationsController::cancel() {
    files_->cancelSaving();
}

void PresentationsController::askForOne() {
    if (!study().volume)
        return context_.notifications.refuse(tr("No study is open."),
                                             tr("Open the series of the presentation state first."));
    auto* dialog = context_.files.toOpen(FolderKind::presentations, tr("Open a presentation state"),
                                         tr("DICOM files (*.dcm);;All files (*)"));
    context_.files.ask(dialog, FolderKind::presentations,
                       [this](const QString& path) { open(path.toStdString()); });
}

void PresentationsController::open(const std::filesystem::path& path) {
    const study::OpenedStudy& shown = study();
    std::vector<dicom::ReferencedFrames> images;
    if (shown.found) images = study::imagesOf(*shown.found->volumes().at(shown.volumeIndex).stack);
    scene::StudyState usual = uses_.states.state();
    // The file describes the 3D view, which may be hidden.
    if (usual.layout != scene::Layout::volume) usual.layout = scene::Layout::fourPanes;
    files_->open(path, shown.volume, shown.seriesDigest, std::move(images), std::move(usual),
                 context_.viewport.aspect());
}

// Shows presentation states from the study browser: opens their series first, unless it is on screen.
void PresentationsController::connectList() {
    connect(&uses_.browser, &StudyBrowser::presentationChosen, this,
            [this](const study::StudyRow::Presentation& chosen) {
                const auto found = uses_.browser.found();
                if (study().found == found && study().volumeIndex == chosen.volume &&
                    !uses_.opening.loader().loading())
                    return showListed(chosen);
                uses_.opening.openFound(found, chosen.volume);
                awaiting_ = Awaited{found, chosen};
            });
    connect(&uses_.browser, &StudyBrowser::presentationRefused, this, [this](const Text& whyNot) {
        context_.notifications.showError(
            {ErrorCode::inputNotUsable,
             whyNot,
             {},
             Text::verbatim(
                 tr("Choose another one, or open the folder that its series is in.").toStdString())});
    });
    const StudyLoader& loader = uses_.opening.loader();
    connect(&loader, &StudyLoader::began, this, [this] { awaiting_.reset(); });
    connect(&loader, &StudyLoader::cancelled, this, [this] { awaiting_.reset(); });
    connect(&loader, &StudyLoader::failed, this, [this] { awaiting_.reset(); });
}

void PresentationsController::onStudyShown() {
    files_->cancelOpening();
    const auto awaited = std::exchange(awaiting_, {});
    if (awaited && awaited->found == study().found && awaited->listed.volume == study().volumeIndex)
        showListed(awaited->listed);
}

void PresentationsController::showListed(const study::StudyRow::Presentation& listed) {
    if (listed.isOfSlices) {
        files_->openOnSlices(listed.file, study(), context_.session.state().slices);
    } else {
        open(listed.file);
    }
}

// Zoom and position belong to the pane, and cannot be undone.
void PresentationsController::showOnSlices(const scene::SoftcopyOnSlices& shown, const QStringList& notes) {
    context_.session.change(tr("Presentation state"), [&](scene::StudyState& next) {
        next.slices = shown.slices;
        if (next.layout == scene::Layout::volume) next.layout = scene::Layout::fourPanes;
    });
    for (SliceView* pane : uses_.slices) {
        if (shown.area && shown.area->orientation == pane->orientation()) {
            pane->showArea(*shown.area);
        } else {
            pane->fit();
        }
    }
    context_.notifications.showNotesOf(notes);
}

Result<scene::PresentationRequest> PresentationsController::onScreen() const {
    if (!study().volume || !study().found)
        return Error{ErrorCode::usage,
                     Text::verbatim(
                         tr("A presentation state refers to DICOM images, and none are open.").toStdString()),
                     {},
                     Text::verbatim(tr("Open a folder with DICOM files, or save the view.").toStdString())};
    const study::FoundVolume& shown = study().found->volumes().at(study().volumeIndex);
    scene::PresentationRequest request;
    MACULA_TRY(request.images, scene::presentedImages(*shown.series, *shown.stack));
    request.state = uses_.states.state();
    request.volume = study().volume;
    const QSize size = context_.viewport.pictureSize();
    if (!size.isEmpty()) request.aspectWidthOverHeight = double(size.width()) / size.height();
    return request;
}

void PresentationsController::askHowToSave() {
    // Takes what is on screen now: while a person answers, another study may open.
    const auto now = onScreen();
    if (!now) return context_.notifications.showError(now.error());
    context_.viewport.window().endDrag();
    auto* dialog = new PresentationDialog(&context_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, request = *now]() mutable {
        request.isDeidentified = dialog->isDeidentified();
        askWhereToSave(std::move(request));
    });
    dialog->open();
}

void PresentationsController::askWhereToSave(scene::PresentationRequest request) {
    auto* dialog = context_.files.toSave(FolderKind::presentations, tr("Save the presentation state"),
                                         tr("DICOM files (*.dcm)"), QStringLiteral("dcm"),
                                         QStringLiteral("presentation.dcm"));
    context_.files.ask(dialog, FolderKind::presentations,
                       [this, request = std::move(request)](const QString& path) {
                           files_->save(path.toStdString(), request);
                       });
}

}  // namespace macula::viewer
