#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/volume/opening_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <utility>

#include "study/spool/spool.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"
#include "viewer/status/study_notes.h"
#include "viewer/volume/join_question.h"
#include "viewer/volume/state_controller.h"

namespace macula::viewer {

OpeningController::OpeningController(const WindowContext& context, StateController& states,
                                     std::shared_ptr<live::StudyKeeper> keeper)
    : QObject(&context.window), context_(context), states_(states), bar_(new WorkBar) {
    loader_.setKeeper(std::move(keeper));
    connect(&loader_, &StudyLoader::began, this, [this] {
        context_.notifications.hide();
        bar_->begin(tr("Opening"));
    });
    connect(&loader_, &StudyLoader::progressed, bar_, &WorkBar::setProgress);
    connect(bar_, &WorkBar::cancelClicked, &loader_, &StudyLoader::cancel);
}

void OpeningController::connectOutcomes() {
    connect(&loader_, &StudyLoader::loaded, this, [this](const study::OpenedStudy& study) {
        bar_->hide();
        Q_EMIT loaded(study);
    });
    connect(&loader_, &StudyLoader::askedToJoin, this, [this](const QString& path, const QString& question) {
        bar_->hide();
        context_.viewport.window().endDrag();
        askToJoin(&context_.window, question, [this, path] { loader_.open(path.toStdString(), true); });
    });
    connect(&loader_, &StudyLoader::failed, this, [this](const Error& error) {
        bar_->hide();
        if (error.code == ErrorCode::inputNotUsable && instead_ && instead_()) return;
        context_.notifications.fail(error, told(error));
    });
    connect(&loader_, &StudyLoader::cancelled, this, [this] {
        bar_->hide();
        Q_EMIT cancelled();
    });
}

// Stores the state first, because it may be the same study that is opened.
void OpeningController::open(study::StudySource source) {
    states_.keep();
    if (source && source->parent_path() != study::spoolFolder())
        context_.files.sawStudy(QString::fromStdString(source->string()));
    loader_.open(std::move(source));
}

void OpeningController::openFound(std::shared_ptr<const study::FoundVolumes> found, std::size_t index) {
    openPhase({.found = std::move(found)}, index);
}

void OpeningController::openPhase(study::PhaseSource source, std::size_t volume) {
    states_.keep();
    loader_.open(std::move(source), volume);
    context_.focusPicture();
}

void OpeningController::openDropped(const Dropped& what) {
    if (what.count == 1 && dropTaken_ && dropTaken_(what.path)) return;
    if (what.count == 1) return open(what.path.toStdString());
    showError({ErrorCode::usage,
               Text::verbatim(tr("Only one folder or file can be opened at a time.").toStdString()),
               {},
               Text::verbatim(tr("Drop one of them, or the folder that holds them all.").toStdString())});
}

void OpeningController::forgetNotes() {
    context_.notes.set(NoteOn::session, QString());
    if (!std::exchange(storeNoteIsNew_, false)) context_.notes.set(NoteOn::store, QString());
}

void OpeningController::tellOfStore(const Error& error) {
    storeNoteIsNew_ = !context_.session.hasStudy() || loader_.loading();
    context_.notes.set(NoteOn::store, inWindowsLanguage(error));
    context_.notes.show();
}

void OpeningController::addActions(QMenu& file) {
    QAction* openFolder = file.addAction(tr("&Open Folder…"), this, &OpeningController::askForFolder);
    openFolder->setShortcut(keyOf(KeyAction::openFolder));
    openFolder->setToolTip(tr("Open the best volume in a folder of DICOM files"));
    QAction* openFile = file.addAction(tr("Open &File…"), this, &OpeningController::askForFile);
    openFile->setShortcut(keyOf(KeyAction::openFile));
    openFile->setToolTip(
        tr("Open the series of an image, a DICOMDIR, a ZIP, tar or ISO 9660 file with studies, or a NIfTI, "
           "NRRD or "
           "MetaImage file"));
}

void OpeningController::addPhantomAction(QMenu& file) {
    QAction* phantom = file.addAction(tr("Open &Phantom"), this, [this] { open(std::nullopt); });
    phantom->setToolTip(tr("Open the built-in phantom study"));
}

void OpeningController::askForFolder() {
    auto* dialog = context_.files.toOpenFolder(FolderKind::studies, tr("Open a folder of DICOM files"));
    context_.files.ask(dialog, FolderKind::studies,
                       [this](const QString& path) { open(path.toStdString()); });
}

void OpeningController::askForFile() {
    auto* dialog =
        context_.files.toOpen(FolderKind::studies, tr("Open an image, a volume, or an archive of studies"));
    context_.files.ask(dialog, FolderKind::studies,
                       [this](const QString& path) { open(path.toStdString()); });
}

void OpeningController::showError(const Error& error) {
    context_.notifications.showError(told(error));
}

// Says which study is on screen, so that nobody takes it for the one that could not be opened.
Error OpeningController::told(Error error) const {
    if (!context_.session.hasStudy()) return error;
    const QString still = tr("What is on screen is still of the study that was open before.");
    error.hint = Text::joined({error.hint, Text::verbatim(still.toStdString())}, " ");
    return error;
}

}  // namespace macula::viewer
